// platform.h - what systems do differently and C11 leaves out: files, links, clocks, environment,
// console, crashes. Only platform/posix*.c and platform/windows*.c include a system's headers or
// ask which system they are on. A path is UTF-8, with '/' between its parts.
#ifndef PLATFORM_H
#define PLATFORM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <time.h>

#define PLATFORM_PATH 4096                  // bytes of the longest path, including its end
#define PLATFORM_WHY  (PLATFORM_PATH + 256) // of a phrase that may contain a path

// ---- Files ----

// What is known about a file; all zeros if it does not exist.
struct platform_file {
    bool regular;                // not a folder, pipe or device
    long long size;              // bytes
    long long changed;           // when, in nanoseconds of the file system's clock
    unsigned long long place[2]; // its disk and its number there, which no other file has
};

// Describe the file at a path, following links.
// Returns false with errno set if there is none.
bool platform_look(const char *path, struct platform_file *file);

// True if both are the same file, whatever their names.
bool platform_is_same(const struct platform_file *one, const struct platform_file *other);

// The absolute path of an existing file or folder, without links, "." and "..", in the case that
// the disk has.
// Returns memory that the caller frees, or NULL with errno set.
char *platform_resolve(const char *path);

// Open a file for reading bytes. Only a regular file is opened, because a pipe would wait and a
// device may act. Returns NULL with errno set, to 0 if the file is not regular.
FILE *platform_open(const char *path);

// The file that is written for a path.
//   target  receives it: links are followed, including those to missing files
//   why     receives one phrase if no file could be written there: a folder, a device, a
//           write-protected file or folder, too many links, ...
// Returns false without reporting an error if no file could be written.
bool platform_target(const char *path, char target[PLATFORM_PATH], char why[PLATFORM_WHY]);

// Write data into a new file beside a target and rename it to the target, so that no reader sees
// half a file. A signal that ends the program waits until that is done.
//   target  from platform_target
//   size    bytes
// Returns 0, or an errno; then no new file is left, and the old one is unchanged.
int platform_replace(const char *target, const char *data, size_t size);

// Open a stream into memory. Once it is closed, text has what was written to it, with '\0' at the
// end.
//   text  receives memory that the caller frees
//   size  receives its bytes without the last one; both must live until the stream is closed
// Returns NULL if memory is short.
FILE *platform_open_text(char **text, size_t *size);

// Returns false if memory was short before all was written.
bool platform_close_text(FILE *stream);

// True if the process that reads standard output as a pipe has ended. It tries to write one byte
// more, because the reason of an earlier failure may be lost. A signal may end the program first.
bool platform_reader_left(void);

// What an errno means, in the words of this system, as strerror returns them.
const char *platform_why(int error);

// ---- The program and its environment ----

// The absolute path of this program's own file, without links. Returns false if it is unknown.
bool platform_program(char path[PLATFORM_PATH]);

// Set a variable of the environment for libraries that read it later.
//   over  replaces an existing value
void platform_set(const char *name, const char *value, bool over);

// Seconds of processor time that this program has used, in all its threads.
double platform_processor_seconds(void);

// Seconds of a clock that is never set back; its zero is arbitrary.
double platform_seconds(void);

// The local date and time of day.
// Returns the fraction of the second, from 0 to below 1.
double platform_date(struct tm *date);

// True if the stream is a terminal.
bool platform_is_terminal(FILE *stream);

// Where a window could be opened.
enum platform_display {
    PLATFORM_NO_DISPLAY,
    PLATFORM_OWN_DISPLAY, // the system's only kind, which always exists
    PLATFORM_X11,
    PLATFORM_WAYLAND // with or without X11
};

enum platform_display platform_display(void);

// ---- Crashes and memory ----

// From now on, if the program crashes, it prints these words and ends with status 1.
//   words  kept, with their line end; NULL restores the earlier behaviour
// Call it with words and with NULL in turn.
void platform_watch_crash(const char *words);

// Do the same, for good, if a file that is mapped into memory loses its disk.
void platform_watch_lost_page(const char *words);

// Do the same, for good, if the memory of the process is limited (ulimit -v), because a driver that
// gets none crashes.
void platform_watch_short_memory(const char *words);

// Limit the process to this many bytes more than it has; no limit if the system does not say how
// much it has.
void platform_limit_memory(double more);

// Lift the limit of platform_limit_memory; allowed without one.
void platform_free_memory(void);

#endif
