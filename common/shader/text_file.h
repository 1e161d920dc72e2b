// text_file.h - reads a text file into memory, with one kind of line end.
#ifndef TEXT_FILE_H
#define TEXT_FILE_H

#include <stdio.h>

#define TEXT_FILE_LIMIT (1024 * 1024) // largest file, bytes
#define TEXT_FILE_WHY   512           // bytes of the text that says why a file cannot be read

// Open a regular file for reading.
//   why  receives one phrase if the file cannot be opened
// Returns NULL without reporting an error in that case.
FILE *text_file_open(const char *path, char why[TEXT_FILE_WHY]);

// Read a text file. Drops a byte-order mark, makes every line end '\n', adds a line end if the last
// line has none, and terminates the text with '\0'.
//   why  receives one phrase on failure: the file is missing, is not a regular file, is empty,
//        contains a zero byte or exceeds TEXT_FILE_LIMIT
// Returns memory that the caller frees, or NULL without reporting an error.
char *text_file_read(const char *path, char why[TEXT_FILE_WHY]);

#endif
