#include "window/reload.h"

#include <stdio.h>
#include <string.h>

#include "report.h"
#include "shader/compile.h"
#include "window/condition.h"

static void add_file(void *watch, const char *path)
{
    watch_add(watch, path);
}

// Reload the shaders, and watch each file that is read. While the driver compiles the shaders, or
// if one has an error, the last good picture stays, and the files of both versions are watched.
static void reload(struct window *window)
{
    const struct window_start *start = window->start;
    bool all = true, read[2];
    watch_begin(&window->watch);
    for (int i = 0; i < start->pictures; i++) {
        struct loader *picture = &start->picture[i];
        watch_add(&window->watch, picture->path);
        read[i] = loader_read(picture);
        if (read[i])
            loader_begin(picture);
        all &= read[i];
    }
    window->compiles = all && !shader_ready(window->renderer->gl);
    if (window->compiles)
        return;
    for (int i = 0; i < start->pictures; i++) {
        struct loader *picture = &start->picture[i];
        bool loaded = read[i] && loader_compile(picture);
        if (loaded)
            report_result("%s: reloaded\n", picture->path);
        window->stale |= loaded;
        all &= loaded;
    }
    fflush(stdout);
    // A shader that was written for another tool has one view.
    for (int i = 0; i < start->pictures; i++)
        if (start->picture[i].renderer.view != window->renderer->view)
            renderer_set_view(window->renderer, VIEW_PICTURE);
    if (all)
        watch_end(&window->watch);
    window->broken = !all;
    snprintf(window->panel.error, sizeof window->panel.error, "%s", all ? "" : report_last());
    window->ray.why[0] = '\0';
    window->dirty = true;
    window->title.due = 0.0;
}

static bool ends_in(const char *path, const char *end)
{
    size_t length = strlen(path), last = strlen(end);
    return length >= last && strcmp(path + length - last, end) == 0;
}

// The part of a path after the last separator of folders, of any system.
static const char *file_name(const char *path)
{
    const char *name = path + strlen(path);
    while (name > path && strchr("/\\", name[-1]) == NULL)
        name--;
    return name;
}

// Read a file that was dropped on the window: a picture for the shader, or another shader. Returns
// false after saying why if that is impossible.
static bool open_dropped(struct window *window)
{
    struct loader *picture = &window->start->picture[0];
    const char *path = window->input.dropped;
    bool done;
    if (ends_in(path, ".obj") || ends_in(path, ".OBJ"))
        done = report("%s: make bake MESH=FILE computes its distances and shows it", path);
    else if (ends_in(path, ".png") || ends_in(path, ".PNG"))
        done = loader_give(picture, path);
    else
        done = loader_open(picture, path);
    if (!done)
        window_note(window, "This cannot be opened here", report_last());
    else if (picture->path == picture->other.path)
        report_clean(window->opened, sizeof window->opened, file_name(picture->path));
    window->input.dropped[0] = '\0';
    return done;
}

void window_watch_files(struct window *window)
{
    const struct window_start *start = window->start;
    for (int i = 0; i < start->pictures; i++) {
        struct loader *picture = &start->picture[i];
        watch_add(&window->watch, picture->path);
        for (int k = 0; k < picture->renderer.fragment.file_count; k++)
            watch_add(&window->watch, picture->renderer.fragment.paths[k]);
        picture->request.visit = add_file;
        picture->request.to = &window->watch;
    }
}

void window_reload(struct window *window, bool changed)
{
    if (window->input.dropped[0] != '\0')
        changed |= open_dropped(window);
    if (changed)
        shader_forget(window->renderer->gl);
    if (changed || (window->compiles && shader_ready(window->renderer->gl)))
        reload(window);
}
