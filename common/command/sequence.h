// sequence.h - a film as a sequence of pictures: their file names.
#ifndef SEQUENCE_H
#define SEQUENCE_H

#include <stdbool.h>
#include <stddef.h>

#define SEQUENCE_FRAMES_LIMIT 100000

// True if a name contains one conversion, %d or %0Wd with W from 1 to 9, and no other '%'.
bool sequence_is_name(const char *name);

// Make the file name of one picture.
//   name    a name for which sequence_is_name is true
//   number  the index of the picture, from 0
//   path    receives the name with the number instead of the conversion, at most size bytes
// Returns false after reporting the error if the new name is too long.
bool sequence_path(const char *name, int number, char *path, size_t size);

#endif
