// scratch.h - for tests: a temporary folder of files, and the text written to standard error.
#ifndef TESTS_SCRATCH_H
#define TESTS_SCRATCH_H

#include <stddef.h>

// Make the folder, and return its resolved path. scratch_remove deletes the folder with everything
// in it. Each function of this header ends the test program if the system reports an error.
const char *scratch_make(void);
void scratch_remove(void);

// scratch_make and scratch_remove as cmocka's setup and teardown, for a group or a test.
int scratch_setup(void **unused);
int scratch_teardown(void **unused);

// The path of a name in the folder; valid until eight more paths have been returned.
const char *scratch_path(const char *name);

// Write a file in the folder, and create the folders on its path. Returns its path, like
// scratch_path.
const char *scratch_write(const char *name, const char *text);
const char *scratch_write_bytes(const char *name, const void *bytes, size_t size);

// Collect standard error from now on. capture_end returns the text written since then, valid until
// the next capture_end.
void capture_begin(void);
const char *capture_end(void);

// The number of lines of a text; a last line without a line break counts too.
int line_count(const char *text);

#endif
