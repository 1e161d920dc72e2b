#include "browser/live.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "linked.h"
#include "browser/state.h"
#include "chapter.h"
#include "command/options.h"
#include "json.h"
#include "memory.h"
#include "picture/comparison.h"
#include "platform.h"
#include "report.h"
#include "shader/compile.h"
#include "window/ray.h"
#include "window/selection.h"
#include "window/state.h"
#include "window/window.h"

#define ROOT "/course" // the current folder, to which the page writes the course's files

static struct {
    struct chapter chapter;
    struct run *run; // NULL before the first start and after a stop
    const struct linked_chapter *program;
    char *line; // the command line, split into arguments
    char *argument[OPTIONS_WORDS + 1];
    int count;
    bool visits;  // main only visits the files that it needs
    bool begins;  // main only has the driver start compiling
    char *answer; // the text that was last returned to the page
} live;

// The user's state while a lost context is restored.
static struct {
    bool is;
    struct window window; // of which inputs, ray, paused and folded are restored
    enum shader_view view;
    struct parameters parameters[2]; // of the picture, and of a comparison's second picture
    double divider;
    struct strokes strokes;
} kept;

static void forget(void)
{
    parameters_free(&kept.parameters[0]);
    parameters_free(&kept.parameters[1]);
    strokes_free(&kept.strokes);
    memset(&kept, 0, sizeof kept);
}

// ---- A command line ----

// Find the chapter, and split its command line into the arguments of main. Returns false after
// reporting the error.
static bool split(const char *stem, const char *line)
{
    live.program = linked_chapters;
    while (live.program->stem != NULL && strcmp(live.program->stem, stem) != 0)
        live.program++;
    if (live.program->stem == NULL)
        return report("%s: there is no such chapter", stem);
    free(live.line);
    live.line = memory_text("%s --root " ROOT " %s", stem, line);
    live.count = options_split(live.line, live.argument);
    if (live.count < 0)
        return false;
    platform_set("DISPLAY", "canvas", true); // without DISPLAY, context/glfw.c opens no window
    return true;
}

static void add_file(void *json, const char *path)
{
    json_text(json, NULL, path);
}

int linked_run(const struct chapter *chapter, int argc, char **argv)
{
    live.chapter = *chapter;
    if (live.begins) {
        chapter_begin(&live.run, &live.chapter, argc, argv);
        return 0;
    }
    if (!live.visits)
        return chapter_open(&live.run, &live.chapter, argc, argv);
    struct json json = {.stream = memory_open(&live.answer)};
    json_begin(&json, NULL, '[');
    chapter_visit_files(&live.chapter, argc, argv, add_file, &json);
    json_end(&json, ']');
    memory_close(json.stream);
    return 0;
}

static struct window *window(void)
{
    return live.run != NULL ? chapter_window(live.run) : NULL;
}

// Run the chapter's main. Without the option --overlay, the panel is hidden until H shows it,
// because the page shows the panel's text beside the picture.
static int start(void)
{
    int status = live.program->main(live.count, live.argument);
    if (window() != NULL) {
        window()->panel.in_page = true;
        window()->panel.folded = !window()->start->overlay_kept;
    }
    fflush(stdout);
    return status;
}

int live_start(const char *stem, const char *line)
{
    live_stop();
    forget();
    return split(stem, line) ? start() : 2;
}

void live_begin(const char *stem, const char *line)
{
    live_stop();
    live.begins = true;
    if (split(stem, line))
        live.program->main(live.count, live.argument);
    live.begins = false;
}

int live_ready(void)
{
    return live.run == NULL || chapter_ready(live.run);
}

const char *live_files(const char *stem, const char *line)
{
    free(live.answer);
    live.answer = NULL;
    live.visits = true;
    if (split(stem, line))
        start();
    live.visits = false;
    return live.answer != NULL ? live.answer : "[]";
}

void live_stop(void)
{
    if (live.run != NULL)
        chapter_close(live.run);
    live.run = NULL;
}

// ---- The window ----

int live_runs(void)
{
    return window() != NULL;
}

int live_turn(void)
{
    bool done =
        window() != NULL && window_turn(window()) && !glfwWindowShouldClose(window()->handle);
    fflush(stdout);
    return done;
}

// Move the user's state out of the window.
static void keep(const struct window *window)
{
    struct renderer *first = window->renderer,
                    *second = first->comparison ? first->comparison->other : NULL;
    forget();
    kept.is = true;
    kept.window = *window;
    kept.view = first->view;
    kept.parameters[0] = first->parameters;
    first->parameters = (struct parameters){0};
    kept.strokes = *window->start->strokes;
    *window->start->strokes = (struct strokes){0};
    if (second == NULL)
        return;
    kept.divider = first->comparison->divider;
    kept.parameters[1] = second->parameters;
    second->parameters = (struct parameters){0};
}

static void give_back(struct window *window)
{
    struct renderer *first = window->renderer;
    const struct window *was = &kept.window;
    parameters_keep(&first->parameters, &kept.parameters[0]);
    if (first->comparison != NULL) {
        parameters_keep(&first->comparison->other->parameters, &kept.parameters[1]);
        first->comparison->divider = kept.divider;
    }
    window->inputs = was->inputs;
    strokes_free(window->start->strokes);
    *window->start->strokes = kept.strokes;
    kept.strokes = (struct strokes){0};
    window->inputs.strokes = window->start->strokes;
    window->ray.eye = was->ray.eye;
    memcpy(window->ray.position, was->ray.position, sizeof was->ray.position);
    window->inputs.eye = was->inputs.eye != NULL ? &window->ray.eye : NULL;
    window->paused = was->paused;
    window->panel.folded = was->panel.folded;
    window->ray.follow = was->inputs.pixel[0] >= 0;
    live_view((int)kept.view);
    forget();
}

int live_restore(void)
{
    if (window() != NULL) {
        shader_forget(window()->renderer->gl); // the shaders belonged to the lost context
        keep(window());
    }
    if (!kept.is)
        return 2;
    live_stop();
    int status = start();
    if (window() != NULL)
        give_back(window());
    return status;
}

// ---- State ----

const char *live_state(void)
{
    free(live.answer);
    FILE *stream = memory_open(&live.answer);
    state_write(stream, &live.chapter, window());
    memory_close(stream);
    return live.answer;
}

const char *live_report(void)
{
    return report_last();
}

const char *live_version(void)
{
    free(live.answer);
    live.answer = NULL;
    if (window() == NULL)
        return "";
    const struct gl *gl = window()->renderer->gl;
    live.answer = memory_text("%s, %s", (const char *)gl->GetString(GL_VERSION),
                              (const char *)gl->GetString(GL_RENDERER));
    return live.answer;
}

// Find a parameter by its name in live_state, such as "factor (right)". Returns NULL if there is
// none.
static struct parameter *parameter(const char *name)
{
    const struct renderer *renderer = window() != NULL ? window()->renderer : NULL;
    for (int i = 0; renderer != NULL && i < comparison_parameter_count(renderer); i++) {
        char own[STATE_NAME];
        comparison_parameter_name(renderer, comparison_parameter(renderer, i), own, sizeof own);
        if (strcmp(own, name) == 0)
            return comparison_parameter(renderer, i);
    }
    return NULL;
}

static void change(void)
{
    window()->stale = window()->moved = true;
}

void live_set(const char *name, int component, double value)
{
    struct parameter *p = parameter(name);
    if (p == NULL || component < 0 || component >= p->components || !(value == value))
        return;
    p->value[component] = value < p->minimum ? p->minimum : value > p->maximum ? p->maximum : value;
    window_begin_hour(window(), p);
    change();
}

void live_reset(const char *name)
{
    struct parameter *p = parameter(name);
    if (p == NULL)
        return;
    parameter_reset(p);
    window_begin_hour(window(), p);
    change();
}

int live_view(int view)
{
    if (window() == NULL || view < 0 || view >= SHADER_VIEW_COUNT ||
        !renderer_set_view(window()->renderer, (enum shader_view)view))
        return 0;
    change();
    return 1;
}

void live_pause(int paused)
{
    if (window() != NULL)
        window()->paused = paused != 0;
}

void live_pixel(int x, int y)
{
    if (window() == NULL)
        return;
    if (x >= 0)
        window_select_ray(window(), (const int[]){x, y});
    else
        window_deselect_ray(window());
}

void live_step(int step)
{
    if (window() == NULL || !window_step_to(window(), false))
        return;
    window_step(window(), step);
    window()->dirty = true;
}

void live_time(double time)
{
    if (window() == NULL || !(time == time))
        return;
    // Kept frames begin again at another time; the time of each follows from that of frame 0.
    if (time != window()->inputs.time)
        window()->inputs.begin = time;
    window()->inputs.time = time;
    change();
}
