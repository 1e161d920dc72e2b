// report.h - the one way in which this program reports a failure.
#ifndef REPORT_H
#define REPORT_H

#include <stdbool.h>

// Print one line on standard error: what could not be done, where, why, and what to do.
//   format   printf format without a final newline, e.g. "%s: cannot be read: %s"
// Control characters in the text are printed as '?', so that a hostile file name cannot break the
// line. Always returns false, for "return report(...);".
bool report(const char *format, ...) __attribute__((format(printf, 1, 2)));

// Begin every message of report() with a location in a file and ": ", as in "my.txt:3: ", until the
// next call of this function.
//   text  the location, which is copied; NULL for none
void report_location(const char *text);

// Print several lines of text, such as a shader's errors with their source, on standard error.
// Control characters other than newlines and tabs are printed as '?'.
void report_lines(const char *text);

// Return the last message of report() or report_lines(), so that it can also be shown elsewhere.
// Control characters are replaced with '?', lines end in '\n', and text beyond 8 KiB is cut off.
// Returns "" before the first message. The string is valid until the next message.
const char *report_last(void);

#endif
