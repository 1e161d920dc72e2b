#include "browser/live.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "browser/chapters.h"
#include "browser/state.h"
#include "chapter.h"
#include "memory.h"
#include "picture/pair.h"
#include "platform.h"
#include "report.h"
#include "window/state.h"
#include "window/window.h"

#define ROOT      "/course" // where the page puts the course's files, and the current folder
#define ARGUMENTS 64

static struct {
    struct chapter chapter;
    struct run *run; // NULL before the first start and after a stop
    const struct live_chapter *at;
    char *line; // the command line, cut into arguments
    char *argument[ARGUMENTS + 1];
    int count;
    bool only_sees; // the next main tells its files and does nothing else
    char *answer;   // to the page, the last
} live;

// What a reader has set, while a context that was lost is made again.
static struct {
    bool is;
    struct renderer_inputs inputs;
    struct renderer_eye eye;
    double place[2]; // of the chosen pixel
    bool paused, folded;
    enum shader_view view;
    struct parameters parameters[2]; // of the picture, and of the second beside it
    double divider;
} kept;

static void forget(void)
{
    parameters_free(&kept.parameters[0]);
    parameters_free(&kept.parameters[1]);
    memset(&kept, 0, sizeof kept);
}

// ---- A command line ----

// Take one word off a line, as a shell does, without its quotes. Returns the rest; NULL: no word.
static char *take_word(char *c, char **word)
{
    c += strspn(c, " \t\n");
    if (*c == '\0')
        return NULL;
    char quote = '\0', *to = *word = c;
    for (; *c != '\0' && (quote != '\0' || strchr(" \t\n", *c) == NULL); c++)
        if (*c == quote)
            quote = '\0';
        else if (quote == '\0' && (*c == '\'' || *c == '"'))
            quote = *c;
        else
            *to++ = *c;
    char *rest = *c != '\0' ? c + 1 : c;
    *to = '\0';
    return rest;
}

// Cut a command line into what a main gets. Returns false, reported.
static bool cut(const char *stem, const char *line)
{
    live.at = live_chapters;
    while (live.at->stem != NULL && strcmp(live.at->stem, stem) != 0)
        live.at++;
    if (live.at->stem == NULL)
        return report("%s: there is no such chapter", stem);
    free(live.line);
    live.line = memory_text("%s --root " ROOT " %s", stem, line);
    live.count = 0;
    for (char *rest = live.line, *word; (rest = take_word(rest, &word)) != NULL;) {
        if (live.count == ARGUMENTS)
            return report("%s: more than %d words", stem, ARGUMENTS);
        live.argument[live.count++] = word;
    }
    live.argument[live.count] = NULL;
    platform_set("DISPLAY", "canvas", true); // which glfw.c of the context looks for
    return true;
}

static void see(void *stream, const char *path)
{
    fprintf(stream, "%s", ftell(stream) > 1 ? "," : "");
    state_string(stream, path);
}

// What a chapter's main calls in place of chapter_run.
int live_run(const struct chapter *chapter, int argc, char **argv)
{
    live.chapter = *chapter;
    if (!live.only_sees)
        return chapter_open(&live.run, &live.chapter, argc, argv);
    FILE *stream = memory_open(&live.answer);
    fputs("[", stream);
    chapter_see(&live.chapter, argc, argv, see, stream);
    fputs("]", stream);
    memory_close(stream);
    return 0;
}

static struct window *window(void)
{
    return live.run != NULL ? chapter_window(live.run) : NULL;
}

// The page says beside the picture what the window's panel says in it, which H brings back.
static int start(void)
{
    int status = live.at->main(live.count, live.argument);
    if (window() != NULL) {
        window()->panel.elsewhere = true;
        window()->panel.folded = !window()->start->overlay_kept;
    }
    fflush(stdout);
    return status;
}

int live_start(const char *stem, const char *line)
{
    live_stop();
    forget();
    return cut(stem, line) ? start() : 2;
}

const char *live_files(const char *stem, const char *line)
{
    free(live.answer);
    live.answer = NULL;
    live.only_sees = true;
    if (cut(stem, line))
        start();
    live.only_sees = false;
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

// What a reader has set, taken from the window: its renderers have none of it any more.
static void keep(struct window *window)
{
    struct renderer *first = window->renderer;
    forget();
    kept.is = true;
    kept.inputs = window->inputs;
    kept.eye = window->ray.eye;
    memcpy(kept.place, window->ray.place, sizeof kept.place);
    kept.paused = window->paused;
    kept.folded = window->panel.folded;
    kept.view = first->view;
    kept.parameters[0] = first->parameters;
    first->parameters = (struct parameters){0};
    if (first->pair == NULL)
        return;
    kept.divider = first->pair->divider;
    kept.parameters[1] = first->pair->other->parameters;
    first->pair->other->parameters = (struct parameters){0};
}

static void give_back(struct window *window)
{
    struct renderer *first = window->renderer;
    parameters_keep(&first->parameters, &kept.parameters[0]);
    if (first->pair != NULL) {
        parameters_keep(&first->pair->other->parameters, &kept.parameters[1]);
        first->pair->divider = kept.divider;
    }
    window->inputs = kept.inputs;
    window->ray.eye = kept.eye;
    memcpy(window->ray.place, kept.place, sizeof kept.place);
    window->inputs.eye = kept.inputs.eye != NULL ? &window->ray.eye : NULL;
    window->paused = kept.paused;
    window->panel.folded = kept.folded;
    window->ray.follow = kept.inputs.pixel[0] >= 0;
    live_view((int)kept.view);
    forget();
}

int live_restore(void)
{
    if (window() != NULL)
        keep(window());
    if (!kept.is)
        return 2;
    live_stop();
    int status = start();
    if (window() != NULL)
        give_back(window());
    return status;
}

// ---- What the page shows and sets ----

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

// Of two pictures, the one's by the name that the state gives it: "factor (right)". NULL: none.
static struct parameter *parameter(const char *name)
{
    const struct renderer *renderer = window() != NULL ? window()->renderer : NULL;
    for (int i = 0; renderer != NULL && i < pair_parameter_count(renderer); i++) {
        char said[STATE_NAME];
        pair_parameter_name(renderer, pair_parameter(renderer, i), said, sizeof said);
        if (strcmp(said, name) == 0)
            return pair_parameter(renderer, i);
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
    change();
}

void live_reset(const char *name)
{
    struct parameter *p = parameter(name);
    if (p == NULL)
        return;
    parameter_reset(p);
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
        window_choose_ray(window(), (const int[]){x, y});
    else
        window_leave_ray(window());
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
    window()->inputs.time = time;
    change();
}
