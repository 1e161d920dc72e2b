// text_file.h - reads a text file into memory, with one kind of line end.
#ifndef TEXT_FILE_H
#define TEXT_FILE_H

#include <stdio.h>

#define TEXT_FILE_LIMIT (1024 * 1024) // bytes
#define TEXT_FILE_WHY   512           // size of the text that says why a file cannot be read, bytes

// Open a regular file for reading.
//   why  receives one phrase if it cannot be read
// Returns NULL without reporting an error if it cannot be read.
FILE *text_file_open(const char *path, char why[TEXT_FILE_WHY]);

// Read a text file. Drops a byte-order mark and carriage returns, adds a missing line end at the
// end, and terminates the text with '\0'.
//   why  receives one phrase if it cannot be read: missing, not a regular file, empty, with a zero
//        byte, over the limit
// Returns memory that the caller frees, or NULL without reporting an error.
char *text_file_read(const char *path, char why[TEXT_FILE_WHY]);

#endif
