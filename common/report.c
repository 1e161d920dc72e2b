#include "report.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#define LINE_SIZE 8192 // bytes, enough for two of the longest paths

// The last message.
static char last[LINE_SIZE + 2];

// The text at the beginning of each message.
static char location[1024];

void report_location(const char *text)
{
    snprintf(location, sizeof location, "%s%s", text != NULL ? text : "", text != NULL ? ": " : "");
}

// True for a character that a terminal could interpret instead of showing it.
static bool is_control(unsigned char character)
{
    return character < 0x20 || character == 0x7f;
}

// True for the two bytes of U+0080 to U+009F in UTF-8, which terminals interpret as well.
static bool is_wide_control(const unsigned char *text)
{
    return text[0] == 0xc2 && text[1] >= 0x80 && text[1] <= 0x9f;
}

static void keep(const char *text, size_t length)
{
    memcpy(last, text, length);
    last[length] = '\0';
}

// Print text with '?' instead of its control characters, except those in allowed, and end its last
// line. Text that fits into the buffer is written in one call, so that the lines of several
// programs do not mix.
static void print_clean(const char *text, const char *allowed)
{
    char clean[LINE_SIZE + 1];
    size_t length = 0;
    bool ended = false, whole = true;
    for (const unsigned char *at = (const unsigned char *)text; *at != '\0'; at++) {
        bool wide = is_wide_control(at);
        bool bad = wide || (is_control(*at) && strchr(allowed, *at) == NULL);
        if (length == sizeof clean - 1) {
            if (whole)
                keep(clean, length);
            whole = false;
            fwrite(clean, 1, length, stderr);
            length = 0;
        }
        clean[length++] = bad ? '?' : (char)*at;
        ended = *at == '\n' && !bad;
        at += wide;
    }
    if (!ended)
        clean[length++] = '\n';
    if (whole)
        keep(clean, length);
    fwrite(clean, 1, length, stderr);
}

bool report(const char *format, ...)
{
    char text[LINE_SIZE];
    va_list arguments;
    strcpy(text, location);
    size_t begin = strlen(location), room = sizeof text - begin;
    va_start(arguments, format);
    int length = vsnprintf(text + begin, room, format, arguments);
    va_end(arguments);
    if (length >= (int)room)
        strcpy(text + sizeof text - 4, "...");
    print_clean(length < 0 ? format : text, "");
    return false;
}

void report_lines(const char *text)
{
    print_clean(text, "\n\t");
}

const char *report_last(void)
{
    return last;
}
