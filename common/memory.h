// memory.h - memory for small texts and tables. If the machine has none left, the program ends with
// status 1 and one line. Code that needs a large block, such as a picture, calls malloc itself, so
// that it can say what to make smaller.
#ifndef MEMORY_H
#define MEMORY_H

#include <stddef.h>
#include <stdio.h>

// The caller frees everything allocated here with free().

// Allocate zeros for count elements of size bytes each; for one element if count is 0.
void *memory_zeros(size_t count, size_t size);

// Make room in an array for one more than count elements. The array is reallocated, to about twice
// its size, if count is 0 or a power of two.
void *memory_row(void *row, int count, size_t size);

// Return the text that printf would print.
char *memory_text(const char *format, ...) __attribute__((format(printf, 1, 2)));

// Append to a text in a buffer of size bytes, cutting off what does not fit.
void memory_append(char *text, size_t size, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

// Return the texts that name returns for 0 to count - 1, with ", " between them.
char *memory_list(int count, const char *(*name)(const void *of, int i), const void *of);

// Open a stream into memory. memory_close stores the text that was printed to the stream in text.
FILE *memory_open(char **text);
void memory_close(FILE *stream);

#endif
