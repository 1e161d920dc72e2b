// sequence.h - a row of pictures: their file names, and how far along they are.
#ifndef SEQUENCE_H
#define SEQUENCE_H

#include <stdbool.h>
#include <stddef.h>

#define SEQUENCE_FRAMES_LIMIT 100000

// True when a name can be that of a row: one conversion, %d or %0Wd with W from 1 to 9, and no
// other
// '%'. Not reported.
bool sequence_is_name(const char *name);

// The name of one picture.
//   name    as sequence_is_name has it
//   number  from 0
//   path    receives the name with the number in place of the conversion, size bytes at most
// Returns false, reported, when it is too long.
bool sequence_path(const char *name, int number, char *path, size_t size);

// Say on standard error, where that is a terminal, how many pictures are done. The cursor stays at
// the beginning of the line, so that whatever is said next overwrites it; after the last one the
// line is cleared.
void sequence_progress(int done, int count);

#endif
