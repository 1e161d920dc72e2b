// report.h - the one way in which this program reports a failure.
#ifndef REPORT_H
#define REPORT_H

#include <stdbool.h>

// Print one line on standard error: what could not be done, where, why, and what to do.
//   format   printf format without a final newline, e.g. "%s: cannot be read: %s"
// Control characters in the text are printed as '?', so that a hostile file name cannot break the
// line. Always returns false, for "return report(...);".
bool report(const char *format, ...) __attribute__((format(printf, 1, 2)));

// Begin every message of report() with a place and ": ", as in "my.txt:3: ", until the next call.
//   text  the place, which is copied, or NULL
void report_place(const char *text);

// As report(), for a text of several lines: a shader's errors with their source.
void report_lines(const char *text);

// The last message of report() or report_lines(), to show it elsewhere too: control characters are
// '?', lines end in '\n', a very long text is cut. "" before the first. Valid until the next
// report.
const char *report_last(void);

#endif
