#include "picture/pen.h"

#include <string.h>

#include "picture/slice.h"

static const struct overlay_colour PEN_BACKGROUND = {{10, 12, 16, 192}};
static const struct overlay_colour PEN_RULE = {{255, 255, 255, 46}};

float pen_picture_width(const struct overlay *overlay)
{
    return (float)overlay->width / overlay->scale;
}

float pen_picture_height(const struct overlay *overlay)
{
    return (float)overlay->height / overlay->scale;
}

float pen_foot(const struct overlay *overlay, enum shader_view view)
{
    float axis = shader_shows_ray(view) ? SLICE_AXIS * slice_cell(overlay->height) : 0.0f;
    return pen_picture_height(overlay) - axis / overlay->scale - PEN_MARGIN;
}

struct pen pen_open(struct overlay *overlay, float left, float top, float width, float height)
{
    overlay_box(overlay, left, top, width + 2.0f * PEN_PADDING, height + 2.0f * PEN_PADDING,
                PEN_BACKGROUND);
    return (struct pen){overlay, left + PEN_PADDING, top + PEN_PADDING + 1.0f};
}

void pen_write(struct pen *pen, const char *text, struct overlay_colour colour)
{
    overlay_text(pen->overlay, pen->left, pen->top, text, colour);
    pen->top += OVERLAY_LINE;
}

void pen_rule(struct pen *pen, float width)
{
    overlay_box(pen->overlay, pen->left, pen->top + 1.0f, width, 1.0f, PEN_RULE);
    pen->top += 0.5f * OVERLAY_LINE;
}

bool pen_next_line(const char **text, float limit, char line[OVERLAY_TEXT + 1])
{
    const char *begin = *text, *end = begin;
    float width = 0.0f;
    if (*begin == '\0')
        return false;
    while (*end != '\0' && *end != '\n') {
        const char *behind = end;
        width += letters_advance(letters_next(&behind));
        if (behind - begin > OVERLAY_TEXT || (width > limit && end > begin))
            break;
        end = behind;
    }
    const char *blank = end;
    while (strchr("\n ", *blank) == NULL && blank > begin)
        blank--;
    if (blank > begin)
        end = blank;
    memcpy(line, begin, (size_t)(end - begin));
    line[end - begin] = '\0';
    *text = *end == '\n' ? end + 1 : end + strspn(end, " ");
    return true;
}
