// scratch.h - for tests: a folder of files that goes away, and what was said on standard
// error.
#ifndef TESTS_SCRATCH_H
#define TESTS_SCRATCH_H

#include <stddef.h>

// Make the folder; its path is resolved. scratch_remove deletes it with all that it holds.
// Each function here ends the test program when the machine refuses.
const char *scratch_make(void);
void scratch_remove(void);

// The same as setup and teardown of cmocka, for a group or a test.
int scratch_setup(void **unused);
int scratch_teardown(void **unused);

// The path of a name in the folder; valid until the eighth call after it.
const char *scratch_path(const char *name);

// Write a file in the folder, with the folders that lead to it. Returns its path, as scratch_path.
const char *scratch_write(const char *name, const char *text);
const char *scratch_write_bytes(const char *name, const void *bytes, size_t size);

// Collect standard error from here on; capture_end returns what was written since, valid until the
// next capture_end.
void capture_begin(void);
const char *capture_end(void);

// The number of lines of a text; a last line without an end counts.
int line_count(const char *text);

#endif
