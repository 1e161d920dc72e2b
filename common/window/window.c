#include "window/window.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "memory.h"
#include "picture/pair.h"
#include "report.h"
#include "window/state.h"

// A little less than 1/60 s, so that the display's own beat sets the pace where there is one.
#define FRAME_SECONDS 0.0163
#define LOOK_SECONDS  0.1  // between two looks at the shader's files
#define PASSAGE_STEP  0.1  // seconds: on a slow machine too there is something between the ends
#define TITLE_SECONDS 0.25 // between two changes of the title bar

// ---- Reload ----

static void watch_files(struct window *window, const struct shader_source *source)
{
    for (int i = 0; i < source->file_count; i++)
        watch_add(&window->watch, source->paths[i]);
}

static void see(void *window, const char *path)
{
    watch_add(&((struct window *)window)->watch, path);
}

// Read one of the shaders again. Returns false, reported, and keeps what the renderer has.
static bool load(struct window *window, struct renderer *renderer, const char *path)
{
    struct shader_source source = {0};
    struct parameters parameters = {0};
    struct shader_request request = *window->start->request;
    request.see = see;
    request.to = window;
    bool loaded = shader_read_asked(&source, path, renderer->root, &request) &&
                  parameters_read(&parameters, &source) &&
                  renderer_load(renderer, &source, &parameters);
    shader_free(&source);
    parameters_free(&parameters);
    if (loaded)
        printf("%s: loaded again\n", path);
    fflush(stdout);
    return loaded;
}

// Watch what the shaders were read from, and nothing else.
static void watch_again(struct window *window)
{
    const struct renderer *renderer = window->renderer;
    const struct shader_source *first = &renderer->fragment;
    const struct shader_source *second = renderer->pair ? &renderer->pair->other->fragment : NULL;
    char **paths = NULL;
    int count = 0;
    for (int i = 0; i < first->file_count; i++) {
        paths = memory_row(paths, count, sizeof *paths);
        paths[count++] = first->paths[i];
    }
    for (int i = 0; second != NULL && i < second->file_count; i++) {
        paths = memory_row(paths, count, sizeof *paths);
        paths[count++] = second->paths[i];
    }
    watch_keep(&window->watch, window->start->shader, paths, count);
    free(paths);
    if (second != NULL)
        watch_add(&window->watch, window->start->second);
}

// Load the shaders again. One that is broken leaves its last good picture; then its files, and
// those of the last good one, are all watched for the repair.
static void reload(struct window *window)
{
    const struct window_start *start = window->start;
    const struct pair *pair = window->renderer->pair;
    bool loaded = load(window, window->renderer, start->shader);
    if (pair != NULL)
        loaded = load(window, pair->other, start->second) && loaded;
    window->broken = !loaded;
    snprintf(window->panel.error, sizeof window->panel.error, "%s", loaded ? "" : report_last());
    window->ray.why[0] = '\0';
    window->dirty = true;
    window->stale |= loaded || pair != NULL;
    window->title.due = 0.0;
    if (loaded)
        watch_again(window);
}

// ---- The loop ----

// Take over the size of the framebuffer, which on a high-density display is larger than the
// window's; where the window is hidden too, for a ray may be chosen before it is seen. Returns
// false while there is nothing to draw on.
static bool take_size(struct window *window)
{
    int width = 0, height = 0;
    glfwGetFramebufferSize(window->handle, &width, &height);
    bool hidden = glfwGetWindowAttrib(window->handle, GLFW_ICONIFIED) != 0;
    window->dirty |= width < 1 || height < 1 || hidden;
    if (width < 1 || height < 1)
        return false;
    if (width != window->inputs.width || height != window->inputs.height) {
        window_resize_ray(window, width, height);
        window->stale = true;
    }
    window->inputs.width = width;
    window->inputs.height = height;
    return !hidden;
}

// Wait until the next frame is due, or, while the picture stands still, until something happens.
static void wait_for_turn(const struct window *window)
{
    double due = window->pace.frame + FRAME_SECONDS;
    if (window->pace.drew || window_input_moves(&window->input))
        glfwPollEvents();
    else
        glfwWaitEventsTimeout(LOOK_SECONDS);
    double left = due - glfwGetTime();
    while (left > 0.0) {
        glfwWaitEventsTimeout(left);
        left = due - glfwGetTime();
    }
}

static bool turn(struct window *window)
{
    double now = glfwGetTime();
    bool visible = take_size(window);
    window->moved = false;
    if (!window->has_keyboard && glfwGetWindowAttrib(window->handle, GLFW_FOCUSED) != 0)
        window->has_keyboard = window->dirty = true;
    if (!window->paused && !window->shooting) {
        window->inputs.time += now - window->pace.turn;
        window->moved |= window_uses_time(window);
    }
    window->moved |= window_pass(window, fmin(now - window->pace.turn, PASSAGE_STEP));
    window->pace.turn = now;
    window_obey(window);
    window->stale |= window->moved;
    if (now >= window->pace.look_at) {
        window->pace.look_at = now + LOOK_SECONDS;
        if (watch_look(&window->watch))
            reload(window);
    }
    bool drawing = visible && (window->dirty || window->stale || window_sharpens(window, now));
    if (drawing && !window_draw(window, now))
        return false;
    window->pace.drew = drawing;
    if (visible && !window->stale && window_shoots(window))
        window_shoot(window);
    if (now >= window->title.due) {
        window->title.due = now + TITLE_SECONDS;
        window_retitle(window);
    }
    return true;
}

bool window_turn(struct window *window)
{
    if (window->turning) // GLFW calls back while it carries out what a turn asks for
        return true;
    window->turning = true;
    window->failed |= !turn(window);
    window->turning = false;
    return !window->failed;
}

// While a hand drags the window's edge, Windows and macOS keep GLFW from returning, and each size
// on the way asks to be shown. At the same size the loop's next turn is soon enough.
static void show_size(void *to)
{
    struct window *window = to;
    int width = 0, height = 0;
    glfwGetFramebufferSize(window->handle, &width, &height);
    if (width != window->inputs.width || height != window->inputs.height)
        window_turn(window);
}

// ---- Open, run, close ----

struct window *window_open(struct context *context, struct renderer *renderer,
                           const struct window_start *start)
{
    struct window *window = memory_zeros(1, sizeof *window);
    *window = (struct window){
        .handle = context->window,
        .renderer = renderer,
        .start = start,
        .inputs = {.camera = start->camera,
                   .time = start->time,
                   .samples = start->samples,
                   .pixel = {-1, -1},
                   .zoom = 1.0f},
        .ray = {.probe = memory_zeros(1, sizeof(struct probe))},
        .touch = {.pointed = -1},
        .stale = true,
    };
    if (!overlay_open(&window->panel.overlay, renderer->gl)) {
        window_close(window);
        return NULL;
    }
    glfwSwapInterval(1);
    window_input_open(&window->input, window->handle, show_size, window);
    watch_add(&window->watch, start->shader);
    watch_files(window, &renderer->fragment);
    if (renderer->pair != NULL) {
        watch_add(&window->watch, start->second);
        watch_files(window, &renderer->pair->other->fragment);
    }
    while (renderer->gl->GetError() != GL_NO_ERROR)
        continue; // of what came before the first frame
    window->pace.turn = glfwGetTime();
    return window;
}

bool window_run(struct window *window)
{
    bool done = true;
    while (done && !glfwWindowShouldClose(window->handle)) {
        wait_for_turn(window);
        done = window_turn(window);
    }
    return done;
}

void window_close(struct window *window)
{
    if (window == NULL)
        return;
    watch_clear(&window->watch);
    window->renderer->overlay = NULL;
    overlay_close(&window->panel.overlay);
    panel_rows_free(&window->panel.rows);
    free(window->ray.probe);
    free(window);
}
