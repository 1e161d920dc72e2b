// windows.h - functions that the platform's files for Windows share.
#ifndef PLATFORM_WINDOWS_H
#define PLATFORM_WINDOWS_H

#include "platform.h"

// Write words to standard error without the C library, which a crash may have damaged.
void platform_message(const char *words);

// A console that was opened for this program closes when the program ends. In such a console, wait
// until the user presses Enter, so that an error can be read.
void platform_wait_for_reader(void);

#endif
