#include "window/watch.h"

#include <stdlib.h>
#include <string.h>

#include "memory.h"

enum { LOOKS_WHEN_COMPLETE = 1, LOOKS_WHEN_MISSING = 5 };

// Bring the record of a file up to date; true when it was not.
static bool refresh(struct watch_file *file)
{
    struct platform_file was = file->was, *now = &file->was;
    platform_look(file->path, now);
    return now->changed != was.changed || now->size != was.size || !platform_is_same(now, &was);
}

void watch_add(struct watch *watch, const char *path)
{
    for (int i = 0; i < watch->count; i++)
        if (strcmp(watch->file[i].path, path) == 0)
            return;
    watch->file = memory_row(watch->file, watch->count, sizeof *watch->file);
    watch->file[watch->count] = (struct watch_file){.path = memory_text("%s", path)};
    refresh(&watch->file[watch->count++]);
}

bool watch_look(struct watch *watch)
{
    bool news = false, complete = true;
    for (int i = 0; i < watch->count; i++) {
        news |= refresh(&watch->file[i]);
        complete &= watch->file[i].was.size > 0;
    }
    if (news) {
        watch->pending = true;
        watch->quiet = 0;
        return false;
    }
    watch->quiet++;
    if (!watch->pending || watch->quiet < (complete ? LOOKS_WHEN_COMPLETE : LOOKS_WHEN_MISSING))
        return false;
    watch->pending = false;
    return true;
}

static bool is_among(const char *path, const char *first, char *const *others, int count)
{
    bool found = strcmp(path, first) == 0;
    for (int i = 0; i < count && !found; i++)
        found = strcmp(path, others[i]) == 0;
    return found;
}

void watch_keep(struct watch *watch, const char *first, char *const *others, int count)
{
    int kept = 0;
    for (int i = 0; i < watch->count; i++) {
        if (is_among(watch->file[i].path, first, others, count))
            watch->file[kept++] = watch->file[i];
        else
            free(watch->file[i].path);
    }
    watch->count = kept;
}

void watch_clear(struct watch *watch)
{
    for (int i = 0; i < watch->count; i++)
        free(watch->file[i].path);
    free(watch->file);
    *watch = (struct watch){0};
}
