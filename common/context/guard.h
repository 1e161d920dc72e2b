// guard.h - protection of the process from crashes of its graphics driver.
#ifndef GUARD_H
#define GUARD_H

// Call before opening a driver. The program then prints one line and ends with status 1 if the
// driver's shader cache, a file mapped into memory, can no longer be accessed because its disk is
// full, or if the driver crashes while the memory of the process is limited (ulimit -v).
void guard_process(void);

// Call before opening a driver. The driver then compiles every shader without its cache.
void guard_forget_caches(void);

// Between guard_begin and guard_end, if the driver crashes or aborts, the program prints one line
// and ends with status 1. If the memory of the process is limited, the line ends with
// memory_limit().
//   format  what failed and what to do, as a printf format without a final newline
void guard_begin(const char *format, ...) __attribute__((format(printf, 1, 2)));
void guard_end(void);

// Call between guard_begin and guard_end: limit the process to 4 GB more memory than it has now. A
// driver that exceeds the limit crashes, and the program prints one line and ends; without the
// limit, the machine could run out of memory and hang. The limit is only for software drivers,
// because the drivers of graphics cards reserve far more. If the system does not say how much
// memory the process has, there is no limit.
void guard_memory(void);

#endif
