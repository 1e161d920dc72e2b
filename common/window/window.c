#include "window/window.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "memory.h"
#include "picture/comparison.h"
#include "report.h"
#include "window/actions.h"
#include "window/draw.h"
#include "window/handle.h"
#include "window/projection.h"
#include "window/ray.h"
#include "window/screenshot.h"
#include "window/state.h"

// A little less than 1/60 s, so that a display with its own rate sets the pace.
#define FRAME_SECONDS   0.0163
#define WATCH_SECONDS   0.1  // between two looks at the shader's files
#define TRANSITION_STEP 0.1  // seconds: a slow machine too shows something between the ends
#define TITLE_SECONDS   0.25 // between two changes of the title bar

// ---- Reload ----

static void add_file(void *watch, const char *path)
{
    watch_add(watch, path);
}

// Load the shaders again, while their readings add each file to the watch. If one has an error, its
// last good picture stays, and the files of both versions are watched for the correction.
static void reload(struct window *window)
{
    const struct window_start *start = window->start;
    bool all = true;
    watch_begin(&window->watch);
    for (int i = 0; i < start->pictures; i++) {
        struct loader *picture = &start->picture[i];
        watch_add(&window->watch, picture->path);
        bool loaded = loader_read(picture) && loader_compile(picture);
        if (loaded)
            printf("%s: reloaded\n", picture->path);
        window->stale |= loaded;
        all &= loaded;
    }
    fflush(stdout);
    if (all)
        watch_end(&window->watch);
    window->broken = !all;
    snprintf(window->panel.error, sizeof window->panel.error, "%s", all ? "" : report_last());
    window->ray.why[0] = '\0';
    window->dirty = true;
    window->title.due = 0.0;
}

// ---- The loop ----

// Adopt the size of the framebuffer, which on a high-density display is larger than the window's;
// also while the window is hidden, because a ray may be selected before the window is seen. Returns
// false while there is nothing to draw on.
static bool update_size(struct window *window)
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

// Wait until the next frame is due; while the picture is still, until something happens.
static void wait_for_turn(const struct window *window)
{
    double due = window->pace.frame + FRAME_SECONDS;
    if (window->pace.drew || window_input_moves(&window->input))
        glfwPollEvents();
    else
        glfwWaitEventsTimeout(WATCH_SECONDS);
    double left = due - glfwGetTime();
    while (left > 0.0) {
        glfwWaitEventsTimeout(left);
        left = due - glfwGetTime();
    }
}

static bool turn(struct window *window)
{
    double now = glfwGetTime();
    bool visible = update_size(window);
    window->moved = false;
    if (!window->has_keyboard && glfwGetWindowAttrib(window->handle, GLFW_FOCUSED) != 0)
        window->has_keyboard = window->dirty = true;
    if (!window->paused && !window->shooting) {
        window->inputs.time += now - window->pace.turn;
        window->moved |= window_uses_time(window);
    }
    window->moved |=
        window_continue_transition(window, fmin(now - window->pace.turn, TRANSITION_STEP));
    window->pace.turn = now;
    window_act(window);
    window->stale |= window->moved;
    if (now >= window->pace.watch_due) {
        window->pace.watch_due = now + WATCH_SECONDS;
        if (watch_look(&window->watch))
            reload(window);
    }
    if (visible && (window->dirty || window->stale || window->handles.moving) &&
        !window_place_handles(window))
        return false;
    comparison_follow(window->renderer);
    bool drawing = visible && (window->dirty || window->stale || window_sharpens(window, now));
    if (drawing && !window_draw(window, now))
        return false;
    window->pace.drew = drawing;
    if (visible && !window->stale && window_screenshot_due(window))
        window_screenshot(window);
    if (now >= window->title.due) {
        window->title.due = now + TITLE_SECONDS;
        window_retitle(window);
    }
    return true;
}

bool window_turn(struct window *window)
{
    if (window->turning) // GLFW may call back during a turn
        return true;
    window->turning = true;
    window->failed |= !turn(window);
    window->turning = false;
    return !window->failed;
}

// While the user drags the window's edge, Windows and macOS keep GLFW from returning, and each size
// on the way must be drawn at once. Damage at the same size can wait for the loop's next turn.
static void show_size(void *to)
{
    struct window *window = to;
    int width = 0, height = 0;
    glfwGetFramebufferSize(window->handle, &width, &height);
    if (width != window->inputs.width || height != window->inputs.height)
        window_turn(window);
}

// ---- Open, run, close ----

struct window *window_open(struct context *context, const struct window_start *start)
{
    struct window *window = memory_zeros(1, sizeof *window);
    struct renderer *renderer = &start->picture[0].renderer;
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
        .grab = {.hovered = -1},
        .handles = {.focused = -1},
        .stale = true,
    };
    if (!overlay_open(&window->panel.overlay, renderer->gl)) {
        window_close(window);
        return NULL;
    }
    glfwSwapInterval(1);
    window_input_open(&window->input, window->handle, show_size, window);
    for (int i = 0; i < start->pictures; i++) {
        struct loader *picture = &start->picture[i];
        watch_add(&window->watch, picture->path);
        for (int k = 0; k < picture->renderer.fragment.file_count; k++)
            watch_add(&window->watch, picture->renderer.fragment.paths[k]);
        picture->request.see = add_file;
        picture->request.to = &window->watch;
    }
    while (renderer->gl->GetError() != GL_NO_ERROR)
        continue; // errors from before the first frame
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
