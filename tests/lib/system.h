// system.h - operations of the system that only tests need, in system_posix.c or, if the tests are
// built for Windows, in system_windows.c.
#ifndef TESTS_SYSTEM_H
#define TESTS_SYSTEM_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "platform.h"

// Make a folder with an unused name in this machine's folder for temporary files.
//   path  receives the resolved path of the folder
bool system_make_scratch(char path[PLATFORM_PATH]);

bool system_make_folder(const char *path);

// Open an empty file to write and read, which is deleted when it is closed. Ends the test program
// if no such file can be made.
FILE *system_open_scratch(void);

// Remove a folder with everything in it.
bool system_remove_folder(const char *path);

// The number of files that this process has open, without those of the driver's cache of compiled
// shaders; two calls give the same number unless a file was left open in between. If the system has
// no /proc/self/fd, says so and returns -1.
int system_open_files(void);

// Run one of the programs built with the tests, with a line of arguments, and read its output and
// errors.
//   text  receives the first size - 1 bytes of the output and errors
// Returns the exit status of the program. Ends the test program if that program cannot be started.
int system_run(const char *program, const char *arguments, char *text, size_t size);

// Make a symbolic link, or a named pipe. Ends the test program if that fails. Returns false on a
// system where ordinary users cannot make links or pipes, which therefore cannot be tested.
bool system_make_link(const char *to, const char *path);
bool system_make_pipe(const char *path);

#endif
