// guard.h - protection of the process from its graphics driver.
#ifndef GUARD_H
#define GUARD_H

// Call before a driver is opened: if its shader cache, a file mapped into memory, loses its disk,
// the program ends with status 1 and one line. So does a driver that crashes where the memory of
// the process is limited.
void guard_process(void);

// Call before a driver is opened: it compiles every shader, without its cache.
void guard_forget_caches(void);

// From guard_begin to guard_end, a driver that crashes ends the program with status 1 and one line.
//   format  as printf's, without a final newline: what failed and what to do
void guard_begin(const char *format, ...) __attribute__((format(printf, 1, 2)));
void guard_end(void);

// Between guard_begin and guard_end: limit the driver to 4 GB more than the process has. A driver
// that runs into the limit crashes with one line, whereas a machine without memory hangs. Only for
// software drivers: those of graphics cards reserve far more. If the system does not say how much
// memory the process has, there is no limit.
void guard_memory(void);

#endif
