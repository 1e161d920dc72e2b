#include "shader/text_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

// Checked before open, for opening some devices has effects, and after, for the file may change.
static bool is_readable_kind(const struct stat *status, char why[TEXT_FILE_WHY])
{
    if (!S_ISREG(status->st_mode))
        snprintf(why, TEXT_FILE_WHY, "not a regular file");
    else if (status->st_size > TEXT_FILE_LIMIT)
        snprintf(why, TEXT_FILE_WHY, "larger than 1 MiB: is it a shader?");
    else
        return true;
    return false;
}

// Read at most TEXT_FILE_LIMIT + 1 bytes, for a file in /proc does not tell its size.
static ssize_t read_all(int file, char *text)
{
    size_t size = 0;
    while (size <= TEXT_FILE_LIMIT) {
        ssize_t got = read(file, text + size, TEXT_FILE_LIMIT + 1 - size);
        if (got < 0 && errno == EINTR)
            continue;
        if (got < 0)
            return -1;
        if (got == 0)
            break;
        size += (size_t)got;
    }
    text[size] = '\0';
    return (ssize_t)size;
}

// O_NONBLOCK: a fifo put in the file's place must not hang the program.
static ssize_t read_regular(const char *path, char *text, char why[TEXT_FILE_WHY])
{
    struct stat status;
    ssize_t size = -1;
    int file = -1;
    errno = 0;
    if (stat(path, &status) != 0)
        snprintf(why, TEXT_FILE_WHY, "cannot be read: %s", strerror(errno));
    else if (is_readable_kind(&status, why)) {
        file = open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
        if (file < 0 || fstat(file, &status) != 0)
            snprintf(why, TEXT_FILE_WHY, "cannot be read: %s", strerror(errno));
        else if (is_readable_kind(&status, why) && (size = read_all(file, text)) < 0)
            snprintf(why, TEXT_FILE_WHY, "cannot be read: %s", strerror(errno));
    }
    if (file >= 0)
        close(file);
    return size;
}

// Drop the byte-order mark, make every line end '\n' and see that the last line has one.
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
    // A backslash at the very end would join the line to one of another file.
    if (to - text >= 2 && to[-2] == '\\')
        *to++ = '\n';
    *to = '\0';
}

char *text_file_read(const char *path, char why[TEXT_FILE_WHY])
{
    char *text = malloc(TEXT_FILE_LIMIT + 8);
    if (text == NULL) {
        snprintf(why, TEXT_FILE_WHY, "not enough memory");
        return NULL;
    }
    ssize_t size = read_regular(path, text, why);
    if (size >= 0) {
        bool binary = strlen(text) != (size_t)size;
        tidy(text);
        if (size > TEXT_FILE_LIMIT)
            snprintf(why, TEXT_FILE_WHY, "larger than 1 MiB: is it a shader?");
        else if (binary)
            snprintf(why, TEXT_FILE_WHY, "holds a zero byte: a shader is text, in UTF-8");
        else if (text[strspn(text, " \t\n\v\f")] == '\0')
            snprintf(why, TEXT_FILE_WHY, "empty");
        else
            return text;
    }
    free(text);
    return NULL;
}
