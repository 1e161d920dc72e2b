// memory.h - memory for strings and small tables. If no memory is left, the program prints one line
// and ends with status 1. Code that needs a large block, such as a picture, calls malloc itself, so
// that its error message can say what to make smaller.
#ifndef MEMORY_H
#define MEMORY_H

#include <stddef.h>
#include <stdio.h>

// The caller frees all memory from these functions with free().

// Allocate zeroed memory for count elements of size bytes each, or for one element if count is 0.
void *memory_zeros(size_t count, size_t size);

// Make room for one more element in an array of count elements. If count is 0 or a power of two,
// the array is reallocated to about twice its size. Returns the array.
void *memory_row(void *row, int count, size_t size);

// Return a phrase for the end of a message if the memory of the process is limited, because the
// limit may be the reason why something failed: "; this process may use only 250 MB of memory:
// raise the limit (ulimit -v)". Without a limit, returns "".
const char *memory_limit(void);

// Return the text that printf would print.
char *memory_text(const char *format, ...) __attribute__((format(printf, 1, 2)));

// Append formatted text to the string in a buffer of size bytes. The result is cut off at the
// buffer's end.
void memory_append(char *text, size_t size, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

// Return the strings that name(of, i) returns for i from 0 to count - 1, with ", " between them.
char *memory_list(int count, const char *(*name)(const void *of, int i), const void *of);

// Open a stream into memory, and close it. memory_close stores the printed text in *text.
FILE *memory_open(char **text);
void memory_close(FILE *stream);

#endif
