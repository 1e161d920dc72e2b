// report.h - the one way from names, values and shaders to a terminal: failures on standard error,
// and results on standard output.
//
// A terminal could interpret a character instead of showing it, and bytes that are not UTF-8 may
// confuse it. So each control character, line separator, character that reverses the order of
// others, and piece of invalid UTF-8 is printed as '?'.
#ifndef REPORT_H
#define REPORT_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

// Print one line on standard error: what could not be done, where, why, and what to do.
//   format   printf format without a final newline, e.g. "%s: cannot be read: %s"
// The middle of a word longer than 240 bytes, such as a path, is replaced with "...", as is that of
// a line longer than 1600 bytes. Always returns false, for "return report(...);".
bool report(const char *format, ...) __attribute__((format(printf, 1, 2)));

// Begin every message of report() with a location in a file and ": ", as in "my.txt:3: ", until the
// next call of this function.
//   text  the location, which is copied; NULL for none
void report_location(const char *text);

// Print several lines of text, such as a shader's errors with their source, on standard error.
// Newlines and tabs remain, and each line is shortened as report() shortens its line.
void report_lines(const char *lines);

// Return the last message of report() or report_lines(), as it was printed, so that it can also be
// shown elsewhere; text beyond 8 KiB is cut off. Returns "" before the first message. The string is
// valid until the next message.
const char *report_last(void);

// Print how much of a long task is done, as in "3 of 20 pictures", on standard error if that is a
// terminal. The cursor stays at the beginning of the line, so that the next message overwrites it;
// the last call, with done equal to count, clears the line.
void report_progress(int done, int count, const char *what);

// Print text on standard output, without shortening it. Newlines and tabs remain.
void report_text(const char *text);

// Print the text that printf would print in the same way, up to 8 KiB.
void report_result(const char *format, ...) __attribute__((format(printf, 1, 2)));

// Copy a text in which '?' replaces the same characters, and also newlines and tabs.
//   clean  receives at most size - 1 bytes; longer text is cut off between two characters. May be
//          the text itself
//   size   at least 1
void report_clean(char *clean, size_t size, const char *text);

// Return the next character of UTF-8 text, not at its end, or U+FFFD instead of those characters
// and instead of bytes that are not UTF-8.
//   text     is moved behind the character
//   allowed  control characters that remain, such as "\t"
uint32_t report_next(const char **text, const char *allowed);

#endif
