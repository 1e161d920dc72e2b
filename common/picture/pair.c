#include "picture/pair.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "picture/pen.h"
#include "picture/plot.h"

#define GAP         6.0f  // units from the divider to a label
#define NARROW      24.0f // a label with less room than this is left out
#define GRIP_WIDTH  5.0f
#define GRIP_HEIGHT 22.0f

int pair_split(const struct renderer *renderer, int width)
{
    return renderer->pair != NULL ? (int)lround(renderer->pair->divider * width) : width;
}

struct renderer *pair_at(struct renderer *renderer, int width, int x)
{
    return x < pair_split(renderer, width) ? renderer : renderer->pair->other;
}

const char *pair_side_name(struct renderer *renderer, int width, int x)
{
    if (renderer->pair == NULL || x < 0)
        return NULL;
    return pair_at(renderer, width, x) == renderer ? "left" : "right";
}

// Does NAME=VALUE set the parameter of this name?
static bool sets(const char *setting, const char *name)
{
    size_t length = strlen(name);
    return strncmp(setting, name, length) == 0 && setting[length] == '=';
}

static bool is_own(const struct pair *pair, const char *name)
{
    for (int i = 0; i < pair->own_count; i++)
        if (sets(pair->own[i], name))
            return true;
    return false;
}

// The parameter of the first that one of the second follows; NULL: none.
static const struct parameter *leader_of(const struct renderer *renderer,
                                         const struct parameter *to)
{
    const struct parameter *from = parameters_find(&renderer->parameters, to->name);
    bool alike = from != NULL && from->type == to->type && from->components == to->components;
    return alike && !is_own(renderer->pair, to->name) ? from : NULL;
}

void pair_follow(const struct renderer *renderer)
{
    const struct pair *pair = renderer->pair;
    if (pair == NULL)
        return;
    struct renderer *other = pair->other;
    other->view = renderer->view;
    other->focal_length = renderer->focal_length;
    other->orthographic = renderer->orthographic;
    for (int i = 0; i < other->parameters.count; i++) {
        struct parameter *to = &other->parameters.item[i];
        const struct parameter *from = leader_of(renderer, to);
        for (int k = 0; from != NULL && k < to->components; k++)
            to->value[k] = fmin(fmax(from->value[k], to->minimum), to->maximum);
    }
}

// ---- What can be changed ----

// The second's parameter of this name where it does not follow; NULL: there is none.
static struct parameter *free_one(const struct renderer *renderer, const char *name)
{
    if (renderer->pair == NULL)
        return NULL;
    struct parameter *own = parameters_find(&renderer->pair->other->parameters, name);
    return own != NULL && leader_of(renderer, own) == NULL ? own : NULL;
}

struct parameter *pair_parameter(const struct renderer *renderer, int index)
{
    const struct parameters *first = &renderer->parameters;
    const struct parameters *second =
        renderer->pair != NULL ? &renderer->pair->other->parameters : NULL;
    for (int i = 0; i < first->count && index >= 0; i++) {
        struct parameter *own = free_one(renderer, first->item[i].name);
        if (index-- == 0)
            return &first->item[i];
        if (own != NULL && index-- == 0)
            return own;
    }
    for (int i = 0; second != NULL && i < second->count && index >= 0; i++)
        if (parameters_find(first, second->item[i].name) == NULL && index-- == 0)
            return &second->item[i];
    return NULL;
}

int pair_parameter_count(const struct renderer *renderer)
{
    int count = renderer->parameters.count;
    const struct parameters *second =
        renderer->pair != NULL ? &renderer->pair->other->parameters : NULL;
    for (int i = 0; second != NULL && i < second->count; i++)
        count += leader_of(renderer, &second->item[i]) == NULL;
    return count;
}

const struct parameters *pair_parameters_of(const struct renderer *renderer,
                                            const struct parameter *parameter)
{
    bool second = renderer->pair != NULL &&
                  parameters_find(&renderer->pair->other->parameters, parameter->name) == parameter;
    return second ? &renderer->pair->other->parameters : &renderer->parameters;
}

int pair_parameter_side(const struct renderer *renderer, const struct parameter *parameter)
{
    if (renderer->pair == NULL)
        return -1;
    if (pair_parameters_of(renderer, parameter) != &renderer->parameters)
        return 1;
    const struct parameter *to =
        parameters_find(&renderer->pair->other->parameters, parameter->name);
    return to != NULL && leader_of(renderer, to) != NULL ? -1 : 0;
}

void pair_parameter_name(const struct renderer *renderer, const struct parameter *parameter,
                         char *text, size_t size)
{
    int side = pair_parameter_side(renderer, parameter);
    snprintf(text, size, "%s%s", parameter->name,
             side < 0    ? ""
             : side == 0 ? " (left)"
                         : " (right)");
}

// ---- What is written ----

static bool is_changed(const struct parameter *parameter)
{
    for (int k = 0; k < parameter->components; k++)
        if (parameter->value[k] != parameter->initial[k])
            return true;
    return false;
}

// Does a side's label tell this parameter of it: because it is the second's own, or because the
// second alone has it, with a value that is not its file's?
static bool is_told(const struct renderer *renderer, int side, const struct parameter *parameter)
{
    if (is_own(renderer->pair, parameter->name))
        return true;
    return side == 1 && parameters_find(&renderer->parameters, parameter->name) == NULL &&
           is_changed(parameter);
}

void pair_text(const struct renderer *renderer, int side, char *text, size_t size)
{
    const struct pair *pair = renderer->pair;
    const struct renderer *drawn = side == 0 ? renderer : pair->other;
    snprintf(text, size, "%s", pair->label[side] != NULL ? pair->label[side] : "");
    for (int i = 0; i < drawn->parameters.count; i++) {
        const struct parameter *parameter = &drawn->parameters.item[i];
        char value[128];
        size_t used = strlen(text);
        if (!is_told(renderer, side, parameter))
            continue;
        parameter_value_text(parameter, value, sizeof value);
        snprintf(text + used, size - used, "%s%s=%s", used > 0 ? "  " : "", parameter->name, value);
    }
}

// Cut a text that is too long for its room.
static void fit(char *text, float room)
{
    size_t length = strlen(text);
    if (overlay_width(text) <= room)
        return;
    while (length > 0 && overlay_width(text) + overlay_width("…") > room) {
        length--;
        while (length > 0 && ((unsigned char)text[length] & 0xc0) == 0x80)
            length--; // the middle of a letter
        text[length] = '\0';
    }
    strcat(text, "…");
}

// One label, whose edge beside the divider is at a place.
//   room  units from there to the picture's edge
static void write_label(const struct renderer *renderer, struct overlay *overlay, int side,
                        float edge, float room, float top)
{
    char text[OVERLAY_TEXT + 8];
    pair_text(renderer, side, text, OVERLAY_TEXT);
    room -= PEN_MARGIN + 2.0f * PEN_PADDING;
    if (text[0] == '\0' || room < NARROW)
        return;
    fit(text, room);
    float width = ceilf(overlay_width(text));
    float left = side == 0 ? edge - width - 2.0f * PEN_PADDING : edge;
    struct pen pen = pen_open(overlay, left, top, width, OVERLAY_LINE - 2.0f);
    pen_write(&pen, text, PEN_BRIGHT);
}

static void write_divider(struct overlay *overlay, float at, bool gripped)
{
    float height = pen_picture_height(overlay);
    overlay_box(overlay, at - 1.5f, 0.0f, 3.0f, height, PEN_DARK);
    overlay_box(overlay, at - 0.5f, 0.0f, 1.0f, height, PEN_BRIGHT);
    if (!gripped)
        return;
    float top = 0.5f * (height - GRIP_HEIGHT), left = at - 0.5f * GRIP_WIDTH;
    overlay_box(overlay, left - 1.0f, top - 1.0f, GRIP_WIDTH + 2.0f, GRIP_HEIGHT + 2.0f, PEN_DARK);
    overlay_box(overlay, left, top, GRIP_WIDTH, GRIP_HEIGHT, PEN_BRIGHT);
}

float pair_write(const struct renderer *renderer, struct overlay *overlay, float top, float bottom)
{
    const struct pair *pair = renderer->pair;
    if (pair == NULL)
        return bottom;
    float width = pen_picture_width(overlay);
    if (renderer->view == SHADER_PLOT) // over its graph
        bottom = fminf(bottom, (1.0f - PLOT_SHARE) * pen_picture_height(overlay) - PEN_MARGIN);
    float at = (float)pair_split(renderer, overlay->width) / overlay->scale;
    float label = bottom - (OVERLAY_LINE - 2.0f) - 2.0f * PEN_PADDING;
    write_divider(overlay, at, pair->gripped);
    if (label < top)
        return bottom;
    write_label(renderer, overlay, 0, at - GAP, at - GAP, label);
    write_label(renderer, overlay, 1, at + GAP, width - at - GAP, label);
    return label - PEN_MARGIN;
}

void pair_gather(const struct renderer *renderer, struct overlay *overlay, int width, int height,
                 float scale)
{
    struct pair still = *renderer->pair;
    struct renderer shown = *renderer;
    still.gripped = false;
    shown.pair = &still;
    overlay_begin(overlay, width, height, scale);
    pair_write(&shown, overlay, 0.0f, pen_foot(overlay, renderer->view));
}
