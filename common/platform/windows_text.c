// platform.h for Windows: streams into memory. The C library of Windows has no such streams, so
// each stream is a temporary file, which seldom reaches the disk. The file is kept for the next
// stream, because a window writes short texts in every frame.
#include "platform.h"

#include <fcntl.h>
#include <io.h>
#include <stdlib.h>
#include <string.h>

#define WIN32_LEAN_AND_MEAN
#include <windows.h>

enum { STREAMS = 16 }; // maximum number of streams open at the same time

static struct {
    FILE *stream;
    char **text; // NULL while the stream is unused
    size_t *size;
} kept[STREAMS];

// Open a file that the system deletes when its last handle is closed, however the program ends.
static FILE *open_scratch(void)
{
    wchar_t folder[MAX_PATH + 1], name[MAX_PATH + 1];
    DWORD length = GetTempPathW(MAX_PATH + 1, folder);
    if (length == 0 || length > MAX_PATH || GetTempFileNameW(folder, L"ray", 0, name) == 0)
        return NULL;
    HANDLE handle =
        CreateFileW(name, GENERIC_READ | GENERIC_WRITE | DELETE, FILE_SHARE_DELETE, NULL,
                    CREATE_ALWAYS, FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, NULL);
    int number = handle != INVALID_HANDLE_VALUE
                     ? _open_osfhandle((intptr_t)handle, _O_RDWR | _O_BINARY)
                     : -1;
    if (number < 0 && handle != INVALID_HANDLE_VALUE)
        CloseHandle(handle);
    return number < 0 ? NULL : _fdopen(number, "w+b");
}

FILE *platform_open_text(char **text, size_t *size)
{
    int i = 0;
    while (i < STREAMS && kept[i].text != NULL)
        i++;
    if (i == STREAMS)
        return NULL;
    if (kept[i].stream == NULL)
        kept[i].stream = open_scratch();
    if (kept[i].stream == NULL)
        return NULL;
    *text = NULL;
    *size = 0;
    kept[i].text = text;
    kept[i].size = size;
    return kept[i].stream;
}

// Return the text written, with '\0' at the end, or NULL if part of it is missing.
static char *contents(FILE *stream, size_t *size)
{
    bool failed = fflush(stream) != 0 || ferror(stream) != 0;
    long long length = _ftelli64(stream);
    if (failed || length < 0 || fseek(stream, 0, SEEK_SET) != 0)
        return NULL;
    char *text = malloc((size_t)length + 1);
    if (text == NULL || fread(text, 1, (size_t)length, stream) != (size_t)length) {
        free(text);
        return NULL;
    }
    text[length] = '\0';
    *size = (size_t)length;
    return text;
}

bool platform_close_text(FILE *stream)
{
    int i = 0;
    while (i < STREAMS - 1 && kept[i].stream != stream)
        i++;
    char *text = contents(stream, kept[i].size);
    *kept[i].text = text;
    kept[i].text = NULL;
    rewind(stream); // also clears an error
    if (_chsize_s(_fileno(stream), 0) != 0) {
        fclose(stream);
        kept[i].stream = NULL;
    }
    return text != NULL;
}
