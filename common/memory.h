// memory.h - memory for texts and tables, which are small: if the machine has none left, the
// program ends with status 1 and one line. Code that needs a large block, such as a picture, calls
// malloc itself, and can say what to make smaller.
#ifndef MEMORY_H
#define MEMORY_H

#include <stddef.h>
#include <stdio.h>

// Everything here is freed by free().

// Zeros for count elements of a size in bytes, at least one byte.
void *memory_zeros(size_t count, size_t size);

// Make room in an array for one more than count elements: it doubles if count is a power of two.
void *memory_row(void *row, int count, size_t size);

// The text that printf would print.
char *memory_text(const char *format, ...) __attribute__((format(printf, 1, 2)));

// Print at the end of a text in a buffer of a size in bytes, as far as there is room.
void memory_append(char *text, size_t size, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

// The texts that name returns for 0 to count - 1, with ", " between them.
char *memory_list(int count, const char *(*name)(const void *of, int i), const void *of);

// Open a stream into memory: memory_close stores what was printed to it in text.
FILE *memory_open(char **text);
void memory_close(FILE *stream);

#endif
