#include "number.h"

#include <errno.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DIGITS  "0123456789"
#define LONGEST 128 // size of the longest number in bytes, including the final '\0'

// Return the length of the number with which the text begins, or 0 if there is none. point receives
// the index of its decimal point or, if it has none, of the character after its digits.
static size_t measure(const char *text, size_t *point)
{
    size_t i = text[0] == '-' || text[0] == '+';
    size_t whole = strspn(text + i, DIGITS);
    size_t fraction = 0;
    i += whole;
    *point = i;
    if (text[i] == '.') {
        fraction = strspn(text + i + 1, DIGITS);
        i += 1 + fraction;
    }
    if (whole + fraction == 0)
        return 0;
    if (text[i] == 'e' || text[i] == 'E') {
        size_t sign = text[i + 1] == '-' || text[i + 1] == '+';
        size_t exponent = strspn(text + i + 1 + sign, DIGITS);
        if (exponent > 0)
            i += 1 + sign + exponent;
    }
    return i;
}

size_t number_begin(const char *text, double *value)
{
    char copy[LONGEST];
    size_t point, length = measure(text, &point);
    if (length == 0 || length >= sizeof copy)
        return 0;
    memcpy(copy, text, length);
    copy[length] = '\0';
    // strtod expects the locale's decimal point.
    if (copy[point] == '.')
        copy[point] = *localeconv()->decimal_point;
    *value = strtod(copy, NULL);
    return length;
}

bool number_read(const char *text, double *value)
{
    double read;
    size_t length = number_begin(text, &read);
    if (length == 0 || text[length] != '\0' || !isfinite(read))
        return false;
    *value = read;
    return true;
}

bool number_read_int(const char *text, int minimum, int maximum, int *value)
{
    size_t sign = text[0] == '-' || text[0] == '+';
    size_t digits = strspn(text + sign, DIGITS);
    errno = 0;
    long read = strtol(text, NULL, 10);
    if (digits == 0 || text[sign + digits] != '\0' || errno != 0 || read < minimum ||
        read > maximum)
        return false;
    *value = (int)read;
    return true;
}

const char *number_hint(const char *text)
{
    static char hint[NUMBER_SIZE + 8];
    double value;
    char *comma;
    int length = snprintf(hint, sizeof hint, ": write %s", text);
    if (length >= (int)sizeof hint || (comma = strchr(hint, ',')) == NULL)
        return "";
    *comma = '.';
    return number_read(hint + 8, &value) ? hint : "";
}

// Shorten an exponent that printf has written: 1e-06 becomes 1e-6, and 1e+10 becomes 1e10.
static void shorten_exponent(char *text)
{
    char *exponent = strchr(text, 'e');
    if (exponent == NULL)
        return;
    char *to = exponent + 1 + (exponent[1] == '-');
    const char *from = exponent + 2;
    from += strspn(from, "0");
    memmove(to, from, strlen(from) + 1);
}

void number_text(double value, char *text, size_t size)
{
    if (value == floor(value) && fabs(value) < 1e10) {
        snprintf(text, size, "%.0f", value + 0.0); // + 0.0 turns -0 into 0
        return;
    }
    for (int digits = 1; digits <= 9; digits++) {
        snprintf(text, size, "%.*g", digits, value);
        if ((float)strtod(text, NULL) == (float)value)
            break;
    }
    char *point = strchr(text, *localeconv()->decimal_point);
    if (point != NULL)
        *point = '.';
    shorten_exponent(text);
}
