// watch.h - notices when one of a set of files has been changed and completely written.
#ifndef WATCH_H
#define WATCH_H

#include <stdbool.h>

#include "platform.h"

struct watch_file {
    char *path;
    struct platform_file was; // the file's state at the last look
    bool changed;             // a change has not been reported yet
    bool kept;                // added since watch_begin
};

// A set of files. A zero-initialised struct is an empty set.
struct watch {
    struct watch_file *file; // owned
    int count;
    bool pending; // a change has not been reported yet
    int quiet;    // number of consecutive looks that found no new change
};

// Add a file in its current state, unless the set already contains it.
void watch_add(struct watch *watch, const char *path);

// Look at every file once. Call this about ten times per second.
// Returns true once per change: at the first look that finds no further change, so that a file is
// not read while it is being written. A file that is missing or empty, as some editors leave it
// briefly while saving, delays the report by a few looks, but does not delay the report of a later
// change of another file.
bool watch_look(struct watch *watch);

// Replace the set: after watch_begin, add the new files; watch_end removes all others.
void watch_begin(struct watch *watch);
void watch_end(struct watch *watch);

// Remove all files and free the memory.
void watch_clear(struct watch *watch);

#endif
