#include "window/condition.h"

#include "picture/comparison.h"
#include "report.h"
#include "shader/view.h"
#include "window/frames.h"
#include "window/lens.h"
#include "window/state.h"

#define NOTE_SECONDS 4.0 // for which a note is shown

// True if the program of a view, in either picture of a comparison, uses the time or another input
// that changes with time. The linker keeps only the uniforms in use.
static bool program_uses_time(const struct renderer *renderer, enum shader_view view)
{
    GLuint program = renderer->program[view];
    if (program != 0 &&
        inputs_reads(renderer->gl, program, &renderer->fragment, INPUT_TIME, INPUT_DATE))
        return true;
    return renderer->comparison != NULL && program_uses_time(renderer->comparison->other, view);
}

bool window_uses_time(const struct window *window)
{
    const struct renderer *renderer = window->renderer;
    bool slice = shader_shows_ray(renderer->view), selected = window->inputs.pixel[0] >= 0;
    return window_keeps(window) || program_uses_time(renderer, renderer->view) ||
           ((selected || slice) && program_uses_time(renderer, VIEW_PROBE)) ||
           (selected && slice && program_uses_time(renderer, VIEW_PICTURE));
}

void window_pause(struct window *window)
{
    if (window->paused || window_uses_time(window))
        window->paused = !window->paused;
    window->pace.refines = window->paused && window_averages(window);
}

bool window_has_contents(const struct window *window)
{
    return window->start->contents != NULL;
}

bool window_has_scenes(const struct window *window)
{
    return window->start->caption != NULL || window_has_contents(window);
}

// True if the linked programs that follow the rays of pixels, or keep a frame, read one of some
// inputs. Other programs, such as that of the slice, always read the camera.
static bool reads(const struct renderer *renderer, enum input_meaning first,
                  enum input_meaning last)
{
    bool found = renderer->comparison != NULL && reads(renderer->comparison->other, first, last);
    for (int i = 0; i < renderer->pass_count && !found; i++)
        found = reads(&renderer->pass[i], first, last);
    for (enum shader_view i = 0; i < SHADER_PROGRAM_COUNT && !found; i++)
        found = (i <= VIEW_PROBE || i == VIEW_KEPT) && renderer->program[i] != 0 &&
                !shader_shows_ray(i) &&
                inputs_reads(renderer->gl, renderer->program[i], &renderer->fragment, first, last);
    return found;
}

bool window_reads(const struct window *window, enum input_meaning first, enum input_meaning last)
{
    return reads(window->renderer, first, last);
}

bool window_key_acts(struct window *window, enum key_condition condition)
{
    switch (condition) {
    case KEY_ALWAYS:
        return true;
    case KEY_WITH_CAMERA: // a slice or a plot shows the selected ray, wherever the camera is
        return window_reads(window, INPUT_EYE, INPUT_FORWARD) &&
               !(shader_shows_ray(window->renderer->view) && window->inputs.pixel[0] >= 0);
    case KEY_WITH_LENS:
        return window_reads(window, INPUT_FOCAL, INPUT_FOCAL);
    case KEY_WITH_MARCH:
        // A view that an earlier version of the shader had can be left.
        return window->renderer->fragment.marches || window->renderer->view != VIEW_PICTURE;
    case KEY_WITH_TIME:
        return window_uses_time(window);
    case KEY_WITH_EDITOR:
        return !window->panel.in_page;
    case KEY_WITH_RAY:
        return window->inputs.pixel[0] >= 0;
    case KEY_WITH_PARAMETERS:
        return comparison_parameter_count(window->renderer) > 0;
    case KEY_WITH_HANDLES:
        return window->handles.count > 0;
    case KEY_WITH_TOOL:
        return window->renderer->sculpture.tool != NULL;
    case KEY_WITH_PROJECTIONS:
        return window_has_orthographic(window);
    case KEY_WITH_COMPARISON:
        return window->renderer->comparison != NULL;
    case KEY_WITH_SCENES:
        return window_has_scenes(window);
    case KEY_WITH_CONTENTS:
        return window_has_contents(window) && window->inputs.pixel[0] < 0;
    case KEY_IN_LECTURE:
        return window->start->caption != NULL;
    }
    return false;
}

void window_explain_key(struct window *window, enum key_condition condition)
{
    static const char *const why[] = {
        [KEY_WITH_CAMERA] = "this shader does not read the camera",
        [KEY_WITH_LENS] = "this shader has no focal length",
        [KEY_WITH_MARCH] = "only chapters from 01 on have views and rays",
        [KEY_WITH_TIME] = "this picture does not change with time",
        [KEY_WITH_PARAMETERS] = "this shader has no parameters",
        [KEY_WITH_HANDLES] = "this shader has no points to drag",
        [KEY_WITH_TOOL] = "only chapter 23 has clay",
        [KEY_WITH_PROJECTIONS] = "this shader has one projection",
        [KEY_WITH_COMPARISON] = "there is one picture: --compare shows two",
        [KEY_IN_LECTURE] = NULL};
    const char *words = why[condition];
    if (condition == KEY_WITH_MARCH && window->renderer->fragment.dialect == DIALECT_COURSE)
        words = "no ray marches in this picture";
    if (condition == KEY_WITH_CAMERA && shader_shows_ray(window->renderer->view))
        words = "this view shows the ray, not what the camera sees: 1 shows the picture";
    if (words == NULL || (window->panel.told & 1U << condition) != 0 ||
        window_key_acts(window, condition))
        return;
    window->panel.told |= 1U << condition;
    window_note(window, "This does nothing here", words);
}

void window_note(struct window *window, const char *heading, const char *words)
{
    report_clean(window->panel.note, sizeof window->panel.note, words);
    window->panel.note_heading = heading;
    window->panel.note_ends = glfwGetTime() + NOTE_SECONDS;
    window->dirty = true;
}
