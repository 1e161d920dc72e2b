// guard.h - what a graphics driver may do to the process that it works in.
#ifndef GUARD_H
#define GUARD_H

#include <stdbool.h>

// True when the stack is large enough for this program and for a driver's compiler; else reported.
bool guard_stack(void);

// Before a driver is opened: see to it that one that may start no threads does not wait for them,
// and that it does without its cache of shaders where the disk is full.
void guard_process(void);

// Before a driver is opened: have it compile every shader anew.
void guard_forget_caches(void);

// Until guard_end, a driver that crashes ends the program with status 1 and one line.
//   format  what could not be done and what to do, printf's, without a final newline
void guard_begin(const char *format, ...) __attribute__((format(printf, 1, 2)));
void guard_end(void);

// After guard_begin: until guard_end the driver may take 4 GB more than the process has. One that
// gets no more crashes, and that has its line; a machine that runs out of memory stands still. For
// drivers that take what they use: those of graphics cards reserve far more. Where the system does
// not say what the process has, nothing is limited.
void guard_memory(void);

#endif
