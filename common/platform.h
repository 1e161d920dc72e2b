// platform.h - what each system does in its own way and C11 does not say: files, links, clocks, the
// environment, the console, crashes. platform/posix*.c or platform/windows*.c carries it out; no
// other file of common/ asks for a system's own header, and none asks which system it is on. A path
// is UTF-8, with '/' between its parts.
#ifndef PLATFORM_H
#define PLATFORM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <time.h>

#define PLATFORM_PATH 4096                  // bytes of the longest path, its end included
#define PLATFORM_WHY  (PLATFORM_PATH + 256) // of a phrase that may name a path

// ---- Files ----

// What is known of a file; all zeros when it is not there.
struct platform_file {
    bool regular;                // no folder, pipe or device
    long long size;              // bytes
    long long changed;           // when, in nanoseconds of the file system's clock
    unsigned long long place[2]; // which disk, which file of it: one put in its place has another
};

// Look at what a path leads to, links followed.
//   file  receives what is known
// Returns false, errno set, when there is nothing to be looked at.
bool platform_look(const char *path, struct platform_file *file);

// True when two paths led to one file, by whatever names.
bool platform_is_same(const struct platform_file *one, const struct platform_file *other);

// The absolute path of something that exists, without links, "." and "..", its letters capital or
// small as the disk has them, with / between folders.
// Returns memory that the caller frees, or NULL with errno set.
char *platform_resolve(const char *path);

// Open a file for reading its bytes. What is no regular file is never opened: a pipe would wait,
// and a device may act.
// Returns NULL, with errno set; errno is 0 for what is no regular file.
FILE *platform_open(const char *path);

// The file that a path means for writing.
//   target  receives it: links are followed, also one that leads nowhere yet
//   why     receives one phrase when no file could be written there: a folder, a device, a file or
//           a folder that is write-protected, too many links, ...
// Returns false then, not reported.
bool platform_target(const char *path, char target[PLATFORM_PATH], char why[PLATFORM_WHY]);

// Write data beside a target and put it in its place, so that a reader never sees half a file. A
// signal that ends the program waits until that is done.
//   target  from platform_target
//   size    bytes
// Returns 0 or an errno; then nothing is left behind, and what was there stands.
int platform_replace(const char *target, const char *data, size_t size);

// A stream into memory: what is written to it is in text, '\0' terminated, once it is closed.
//   text  receives memory that the caller frees
//   size  receives its bytes without the last one; both must live until the stream is closed
// Returns NULL when memory is short.
FILE *platform_open_text(char **text, size_t *size);

// Returns false when memory was short before all was written.
bool platform_close_text(FILE *stream);

// True when who read standard output as a pipe has gone: tries to write one byte more, for the
// reason why an earlier write failed may be forgotten. A signal may end the program before it can
// ask.
bool platform_reader_left(void);

// What an errno means, for the reader of a message: as strerror, in the words of this system.
const char *platform_why(int error);

// ---- The program and its surroundings ----

// The absolute path of this program's own file, without links. Returns false when nobody tells.
bool platform_program(char path[PLATFORM_PATH]);

// Set a variable of the environment for the libraries that read it later.
//   over  also where it is set already
void platform_set(const char *name, const char *value, bool over);

// Seconds of processor time that this program has taken, in all its threads.
double platform_processor_seconds(void);

// Seconds of a clock on the wall that is never put back; where it begins means nothing.
double platform_seconds(void);

// The date and time of day at this place.
// Returns the fraction of the second, from 0 to below 1.
double platform_date(struct tm *date);

// True when somebody reads the stream as it is written.
bool platform_is_terminal(FILE *stream);

// Where a window could be opened.
enum platform_display {
    PLATFORM_NO_DISPLAY,
    PLATFORM_OWN_DISPLAY, // the system has one kind, which is always there
    PLATFORM_X11,
    PLATFORM_WAYLAND // with or without X11 beside it
};

enum platform_display platform_display(void);

// ---- What may happen to the process ----

// From now on the program that crashes says these words and ends with status 1.
//   words  kept, with their line end; NULL: what was before holds again
// To be called with words and with NULL in turn.
void platform_watch_crash(const char *words);

// The same, for good, where a file in memory has lost its place on the disk.
void platform_watch_lost_page(const char *words);

// Bytes that the stack may take; SIZE_MAX where there is no limit.
size_t platform_stack(void);

// True when so many threads can work at the same time.
//   count  at most 64
bool platform_has_threads(int count);

// How many processors there are.
int platform_processors(void);

// Bytes that this program may still write to the disk of a folder; negative where nobody tells.
double platform_room(const char *folder);

// Let the process take so many bytes more than it has and no others; where the system does not say
// what it has, nothing is limited.
void platform_limit_memory(double more);

// What was before platform_limit_memory holds again; allowed without one.
void platform_free_memory(void);

#endif
