// memory.h - memory for texts and tables, which are small: where the machine has none left, the
// program ends with status 1 and one line. Who asks for a large piece, as a picture is, asks the
// system, and can tell a person what to make smaller.
#ifndef MEMORY_H
#define MEMORY_H

#include <stddef.h>
#include <stdio.h>

// Everything here is freed by free().

// Zeros for count elements of a size in bytes, at least one byte.
void *memory_zeros(size_t count, size_t size);

// Make room in a row for one more than count: it is doubled whenever count is a power of two.
void *memory_row(void *row, int count, size_t size);

// The text that printf would print.
char *memory_text(const char *format, ...) __attribute__((format(printf, 1, 2)));

// The texts that name gives for 0 to count - 1 of something, with ", " between them.
char *memory_list(int count, const char *(*name)(const void *of, int i), const void *of);

// Gather a text: what is printed to the stream is in text once memory_close has closed it.
FILE *memory_open(char **text);
void memory_close(FILE *stream);

#endif
