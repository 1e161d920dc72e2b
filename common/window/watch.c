#include "window/watch.h"

#include <stdlib.h>
#include <string.h>

#include "memory.h"

enum { LOOKS_WHEN_COMPLETE = 1, LOOKS_WHEN_MISSING = 5 };

// Bring the record of a file up to date. Returns true if the file has changed.
static bool refresh(struct watch_file *file)
{
    struct platform_file was = file->was, *now = &file->was;
    platform_look(file->path, now);
    return now->changed != was.changed || now->size != was.size || !platform_is_same(now, &was);
}

void watch_add(struct watch *watch, const char *path)
{
    int i = 0;
    while (i < watch->count && strcmp(watch->file[i].path, path) != 0)
        i++;
    if (i == watch->count) {
        watch->file = memory_row(watch->file, watch->count++, sizeof *watch->file);
        watch->file[i] = (struct watch_file){.path = memory_text("%s", path)};
        refresh(&watch->file[i]);
    }
    watch->file[i].kept = true;
}

bool watch_look(struct watch *watch)
{
    bool news = false, complete = true;
    for (int i = 0; i < watch->count; i++) {
        struct watch_file *file = &watch->file[i];
        if (refresh(file))
            file->changed = news = true;
        complete &= !file->changed || file->was.size > 0;
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
    for (int i = 0; i < watch->count; i++)
        watch->file[i].changed = false;
    return true;
}

void watch_begin(struct watch *watch)
{
    for (int i = 0; i < watch->count; i++)
        watch->file[i].kept = false;
}

void watch_end(struct watch *watch)
{
    int kept = 0;
    for (int i = 0; i < watch->count; i++) {
        if (watch->file[i].kept)
            watch->file[kept++] = watch->file[i];
        else
            free(watch->file[i].path);
    }
    watch->count = kept;
}

void watch_clear(struct watch *watch)
{
    watch_begin(watch);
    watch_end(watch);
    free(watch->file);
    *watch = (struct watch){0};
}
