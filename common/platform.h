// platform.h - functions that C11 lacks and systems provide differently: files, links, clocks,
// environment, console, crashes. Only platform/posix*.c and platform/windows*.c include a system's
// headers or test for an operating system, except that context/osmesa.c includes <dlfcn.h>. A path
// is UTF-8, with '/' between its parts.
#ifndef PLATFORM_H
#define PLATFORM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <time.h>

#define PLATFORM_PATH 4096                  // bytes of the longest path, including the '\0'
#define PLATFORM_WHY  (PLATFORM_PATH + 256) // bytes of a phrase that may contain a path

// ---- Files ----

// The properties of a file; all are 0 if the file does not exist.
struct platform_file {
    bool regular;                   // not a folder, pipe or device
    long long size;                 // bytes
    long long changed;              // time of the last change, nanoseconds since 1970
    unsigned long long identity[2]; // its disk and its number on that disk, which identify it
};

// Describe the file at a path, following links.
// Returns false with errno set if there is no file.
bool platform_look(const char *path, struct platform_file *file);

// True if both structs describe the same file, whatever paths were given.
bool platform_is_same(const struct platform_file *one, const struct platform_file *other);

// Return the absolute path of an existing file or folder, without links, "." and "..", in upper and
// lower case as on the disk. The caller frees the path. Returns NULL with errno set on failure.
char *platform_resolve(const char *path);

// Open a file for reading bytes. Only a regular file is opened, because opening a pipe may block
// and opening a device may have effects. On failure, returns NULL with errno set; errno is 0 if the
// file is not regular.
FILE *platform_open(const char *path);

// Find the file that writing to a path would replace or create.
//   target  receives the file's path: links are followed, including those to missing files
//   why     receives one phrase if no file could be written there: a folder, a device, a
//           write-protected file or folder, too many links, ...
// Returns false without reporting an error if no file could be written.
bool platform_target(const char *path, char target[PLATFORM_PATH], char why[PLATFORM_WHY]);

// Write data into a new file beside a target and rename it to the target, so that no reader sees
// half a file. A signal that ends the program waits until the file is renamed.
//   target  from platform_target
//   size    bytes of data
// Returns 0 or an errno. After an error, no new file is left, and the old one is unchanged.
int platform_replace(const char *target, const char *data, size_t size);

// Open a stream into memory. When the stream is closed, *text receives the written text, with '\0'
// at the end.
//   text  receives memory that the caller frees
//   size  receives the length of the text in bytes without the '\0'
// Both variables must live until the stream is closed. Returns NULL if the stream cannot be opened.
FILE *platform_open_text(char **text, size_t *size);

// Close a stream that platform_open_text opened. Returns false if part of the text was lost.
bool platform_close_text(FILE *stream);

// True if the process that reads standard output through a pipe has closed it. The function tries
// to write one more byte, because the reason for an earlier failure may be lost. SIGPIPE may end
// the program first.
bool platform_reader_left(void);

// From now on, a write to a pipe whose reader has exited fails, instead of ending the program.
void platform_outlive_reader(void);

// Return the meaning of an errno in the words of this system, as strerror does.
const char *platform_why(int error);

// ---- The program and its environment ----

// Find the absolute path of this program's executable, without links. Returns false if the path is
// unknown.
bool platform_program(char path[PLATFORM_PATH]);

// Set an environment variable for libraries that read it later.
//   over  whether to replace an existing value
void platform_set(const char *name, const char *value, bool over);

// Return the seconds of processor time that this program has used in all its threads.
double platform_processor_seconds(void);

// Return the seconds of a clock that is never set back and whose zero is arbitrary.
double platform_seconds(void);

// Read the local date and time of day.
// Returns the fraction of the second, in [0, 1).
double platform_date(struct tm *date);

// True if the stream is a terminal.
bool platform_is_terminal(FILE *stream);

// The displays on which a window could be opened.
enum platform_display {
    PLATFORM_NO_DISPLAY,
    PLATFORM_OWN_DISPLAY, // the only kind that the system has; it always exists
    PLATFORM_X11,
    PLATFORM_WAYLAND // with or without X11
};

enum platform_display platform_display(void);

// From now on, if an X server refuses a request or goes away, call a function that ends the
// program. Otherwise, Xlib would print lines of its own. Call this after a window has been opened
// on PLATFORM_X11. Elsewhere, it does nothing.
//   lost  receives what happened, as the end of a sentence whose subject is the display
void platform_watch_display(void (*lost)(const char *what));

// Open a file in the user's editor, $VISUAL or $EDITOR, or in the program that the system uses for
// it, and do not wait. Returns false if there is none, or if no program can be started here.
bool platform_edit(const char *path);

// ---- Crashes and memory ----

// From now on, if the program crashes or aborts, it prints these words and ends with status 1.
//   words  not copied, with a final newline; NULL restores the behaviour before the first call
void platform_watch_crash(const char *words);

// Do the same, permanently, if a file that is mapped into memory can no longer be accessed, for
// example because its disk is full.
void platform_watch_lost_page(const char *words);

// Return how many bytes of memory the process may use, apart from platform_limit_memory, or
// HUGE_VAL if there is no limit.
//   option  receives the option of the shell's ulimit that sets the limit, such as 'v'
double platform_memory_limit(char *option);

// Limit the process to this many bytes of memory more than it has now. There is no limit if the
// system does not say how much memory the process has.
void platform_limit_memory(double more);

// Lift the limit of platform_limit_memory, if there is one.
void platform_free_memory(void);

#endif
