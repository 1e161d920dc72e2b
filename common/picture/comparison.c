#include "picture/comparison.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "memory.h"
#include "picture/pen.h"
#include "picture/slice.h"

#define GAP         6.0f  // distance from the divider to a label, units
#define NARROW      24.0f // units; a label with less room is left out
#define GRIP_WIDTH  5.0f
#define GRIP_HEIGHT 22.0f

const char *comparison_side_name(struct renderer *renderer, int width, int x)
{
    if (renderer->comparison == NULL || x < 0)
        return NULL;
    return renderer_at(renderer, width, x) == renderer ? "left" : "right";
}

// True if one of the second picture's settings, NAME=VALUE, sets the parameter with this name.
static bool is_own(const struct comparison *comparison, const char *name)
{
    size_t length = strlen(name);
    for (int i = 0; i < comparison->own_count; i++)
        if (strncmp(comparison->own[i], name, length) == 0 && comparison->own[i][length] == '=')
            return true;
    return false;
}

// Return the second picture's parameters, or NULL if there is no second picture.
static const struct parameters *second_of(const struct renderer *renderer)
{
    return renderer->comparison != NULL ? &renderer->comparison->other->parameters : NULL;
}

// Return the first picture's parameter that a parameter of the second picture follows, or NULL if
// there is none.
static const struct parameter *leader_of(const struct renderer *renderer,
                                         const struct parameter *to)
{
    const struct parameter *from = parameters_find(&renderer->parameters, to->name);
    bool alike = from != NULL && from->type == to->type && from->components == to->components;
    return alike && !is_own(renderer->comparison, to->name) ? from : NULL;
}

void comparison_follow(const struct renderer *renderer)
{
    const struct comparison *comparison = renderer->comparison;
    if (comparison == NULL)
        return;
    struct renderer *other = comparison->other;
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

// ---- The parameters of both pictures ----

struct parameter *comparison_parameter(const struct renderer *renderer, int index)
{
    const struct parameters *first = &renderer->parameters, *second = second_of(renderer);
    struct parameter *own;
    for (int i = 0; i < first->count && index >= 0; i++) {
        if (index-- == 0)
            return &first->item[i];
        own = second != NULL ? parameters_find(second, first->item[i].name) : NULL;
        if (own != NULL && leader_of(renderer, own) == NULL && index-- == 0)
            return own;
    }
    for (int i = 0; second != NULL && i < second->count && index >= 0; i++)
        if (parameters_find(first, second->item[i].name) == NULL && index-- == 0)
            return &second->item[i];
    return NULL;
}

int comparison_parameter_count(const struct renderer *renderer)
{
    int count = 0;
    while (comparison_parameter(renderer, count) != NULL)
        count++;
    return count;
}

const struct parameters *comparison_parameters_of(const struct renderer *renderer,
                                                  const struct parameter *parameter)
{
    const struct parameters *second = second_of(renderer);
    return second != NULL && parameters_find(second, parameter->name) == parameter
               ? second
               : &renderer->parameters;
}

int comparison_parameter_side(const struct renderer *renderer, const struct parameter *parameter)
{
    const struct parameters *second = second_of(renderer);
    if (second == NULL)
        return -1;
    const struct parameter *to = parameters_find(second, parameter->name);
    return to == parameter ? 1 : to != NULL && leader_of(renderer, to) != NULL ? -1 : 0;
}

void comparison_parameter_name(const struct renderer *renderer, const struct parameter *parameter,
                               char *text, size_t size)
{
    static const char *const side[] = {"", " (left)", " (right)"};
    snprintf(text, size, "%s%s", parameter->name,
             side[1 + comparison_parameter_side(renderer, parameter)]);
}

// ---- The divider and the labels ----

static bool is_changed(const struct parameter *parameter)
{
    for (int k = 0; k < parameter->components; k++)
        if (parameter->value[k] != parameter->initial[k])
            return true;
    return false;
}

// True if a side's label shows this parameter: the second picture sets it itself, or only the
// second picture has it and its value differs from the one in its file.
static bool is_shown(const struct renderer *renderer, int side, const struct parameter *parameter)
{
    if (is_own(renderer->comparison, parameter->name))
        return true;
    return side == 1 && parameters_find(&renderer->parameters, parameter->name) == NULL &&
           is_changed(parameter);
}

void comparison_text(const struct renderer *renderer, int side, char *text, size_t size)
{
    const struct comparison *comparison = renderer->comparison;
    const struct renderer *drawn = side == 0 ? renderer : comparison->other;
    snprintf(text, size, "%s", comparison->label[side] != NULL ? comparison->label[side] : "");
    for (int i = 0; i < drawn->parameters.count; i++) {
        const struct parameter *parameter = &drawn->parameters.item[i];
        char value[128];
        if (!is_shown(renderer, side, parameter))
            continue;
        parameter_value_text(parameter, value, sizeof value);
        memory_append(text, size, "%s%s=%s", text[0] != '\0' ? "  " : "", parameter->name, value);
    }
}

// Shorten text that is wider than the room, and end it with an ellipsis.
static void fit(char *text, float room)
{
    size_t length = strlen(text);
    if (overlay_width(text) <= room)
        return;
    while (length > 0 && overlay_width(text) + overlay_width("…") > room) {
        length--;
        while (length > 0 && ((unsigned char)text[length] & 0xc0) == 0x80)
            length--; // never cut between the bytes of a letter
        text[length] = '\0';
    }
    strcat(text, "…");
}

// Write one label.
//   edge  the label's edge beside the divider, units
//   room  distance from that edge to the picture's edge, units
static void write_label(const struct renderer *renderer, struct overlay *overlay, int side,
                        float edge, float room, float top)
{
    char text[OVERLAY_TEXT + 8];
    comparison_text(renderer, side, text, OVERLAY_TEXT);
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

float comparison_write(const struct renderer *renderer, struct overlay *overlay, float top,
                       float bottom)
{
    const struct comparison *comparison = renderer->comparison;
    if (comparison == NULL)
        return bottom;
    float width = pen_picture_width(overlay);
    if (renderer->view == VIEW_PLOT) // keep the labels above the plot's graph
        bottom = fminf(bottom, (1.0f - SLICE_PLOT) * pen_picture_height(overlay) - PEN_MARGIN);
    float at = (float)renderer_split(renderer, overlay->width) / overlay->scale;
    float label = bottom - (OVERLAY_LINE - 2.0f) - 2.0f * PEN_PADDING;
    write_divider(overlay, at, comparison->gripped);
    if (label < top)
        return bottom;
    write_label(renderer, overlay, 0, at - GAP, at - GAP, label);
    write_label(renderer, overlay, 1, at + GAP, width - at - GAP, label);
    return label - PEN_MARGIN;
}

void comparison_gather(const struct renderer *renderer, struct overlay *overlay, int width,
                       int height, float scale)
{
    struct comparison still = *renderer->comparison;
    struct renderer shown = *renderer;
    still.gripped = false;
    shown.comparison = &still;
    overlay_begin(overlay, width, height, scale);
    comparison_write(&shown, overlay, 0.0f, pen_foot(overlay, renderer->view));
}
