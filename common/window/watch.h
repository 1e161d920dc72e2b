// watch.h - notices when one of a set of files has changed and the writing is over.
#ifndef WATCH_H
#define WATCH_H

#include <stdbool.h>

#include "platform.h"

// One file.
struct watch_file {
    char *path;
    struct platform_file was; // when last looked at
};

// A set of files. One of zeros is empty.
struct watch {
    struct watch_file *file; // owned
    int count;
    bool pending; // a change was seen that has not been told yet
    int quiet;    // looks in a row that saw nothing new since
};

// Add a file, unless it is there already, as it is now.
void watch_add(struct watch *watch, const char *path);

// Look at every file once; to be called about ten times a second.
// Returns true once for a change: at the first look that sees nothing new, so that a file is not
// read while it is written. Where a file is missing or empty, which editors make it for a moment,
// several such looks are waited for.
bool watch_look(struct watch *watch);

// Forget the files that are not among these.
//   first, others, count   paths; first may be among the others
void watch_keep(struct watch *watch, const char *first, char *const *others, int count);

// Forget all files; also frees the memory.
void watch_clear(struct watch *watch);

#endif
