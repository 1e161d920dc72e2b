#include "window/window.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "picture/comparison.h"
#include "picture/passes.h"
#include "window/actions.h"
#include "window/condition.h"
#include "window/contents.h"
#include "window/draw.h"
#include "window/frames.h"
#include "window/full_screen.h"
#include "window/handle.h"
#include "window/keys.h"
#include "window/lens.h"
#include "picture/probe.h"
#include "window/ray.h"
#include "window/reload.h"
#include "window/screenshot.h"
#include "window/state.h"

// A little less than 1/60 s, so that the refresh rate of the display sets the pace.
#define FRAME_SECONDS   0.0163
#define WATCH_SECONDS   0.1  // between two checks of the shader's files
#define TRANSITION_STEP 0.1  // maximum seconds; slow machines must show intermediate steps too
#define TITLE_SECONDS   0.25 // between two changes of the title bar
#define DIGITS          8.0f // minimum height of a figure's digits, in CSS pixels
#define SHOWN_SECONDS   2.0  // for which a moving picture is shown before other work may disturb it

// ---- The loop ----

// Adopt the size of the framebuffer, which on a high-density display is larger than the window's.
// Do so even while the window is hidden, because a ray may be selected before the window is seen.
// Returns false while there is nothing to draw on.
static bool update_size(struct window *window)
{
    int width = 0, height = 0, units[2] = {0, 0};
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
    glfwGetWindowSize(window->handle, &units[0], &units[1]);
    window->density =
        window->panel.in_page && units[1] > 0 ? (float)height / (float)units[1] : 0.0f;
    window->inputs.digits = DIGITS * window->density;
    return !hidden;
}

// Wait until the next frame is due or, while the picture is at rest, until an event arrives or the
// files must be checked.
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
    bool visible = update_size(window), changed = false;
    window->moved = false;
    if (!window->has_keyboard && glfwGetWindowAttrib(window->handle, GLFW_FOCUSED) != 0)
        window->has_keyboard = window->dirty = true;
    if ((!window->paused || window->pace.refines) && !window->shooting) {
        bool keeps = window_keeps(window);
        window->inputs.time += keeps ? 0.0 : now - window->pace.turn;
        window->moved |= keeps ? window_next_frame(window) : window_uses_time(window);
    }
    window->moved |=
        window_continue_transition(window, fmin(now - window->pace.turn, TRANSITION_STEP));
    window->pace.turn = now;
    if (visible && window->opening > 0) {
        window_step(window, window->opening);
        window->opening = 0;
    }
    window_act(window);
    if (window->panel.note[0] != '\0' && now > window->panel.note_ends) {
        window->panel.note[0] = '\0';
        window->dirty = true;
    }
    window->stale |= window->moved;
    window->pace.looks = now >= window->pace.watch_due;
    if (window->pace.looks) {
        window->pace.watch_due = now + WATCH_SECONDS;
        changed = watch_look(&window->watch);
    }
    window_reload(window, changed);
    if (visible && (window->dirty || window->stale || window->handles.moving) &&
        !window_place_handles(window))
        return false;
    comparison_follow(window->renderer);
    bool drawing = visible && (window->dirty || (!window->contents.open &&
                                                 (window->stale || window_sharpens(window, now))));
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
    if (window->turning) // GLFW may call back during an iteration
        return true;
    window->turning = true;
    window->failed |= !turn(window);
    window->turning = false;
    return !window->failed;
}

// While the user drags the window's edge, Windows and macOS keep GLFW from returning, and each
// intermediate size must be drawn at once. If the size is unchanged, drawing can wait for the
// loop's next iteration.
static void show_size(void *to)
{
    struct window *window = to;
    int width = 0, height = 0;
    glfwGetFramebufferSize(window->handle, &width, &height);
    if (width != window->inputs.width || height != window->inputs.height)
        window_turn(window);
}

// ---- Open, run, close ----

// True if the panel has moved by itself, which concerns only the picture that was shown.
static bool makes_room(const struct window *window)
{
    return window->panel.room == ROOM_MOVED || window->panel.room == ROOM_COLLAPSED;
}

// The inputs with which a scene begins in the window.
static struct renderer_inputs inputs_of(const struct window *window,
                                        const struct window_start *start)
{
    return (struct renderer_inputs){.width = window->inputs.width,
                                    .height = window->inputs.height,
                                    .camera = start->camera,
                                    .begin = start->time,
                                    .time = start->time,
                                    .samples = start->samples,
                                    .strokes = start->strokes,
                                    .pixel = {-1, -1},
                                    .zoom = 1.0f};
}

void window_show(struct window *window, const struct window_start *start, bool at_last)
{
    struct window *fresh = memory_zeros(1, sizeof *fresh);
    bool lecture = start->caption != NULL;
    *fresh = (struct window){
        .handle = window->handle,
        .renderer = &start->picture[0].renderer,
        .start = start,
        .input = window->input,
        .inputs = inputs_of(window, start),
        .paused = start->paused,
        .opening = start->shown > 0 && at_last ? PROBE_STEPS : start->shown,
        .has_keyboard = window->has_keyboard,
        .turning = window->turning,
        .failed = window->failed,
        .pace = {.turn = glfwGetTime(), .shown = glfwGetTime()},
        .panel = {.overlay = window->panel.overlay,
                  .rows = window->panel.rows,
                  .right = window->panel.right && !makes_room(window),
                  .rolled = window->panel.rolled && window->panel.room != ROOM_COLLAPSED,
                  .folded = lecture && !start->overlay_kept,
                  .captioned = true},
        .grab = {.hovered = -1, .at = {window->grab.at[0], window->grab.at[1]}},
        .shape = window->shape,
        .contents = {.of = window->contents.of, .sheet = window->contents.sheet},
        .part = -1,
        .handles = {.focused = -1},
        .ray = {.probe = window->ray.probe},
        .stale = true,
        .dirty = true,
    };
    if (start->frame > 0 && !window_keeps(fresh)) {
        fresh->inputs.rate = start->rate;
        fresh->inputs = passes_inputs(&fresh->inputs, start->frame);
    }
    if (start->selected != NULL)
        snprintf(fresh->parameter, sizeof fresh->parameter, "%.*s",
                 (int)strcspn(start->selected, "="), start->selected);
    memcpy(fresh->rectangle, window->rectangle, sizeof fresh->rectangle);
    memcpy(fresh->cursor, window->cursor, sizeof fresh->cursor);
    fresh->input.typing = fresh->input.armed = fresh->input.picker_open = false;
    if (window->renderer != NULL)
        window->renderer->overlay = NULL;
    watch_clear(&window->watch);
    *window = *fresh;
    free(fresh);
    window_watch_files(window);
}

struct window *window_open(struct context *context, const struct window_start *start)
{
    struct window *window = memory_zeros(1, sizeof *window);
    const struct gl *gl = start->picture[0].renderer.gl;
    window->handle = context->window;
    window->ray.probe = memory_zeros(1, sizeof(struct probe));
    window->panel.rolled = start->caption != NULL;
    if (!overlay_open(&window->panel.overlay, gl)) {
        window_close(window);
        return NULL;
    }
    glfwSwapInterval(1);
    window_input_open(&window->input, window->handle, show_size, window);
    window_show(window, start, false);
    while (gl->GetError() != GL_NO_ERROR)
        continue; // discard errors from before the first frame
    return window;
}

int window_asked(struct window *window, int *part, int *scene)
{
    int scenes = window->asked.scenes;
    *part = window->asked.part;
    *scene = window->asked.scene;
    window->asked.scenes = window->asked.part = window->asked.scene = 0;
    return scenes;
}

bool window_idles(const struct window *window)
{
    return !window->pace.drew || glfwGetTime() > window->pace.shown + SHOWN_SECONDS;
}

bool window_looks(const struct window *window)
{
    return window->pace.looks;
}

void window_announce(struct window *window, const char *title)
{
    window_note(window, "Opening", title);
    window->failed |= !window_draw(window, glfwGetTime());
}

void window_warn(struct window *window, const char *text)
{
    snprintf(window->panel.error, sizeof window->panel.error, "%s", text);
    window->dirty = true;
    window->title.due = 0.0;
}

void window_fill_screen(struct window *window)
{
    window_toggle_full_screen(window);
}

// Print the keys with which a newcomer begins.
static void greet(struct window *window)
{
    bool course = window_has_contents(window);
    printf("%s%sK: keys, Backspace: quit\n",
           window_key_acts(window, KEY_WITH_CAMERA) ? "drag: look around, W A S D: move, " : "",
           course                      ? "Page Down: next chapter, Home: all chapters, "
           : window_has_scenes(window) ? "Page Down: next scene, "
                                       : "");
    fflush(stdout);
}

bool window_run(struct window *window, void (*turned)(void *to), void *to)
{
    bool done = true;
    greet(window);
    while (done && !glfwWindowShouldClose(window->handle)) {
        wait_for_turn(window);
        done = window_turn(window);
        if (done && turned != NULL)
            turned(to);
    }
    return done;
}

void window_close(struct window *window)
{
    if (window == NULL)
        return;
    watch_clear(&window->watch);
    if (window->renderer != NULL)
        window->renderer->overlay = NULL;
    window_contents_close(window);
    overlay_close(&window->panel.overlay);
    panel_rows_free(&window->panel.rows);
    free(window->ray.probe);
    free(window);
}
