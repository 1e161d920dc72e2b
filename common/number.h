// number.h - decimal numbers as people type them, the same in every locale.
#ifndef NUMBER_H
#define NUMBER_H

#include <stdbool.h>
#include <stddef.h>

// Read a number at the beginning of a string, such as "3", "-3", "1.", ".5" or "1e-6". Blanks,
// hexadecimal numbers, "inf" and "nan" are not accepted.
//   value  receives the number, or an infinity if it is too large for a double
// Returns the number's length in characters, or 0 if the string does not begin with a number or if
// the number has more than 127 characters.
size_t number_begin(const char *text, double *value);

// Read a string that consists of one finite number. For any other string, returns false without
// reporting an error.
bool number_read(const char *text, double *value);

// Do the same for a whole number from minimum to maximum. "+3" is accepted, but "3.0" is not.
bool number_read_int(const char *text, int minimum, int maximum, int *value);

#define NUMBER_SIZE 32

// Return a hint to append to an error message. For a number with a decimal comma, such as "0,5",
// the hint is ": write 0.5"; for any other text, it is "". The string is valid until the next call.
const char *number_hint(const char *text);

// Write a number as the shortest text that a shader reads as the same float. A whole number of
// magnitude below 1e10 is written with all its digits.
//   size  at least NUMBER_SIZE
void number_text(double value, char *text, size_t size);

#endif
