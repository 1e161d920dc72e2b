// text_file.h - reads a text file into memory, and makes its line ends uniform.
#ifndef TEXT_FILE_H
#define TEXT_FILE_H

#include <stdio.h>

#define TEXT_FILE_LIMIT (1024 * 1024) // maximum size of a file, in bytes
#define TEXT_FILE_WHY   512           // size of the reason why a file cannot be read, in bytes

// Open a regular file for reading.
//   why  receives the reason on failure, as a phrase
// Returns the file, or NULL without reporting an error.
FILE *text_file_open(const char *path, char why[TEXT_FILE_WHY]);

// Read a text file. Drop a byte-order mark, turn every line end into '\n', add a line end if the
// last line has none, and terminate the text with '\0'.
//   why  receives the reason on failure, as a phrase: the file is missing or unreadable, is not a
//        regular file, is empty, contains a zero byte or exceeds TEXT_FILE_LIMIT
// Returns memory that the caller frees, or NULL without reporting an error.
char *text_file_read(const char *path, char why[TEXT_FILE_WHY]);

#endif
