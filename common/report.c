#include "report.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform.h"

enum {
    BUFFER = 8192,       // bytes of a message that needs no further memory
    WORD_SHOWN = 240,    // bytes that are shown of a longer word, such as a path
    LINE_SHOWN = 1600,   // bytes that are shown of a longer line
    REPLACEMENT = 0xFFFD // Unicode's replacement character
};

// The last message.
static char last[BUFFER];

// The text at the beginning of each message.
static char location[1024];

void report_location(const char *text)
{
    snprintf(location, sizeof location, "%s%s", text != NULL ? text : "", text != NULL ? ": " : "");
}

// ---- Characters ----

// True for a character that changes nothing but its own position: no control character, no line
// or paragraph separator, and none that reverses the order of others.
static bool is_harmless(uint32_t code, const char *allowed)
{
    if (code < 0x80)
        return (code >= ' ' && code != 0x7F) || strchr(allowed, (int)code) != NULL;
    return code >= 0xA0 && !(code >= 0x2028 && code <= 0x202E) &&
           !(code >= 0x2066 && code <= 0x2069);
}

uint32_t report_next(const char **text, const char *allowed)
{
    static const uint32_t least[] = {0, 0x80, 0x800, 0x10000};
    const unsigned char *at = (const unsigned char *)*text;
    int more = at[0] < 0x80       ? 0
               : at[0] >> 5 == 6  ? 1
               : at[0] >> 4 == 14 ? 2
               : at[0] >> 3 == 30 ? 3
                                  : -1;
    uint32_t code = more <= 0 ? at[0] : at[0] & (0x3Fu >> more);
    int taken = 1;
    while (taken <= more && at[taken] >> 6 == 2)
        code = code << 6 | (at[taken++] & 0x3Fu);
    *text += taken;
    bool valid = more >= 0 && taken > more && code >= least[more] && code <= 0x10FFFF &&
                 code >> 11 != 0x1B; // half of a UTF-16 pair
    return valid && is_harmless(code, allowed) ? code : REPLACEMENT;
}

// Copy a text's next character, or '?' instead of one that report_next replaces. Returns the number
// of bytes written, which is never more than were read.
static size_t copy_next(char *to, const char **text, const char *allowed)
{
    const char *from = *text;
    bool shown = report_next(text, allowed) != REPLACEMENT;
    size_t length = shown ? (size_t)(*text - from) : 1;
    memmove(to, shown ? from : "?", length);
    return length;
}

void report_clean(char *clean, size_t size, const char *text)
{
    char next[4];
    size_t length = 0, more;
    while (*text != '\0' && length + (more = copy_next(next, &text, "")) < size) {
        memcpy(clean + length, next, more);
        length += more;
    }
    clean[length] = '\0';
}

// ---- Messages ----

// Replace the middle of a text that is longer than most bytes with "...". Returns the new length.
static size_t shorten(char *text, size_t length, size_t most)
{
    size_t half = (most - 3) / 2, from = length - half;
    if (length <= most)
        return length;
    while (((unsigned char)text[half] & 0xC0) == 0x80) // between two characters
        half--;
    while (((unsigned char)text[from] & 0xC0) == 0x80)
        from++;
    memset(text + half, '.', 3);
    memmove(text + half + 3, text + from, length - from);
    return half + 3 + length - from;
}

// Shorten the words of a line, and then the line. Returns the new length.
static size_t shorten_line(char *line, size_t length)
{
    size_t to = 0;
    for (size_t from = 0; from < length;) {
        size_t word = 0;
        while (from + word < length && line[from + word] != ' ' && line[from + word] != '\t')
            word++;
        memmove(line + to, line + from, word);
        from += word;
        to += shorten(line + to, word, WORD_SHOWN);
        if (from < length)
            line[to++] = line[from++];
    }
    return shorten(line, to, LINE_SHOWN);
}

// Clean and shorten the lines of a message, end the last one, print them in one call, so that the
// lines of several programs do not mix, and keep them.
//   text  has room for one more byte; is changed
static void print(char *text, const char *allowed)
{
    size_t length = 0;
    for (const char *from = text; *from != '\0';) {
        char *line = text + length;
        size_t size = 0;
        while (*from != '\0' && (size == 0 || line[size - 1] != '\n'))
            size += copy_next(line + size, &from, allowed);
        bool ended = line[size - 1] == '\n';
        length += shorten_line(line, size - ended);
        if (ended)
            text[length++] = '\n';
    }
    if (length == 0 || text[length - 1] != '\n')
        text[length++] = '\n';
    fwrite(text, 1, length, stderr);
    size_t kept = length < sizeof last ? length : sizeof last - 1;
    memcpy(last, text, kept);
    last[kept] = '\0';
}

// Return room for a message of this many bytes: the buffer, or, if that is too small, new memory.
// Without memory, the buffer is returned, and *size becomes its size.
static char *room_for(size_t *size, char buffer[BUFFER])
{
    char *room = *size > BUFFER ? malloc(*size) : NULL;
    *size = room != NULL || *size <= BUFFER ? *size : BUFFER;
    return room != NULL ? room : buffer;
}

bool report(const char *format, ...)
{
    char buffer[BUFFER];
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    int length = vsnprintf(NULL, 0, format, arguments);
    size_t begin = strlen(location), size = begin + (length > 0 ? (size_t)length : 0) + 2;
    char *text = room_for(&size, buffer);
    strcpy(text, location);
    vsnprintf(text + begin, size - begin - 1, format, again);
    va_end(again);
    va_end(arguments);
    print(text, "");
    if (text != buffer)
        free(text);
    return false;
}

void report_lines(const char *lines)
{
    char buffer[BUFFER];
    size_t size = strlen(lines) + 2;
    char *text = room_for(&size, buffer);
    snprintf(text, size - 1, "%s", lines);
    print(text, "\n\t");
    if (text != buffer)
        free(text);
}

const char *report_last(void)
{
    return last;
}

void report_progress(int done, int count, const char *what)
{
    if (!platform_is_terminal(stderr))
        return;
    fprintf(stderr, "%d of %d %s\r", done, count, what);
    if (done == count)
        fprintf(stderr, "%*s\r", 40, "");
    fflush(stderr);
}

// ---- Standard output ----

void report_text(const char *text)
{
    while (*text != '\0') {
        char character[4] = "";
        fwrite(character, 1, copy_next(character, &text, "\n\t"), stdout);
    }
}

void report_result(const char *format, ...)
{
    char buffer[BUFFER];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(buffer, sizeof buffer, format, arguments);
    va_end(arguments);
    report_text(buffer);
}
