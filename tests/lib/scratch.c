#include "lib/scratch.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "lib/system.h"

#define CAPTURE_SIZE 65536

static struct {
    char folder[PLATFORM_PATH];
    char path[8][2 * PLATFORM_PATH];
    int next;
    int saved_stderr;
    FILE *captured;
    char text[CAPTURE_SIZE];
} state;

static void need(bool done, const char *what)
{
    if (!done) {
        perror(what);
        abort();
    }
}

const char *scratch_make(void)
{
    need(system_make_scratch(state.folder), state.folder);
    return state.folder;
}

void scratch_remove(void)
{
    need(system_remove_folder(state.folder), state.folder);
}

int scratch_setup(void **unused)
{
    (void)unused;
    scratch_make();
    return 0;
}

int scratch_teardown(void **unused)
{
    (void)unused;
    scratch_remove();
    return 0;
}

static char *next_path(const char *name)
{
    char *path = state.path[state.next++ % 8];
    size_t length = strlen(state.folder), more = strlen(name);
    need(length + more + 2 <= sizeof state.path[0], name);
    memcpy(path, state.folder, length);
    path[length] = '/';
    memcpy(path + length + 1, name, more + 1);
    return path;
}

const char *scratch_path(const char *name)
{
    return next_path(name);
}

const char *scratch_write_bytes(const char *name, const void *bytes, size_t size)
{
    char *path = next_path(name);
    for (char *slash = strchr(path + strlen(state.folder) + 1, '/'); slash != NULL;
         slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        system_make_folder(path);
        *slash = '/';
    }
    FILE *file = fopen(path, "wb");
    need(file != NULL && fwrite(bytes, 1, size, file) == size && fclose(file) == 0, path);
    return path;
}

const char *scratch_write(const char *name, const char *text)
{
    return scratch_write_bytes(name, text, strlen(text));
}

void capture_begin(void)
{
    fflush(stderr);
    state.saved_stderr = dup(STDERR_FILENO);
    state.captured = system_open_scratch();
    need(state.saved_stderr >= 0 && dup2(fileno(state.captured), STDERR_FILENO) >= 0, "capture");
}

const char *capture_end(void)
{
    fflush(stderr);
    need(dup2(state.saved_stderr, STDERR_FILENO) >= 0, "capture");
    close(state.saved_stderr);
    rewind(state.captured);
    size_t size = fread(state.text, 1, sizeof state.text - 1, state.captured);
    state.text[size] = '\0';
    fclose(state.captured);
    return state.text;
}

int line_count(const char *text)
{
    int count = 0;
    for (const char *c = text; *c != '\0'; c++)
        count += *c == '\n' || c[1] == '\0';
    return count;
}
