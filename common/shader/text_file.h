// text_file.h - a text file in memory, with one kind of line end.
#ifndef TEXT_FILE_H
#define TEXT_FILE_H

#include <stdio.h>

#define TEXT_FILE_LIMIT (1024 * 1024) // bytes
#define TEXT_FILE_WHY   512           // size of the phrase, bytes

// Open a file of any kind for reading, unless it is a device, a folder or a pipe.
//   why  receives one phrase when it cannot be read
// Returns NULL then, not reported.
FILE *text_file_open(const char *path, char why[TEXT_FILE_WHY]);

// Read a text file. A byte-order mark and carriage returns are dropped, a missing line end at the
// end is added; '\0' terminated.
//   why  receives one phrase when it cannot be read: missing, a folder or a device, empty, a zero
//        byte in it, over the limit
// Returns memory that the caller frees, or NULL; not reported, for the caller knows who asked.
char *text_file_read(const char *path, char why[TEXT_FILE_WHY]);

#endif
