#include "shader/text_file.h"

#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "platform.h"

FILE *text_file_open(const char *path, char why[TEXT_FILE_WHY])
{
    FILE *file = platform_open(path);
    if (file == NULL && errno == 0)
        snprintf(why, TEXT_FILE_WHY, "not a regular file");
    else if (file == NULL)
        snprintf(why, TEXT_FILE_WHY, "cannot be read: %s", platform_why(errno));
    return file;
}

// Drop the byte-order mark, turn every line end into '\n', and terminate the last line.
static void tidy(char *text)
{
    const char *from = strncmp(text, "\xEF\xBB\xBF", 3) == 0 ? text + 3 : text;
    char *to = text;
    for (; *from != '\0'; from++)
        if (*from != '\r')
            *to++ = *from;
        else if (from[1] != '\n')
            *to++ = '\n';
    if (to == text || to[-1] != '\n')
        *to++ = '\n';
    // A backslash at the very end would join the line to the next file's first line.
    if (to - text >= 2 && to[-2] == '\\')
        *to++ = '\n';
    *to = '\0';
}

char *text_file_read(const char *path, char why[TEXT_FILE_WHY])
{
    FILE *file = text_file_open(path, why);
    if (file == NULL)
        return NULL;
    // Read one byte more than the limit to recognise larger files, because a file in /proc does not
    // report its size.
    char *text = memory_zeros(TEXT_FILE_LIMIT + 8, 1);
    size_t size = fread(text, 1, TEXT_FILE_LIMIT + 1, file);
    bool failed = ferror(file) != 0, binary = strlen(text) != size;
    if (failed)
        snprintf(why, TEXT_FILE_WHY, "cannot be read: %s", platform_why(errno));
    fclose(file);
    tidy(text);
    bool empty = text[strspn(text, " \t\n\v\f")] == '\0';
    if (!failed && !binary && !empty && size <= TEXT_FILE_LIMIT)
        return text;
    free(text);
    if (!failed)
        snprintf(why, TEXT_FILE_WHY, "%s",
                 size > TEXT_FILE_LIMIT ? "larger than 1 MiB: is it a shader?"
                 : binary               ? "contains a zero byte: a shader is UTF-8 text"
                                        : "empty");
    return NULL;
}
