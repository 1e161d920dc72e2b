#include "memory.h"

#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "platform.h"
#include "report.h"

const char *memory_limit(void)
{
    static char phrase[128];
    char option;
    double limit = platform_memory_limit(&option);
    if (limit == HUGE_VAL)
        return "";
    snprintf(phrase, sizeof phrase,
             "; this process may use only %.0f MB of memory: raise the limit (ulimit -%c)",
             1e-6 * limit, option);
    return phrase;
}

static void need(bool there)
{
    if (there)
        return;
    report("not enough memory: close other programs%s", memory_limit());
    exit(EXIT_FAILURE);
}

void *memory_zeros(size_t count, size_t size)
{
    void *zeros = calloc(count > 0 ? count : 1, size);
    need(zeros != NULL);
    return zeros;
}

void *memory_row(void *row, int count, size_t size)
{
    if ((count & (count - 1)) != 0)
        return row;
    row = realloc(row, (2 * (size_t)count + 1) * size);
    need(row != NULL);
    return row;
}

char *memory_text(const char *format, ...)
{
    char *text = NULL;
    FILE *stream = memory_open(&text);
    va_list arguments;
    va_start(arguments, format);
    vfprintf(stream, format, arguments);
    va_end(arguments);
    memory_close(stream);
    return text;
}

void memory_append(char *text, size_t size, const char *format, ...)
{
    size_t used = strlen(text);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text + used, size - used, format, arguments);
    va_end(arguments);
}

char *memory_list(int count, const char *(*name)(const void *of, int i), const void *of)
{
    char *text;
    FILE *stream = memory_open(&text);
    for (int i = 0; i < count; i++)
        fprintf(stream, "%s%s", i > 0 ? ", " : "", name(of, i));
    memory_close(stream);
    return text;
}

FILE *memory_open(char **text)
{
    static size_t size; // unused
    FILE *stream = platform_open_text(text, &size);
    need(stream != NULL);
    return stream;
}

void memory_close(FILE *stream)
{
    need(platform_close_text(stream));
}
