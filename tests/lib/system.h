// system.h - what tests do to files that no program does: support_system_posix.c, and
// support_system_windows.c where the tests are built for Windows.
#ifndef TESTS_SYSTEM_H
#define TESTS_SYSTEM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "platform.h"

// Make a folder with a name that nothing has, where this machine keeps what is thrown away.
//   path  receives it, resolved
bool system_make_scratch(char path[PLATFORM_PATH]);

bool system_make_folder(const char *path);

// An empty file to write and read, gone when it is closed; the test ends where none can be made.
FILE *system_open_scratch(void);

// Remove a folder with all that it holds.
bool system_remove_folder(const char *path);

// How many files this process has open; two calls give the same count unless a file was left open
// in between. Where the system has no /proc/self/fd it prints so and returns -1.
int system_open_files(void);

// Run one of the programs built with the tests, with a line of arguments, and read what it prints,
// errors too.
//   text  receives the first size - 1 bytes of it
// Returns its exit status; the test ends where it cannot be started.
int system_run(const char *program, const char *arguments, char *text, size_t size);

// Make a symbolic link, or a named pipe; the test ends where that fails.
// Returns false on a system that has none for everybody: nothing of them can be tested there.
bool system_make_link(const char *to, const char *path);
bool system_make_pipe(const char *path);

#endif
