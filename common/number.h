// number.h - decimal numbers as people type them, the same in every locale.
#ifndef NUMBER_H
#define NUMBER_H

#include <stdbool.h>
#include <stddef.h>

// Read a number at the beginning of a text, such as "3", "-3", "1.", ".5" or "1e-6". Blanks,
// hexadecimal numbers, "inf" and "nan" are not accepted.
//   value  receives the number, which is infinite if it is too large for a double
// Returns the number's length in characters, or 0 if the text does not begin with a number.
size_t number_begin(const char *text, double *value);

// Read a text that is one finite number and nothing else. Otherwise returns false without
// reporting an error.
bool number_read(const char *text, double *value);

// As number_read, for a whole number from minimum to maximum. "+3" is accepted, "3.0" is not.
bool number_read_int(const char *text, int minimum, int maximum, int *value);

#define NUMBER_SIZE 32

// Return a hint to add to an error: ": write 0.5" for "0,5", which has a comma instead of the
// point, or "" for any other text. Valid until the next call.
const char *number_hint(const char *text);

// Write the shortest text that a shader reads as the same float; a whole number below 1e10 has all
// its digits.
//   size  at least NUMBER_SIZE
void number_text(double value, char *text, size_t size);

#endif
