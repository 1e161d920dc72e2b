#include "browser/state.h"

#include <math.h>

#include "browser/hands.h"
#include "picture/pair.h"
#include "report.h"
#include "window/state.h"
#include "window/window.h"

void state_string(FILE *stream, const char *text)
{
    fputc('"', stream);
    for (; *text != '\0'; text++)
        if ((unsigned char)*text < ' ')
            fprintf(stream, "\\u%04x", (unsigned)*text);
        else
            fprintf(stream, *text == '"' || *text == '\\' ? "\\%c" : "%c", *text);
    fputc('"', stream);
}

static void text(FILE *stream, const char *name, const char *value)
{
    fprintf(stream, ",\"%s\":", name);
    state_string(stream, value != NULL ? value : "");
}

// JSON knows no infinity and nothing that is no number.
static void number(FILE *stream, double value)
{
    if (isfinite(value))
        fprintf(stream, "%.9g", value);
    else
        fputs("null", stream);
}

static void numbers(FILE *stream, const char *name, int count, const double *value)
{
    fprintf(stream, ",\"%s\":[", name);
    for (int i = 0; i < count; i++) {
        fputs(i > 0 ? "," : "", stream);
        number(stream, value[i]);
    }
    fputs("]", stream);
}

static void one(FILE *stream, const char *name, double value)
{
    fprintf(stream, ",\"%s\":", name);
    number(stream, value);
}

static void yes(FILE *stream, const char *name, bool value)
{
    fprintf(stream, ",\"%s\":%s", name, value ? "true" : "false");
}

static void write_parameter(FILE *stream, const struct renderer *renderer, int index)
{
    const struct parameter *p = pair_parameter(renderer, index);
    char name[STATE_NAME];
    pair_parameter_name(renderer, p, name, sizeof name);
    static const char *const types[] = {
        [PARAMETER_FLOAT] = "float", [PARAMETER_INT] = "int", [PARAMETER_BOOL] = "bool"};
    fprintf(stream, "{\"type\":\"%s\"", types[p->type]);
    text(stream, "name", name);
    numbers(stream, "value", p->components, p->value);
    numbers(stream, "initial", p->components, p->initial);
    one(stream, "minimum", p->minimum);
    one(stream, "maximum", p->maximum);
    one(stream, "step", p->step);
    yes(stream, "multiplies", p->multiplies);
    text(stream, "unit", p->unit);
    text(stream, "meaning", p->meaning);
    fputs("}", stream);
}

static void write_probe(FILE *stream, const struct probe *probe)
{
    fprintf(stream,
            ",\"probe\":{\"recorded\":%s,\"steps\":%d,\"all_steps\":%d,\"evaluations\":%d,"
            "\"colour\":[%d,%d,%d]",
            probe->recorded ? "true" : "false", probe->steps, probe->all_steps, probe->evaluations,
            probe->colour[0], probe->colour[1], probe->colour[2]);
    text(stream, "outcome", probe->recorded ? probe_outcome(probe) : "");
    fputs(",\"march\":[", stream);
    for (int i = 0; probe->recorded && i < probe_rows(probe); i++) {
        const struct probe_step *step = &probe->step[i];
        const double row[] = {(double)step->t, (double)step->distance, (double)step->position[0],
                              (double)step->position[1], (double)step->position[2]};
        for (int k = 0; k < 5; k++) {
            fputs(k > 0 ? "," : i > 0 ? ",[" : "[", stream);
            number(stream, row[k]);
        }
        fputs("]", stream);
    }
    fputs("]}", stream);
}

// The views to choose from: the picture alone where a text has a main of its own.
static void write_views(FILE *stream, enum shader_form form)
{
    int count = form == SHADER_COURSE ? SHADER_VIEW_COUNT : SHADER_PICTURE + 1;
    for (int view = 0; view < count; view++) {
        fputs(view > 0 ? "," : ",\"views\":[", stream);
        state_string(stream, shader_view_name((enum shader_view)view));
    }
    fputs("]", stream);
}

static void write_window(FILE *stream, const struct window *window)
{
    const struct renderer *renderer = window->renderer;
    const struct renderer_inputs *inputs = &window->inputs;
    const struct camera *camera = &inputs->camera;
    text(stream, "view", shader_view_name(renderer->view));
    one(stream, "time", inputs->time);
    yes(stream, "paused", window->paused);
    const double eye[] = {(double)camera->position[0], (double)camera->position[1],
                          (double)camera->position[2], (double)camera->pan, (double)camera->tilt};
    numbers(stream, "camera", 5, eye);
    one(stream, "rate", window->pace.rate);
    one(stream, "milliseconds", 1000.0 * window->pace.seconds);
    one(stream, "divisor", resolution_divisor(window->pace.resolution.level));
    numbers(stream, "size", 2, (const double[]){inputs->width, inputs->height});
    numbers(stream, "pixel", 2, (const double[]){inputs->pixel[0], inputs->pixel[1]});
    one(stream, "shown", floor((double)inputs->shown));
    text(stream, "why", inputs->pixel[0] >= 0 ? window->ray.why : "");
    yes(stream, "halves", live_halves() != 0);
    write_views(stream, renderer->fragment.form);
    fputs(",\"files\":[", stream);
    for (int i = 0; i < renderer->fragment.file_count; i++) {
        fputs(i > 0 ? "," : "", stream);
        state_string(stream, renderer->fragment.paths[i]);
    }
    fputs("],\"parameters\":[", stream);
    for (int i = 0; i < pair_parameter_count(renderer); i++) {
        fputs(i > 0 ? "," : "", stream);
        write_parameter(stream, renderer, i);
    }
    fputs("]", stream);
    if (inputs->pixel[0] >= 0 && window->ray.why[0] == '\0' && !window->ray.follow)
        write_probe(stream, window->ray.probe);
}

void state_write(FILE *stream, const struct chapter *chapter, const struct window *window)
{
    fprintf(stream, "{\"runs\":%s", window != NULL ? "true" : "false");
    text(stream, "title", chapter->title);
    text(stream, "shows", chapter->shows);
    text(stream, "error", window != NULL ? window->panel.error : report_last());
    if (window != NULL)
        write_window(stream, window);
    fputs("}", stream);
}
