#include "browser/state.h"

#include <math.h>

#include "browser/canvas.h"
#include "json.h"
#include "picture/comparison.h"
#include "picture/passes.h"
#include "report.h"
#include "window/frames.h"
#include "window/state.h"
#include "window/stroke.h"
#include "window/window.h"

static void write_numbers(struct json *json, const char *name, int count, const double *value)
{
    json_begin(json, name, '[');
    for (int i = 0; i < count; i++)
        json_number(json, NULL, value[i], -1);
    json_end(json, ']');
}

static void write_parameter(struct json *json, const struct renderer *renderer, int index)
{
    const struct parameter *p = comparison_parameter(renderer, index);
    char name[STATE_NAME];
    comparison_parameter_name(renderer, p, name, sizeof name);
    static const char *const types[] = {
        [PARAMETER_FLOAT] = "float", [PARAMETER_INT] = "int", [PARAMETER_BOOL] = "bool"};
    json_begin(json, NULL, '{');
    json_text(json, "type", types[p->type]);
    json_text(json, "name", name);
    write_numbers(json, "value", p->components, p->value);
    write_numbers(json, "initial", p->components, p->initial);
    json_number(json, "minimum", p->minimum, -1);
    json_number(json, "maximum", p->maximum, -1);
    json_number(json, "step", p->step, -1);
    json_flag(json, "multiplies", p->multiplies);
    json_text(json, "unit", p->unit);
    json_text(json, "meaning", p->meaning);
    json_end(json, '}');
}

static void write_probe(struct json *json, const struct probe *probe)
{
    const unsigned char *colour = probe->colour;
    json_begin(json, "probe", '{');
    json_flag(json, "recorded", probe->recorded);
    json_number(json, "steps", probe->steps, 0);
    json_number(json, "all_steps", probe->all_steps, 0);
    json_number(json, "evaluations", probe->evaluations, 0);
    write_numbers(json, "colour", 3, (const double[]){colour[0], colour[1], colour[2]});
    json_text(json, "outcome", probe->recorded ? probe_outcome(probe) : "");
    json_begin(json, "march", '[');
    for (int i = 0; probe->recorded && i < probe_rows(probe); i++) {
        const struct probe_step *step = &probe->step[i];
        write_numbers(json, NULL, 5,
                      (const double[]){(double)step->t, (double)step->distance,
                                       (double)step->position[0], (double)step->position[1],
                                       (double)step->position[2]});
    }
    json_end(json, ']');
    json_end(json, '}');
}

// Write the handles that have a position in the picture; a handle that no ray passes through has
// none.
static void write_handles(struct json *json, const struct window *window)
{
    const int *side = (const int[]){window->inputs.width, window->inputs.height};
    json_begin(json, "handles", '[');
    for (int i = 0; i < window->handles.count; i++) {
        const struct handle *handle = &window->handles.item[i];
        if (!handle->seen)
            continue;
        json_begin(json, NULL, '{');
        json_text(json, "name", handle->parameter->name);
        json_number(json, "x", (double)handle->pixel[0] / side[0], -1);
        json_number(json, "y", 1.0 - (double)handle->pixel[1] / side[1], -1);
        json_flag(json, "focused", i == window->handles.focused);
        json_end(json, '}');
    }
    json_end(json, ']');
}

static void write_kept(struct json *json, const struct window *window)
{
    json_begin(json, "kept", '{');
    json_number(json, "frame", window->inputs.frame, -1);
    json_number(json, "last", window_last_frame(window), -1);
    json_flag(json, "halves", passes_halves(window->renderer));
    json_end(json, '}');
}

static void write_window(struct json *json, const struct window *window)
{
    const struct renderer *renderer = window->renderer;
    const struct renderer_inputs *inputs = &window->inputs;
    const struct camera *camera = &inputs->camera;
    json_text(json, "view", shader_view_name(renderer->view));
    json_number(json, "time", inputs->time, -1);
    json_flag(json, "paused", window->paused);
    json_flag(json, "compiles", window->compiles);
    const double eye[] = {(double)camera->position[0], (double)camera->position[1],
                          (double)camera->position[2], (double)camera->pan, (double)camera->tilt};
    write_numbers(json, "camera", 5, eye);
    json_number(json, "rate", window->pace.rate, -1);
    json_number(json, "milliseconds", 1000.0 * window->pace.seconds, -1);
    json_number(json, "divisor", resolution_divisor(window->pace.resolution.level), -1);
    write_numbers(json, "size", 2, (const double[]){inputs->width, inputs->height});
    write_numbers(json, "pixel", 2, (const double[]){inputs->pixel[0], inputs->pixel[1]});
    json_number(json, "shown", floor((double)inputs->shown), -1);
    json_text(json, "why", inputs->pixel[0] >= 0 ? window->ray.why : "");
    json_flag(json, "halves", renderer->picture.format == GL_RGBA16F);
    if (window_keeps(window))
        write_kept(json, window);
    // Only a shader that records its marches has views other than the picture.
    int views = renderer->fragment.marches ? SHADER_VIEW_COUNT : VIEW_PICTURE + 1;
    json_begin(json, "views", '[');
    for (int view = 0; view < views; view++)
        json_text(json, NULL, shader_view_name((enum shader_view)view));
    json_end(json, ']');
    json_begin(json, "files", '[');
    for (int i = 0; i < renderer->fragment.file_count; i++)
        json_text(json, NULL, renderer->fragment.paths[i]);
    json_end(json, ']');
    json_begin(json, "parameters", '[');
    for (int i = 0; i < comparison_parameter_count(renderer); i++)
        write_parameter(json, renderer, i);
    json_end(json, ']');
    write_handles(json, window);
    json_flag(json, "tool", window_has_tool(window));
    if (inputs->pixel[0] >= 0 && window->ray.why[0] == '\0' && !window->ray.follow)
        write_probe(json, window->ray.probe);
}

void state_write(FILE *stream, const struct chapter *chapter, const struct window *window)
{
    struct json json = {.stream = stream};
    json_begin(&json, NULL, '{');
    json_flag(&json, "runs", window != NULL);
    json_text(&json, "title", chapter->title);
    json_text(&json, "shows", chapter->shows);
    json_text(&json, "error", window != NULL ? window->panel.error : report_last());
    json_text(&json, "unset", window != NULL ? window->renderer->fragment.unset : "");
    if (window != NULL)
        write_window(&json, window);
    json_end(&json, '}');
}
