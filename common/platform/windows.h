// windows.h - what the files of the platform say to each other on Windows.
#ifndef PLATFORM_WINDOWS_H
#define PLATFORM_WINDOWS_H

#include "platform.h"

// Write words to standard error, with nothing of the C library, which may have come to harm.
void platform_say(const char *words);

// A console that was opened for this program goes with it: there wait until whoever reads an error
// presses Enter.
void platform_wait_for_reader(void);

#endif
