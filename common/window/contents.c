#include "window/contents.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "picture/image.h"
#include "picture/pen.h"
#include "window/condition.h"
#include "window/panel_input.h"
#include "window/pointer.h"

#define ACROSS  8.0f      // between two pictures in a row, units
#define DOWN    5.0f      // between a name and the picture below it, units
#define HEADING 26.0f     // height of the line above the pictures, units
#define FOOTING 24.0f     // height of the line below them, units
#define LINE    13.0f     // height of one of the two lines of the name below a picture, units
#define NAME    28.0f     // height of both, with the gap above them, units
#define FRAME   2.0f      // width of the frame around the chosen picture, units
#define GAMMA   2.2       // near enough to sRGB for an average of pixels
#define LARGEST (1 << 24) // pixels of a picture's file

static const unsigned char background[3] = {20, 22, 27};

// ---- Layout ----

// The pictures of a sheet: as large as fit, in rows from the left.
struct layout {
    int columns, rows;
    float width, height; // of a picture, units
    float left, top;     // of the first picture, units
};

static float height_of_row(float width)
{
    return width * 9.0f / 16.0f + NAME;
}

static struct layout layout_of(const struct overlay *overlay, int count)
{
    const float width = pen_picture_width(overlay), height = pen_picture_height(overlay);
    struct layout best = {.columns = 1, .rows = count};
    for (int columns = 1; columns <= count; columns++) {
        int rows = (count + columns - 1) / columns;
        float room = height - HEADING - FOOTING;
        float across = (width - ACROSS * (float)(columns + 1)) / (float)columns;
        float down = ((room - DOWN * (float)(rows - 1)) / (float)rows - NAME) * 16.0f / 9.0f;
        float side = fminf(across, down);
        if (side > best.width)
            best = (struct layout){.columns = columns, .rows = rows, .width = side};
    }
    best.height = best.width * 9.0f / 16.0f;
    float all = (float)best.columns * (best.width + ACROSS) - ACROSS;
    float high = (float)best.rows * (height_of_row(best.width) + DOWN) - DOWN;
    best.left = 0.5f * (width - all);
    best.top = HEADING + 0.5f * fmaxf(height - HEADING - FOOTING - high, 0.0f);
    return best;
}

// The top left corner of a picture, in units.
static void corner_of(const struct layout *layout, int item, float corner[2])
{
    corner[0] = layout->left + (float)(item % layout->columns) * (layout->width + ACROSS);
    corner[1] =
        layout->top + (float)(item / layout->columns) * (height_of_row(layout->width) + DOWN);
}

// Return the item at a position, with its name, or -1 if there is none.
static int item_at(const struct layout *layout, int count, const float unit[2])
{
    for (int i = 0; i < count; i++) {
        float corner[2];
        corner_of(layout, i, corner);
        if (unit[0] >= corner[0] && unit[0] < corner[0] + layout->width && unit[1] >= corner[1] &&
            unit[1] < corner[1] + height_of_row(layout->width))
            return i;
    }
    return -1;
}

// ---- The pictures ----

// Write the average of a rectangle of a picture's pixels, of the light and not of the bytes.
//   light  the light of each byte
static void average(const struct image_bytes *from, const double light[256], const int low[2],
                    const int high[2], unsigned char to[3])
{
    double sum[3] = {0.0};
    for (int y = low[1]; y < high[1]; y++)
        for (int x = low[0]; x < high[0]; x++)
            for (int k = 0; k < 3; k++)
                sum[k] += light[from->value[3 * (y * from->width + x) + k]];
    double count = (double)(high[0] - low[0]) * (high[1] - low[1]);
    for (int k = 0; k < 3; k++)
        to[k] = (unsigned char)(255.0 * pow(sum[k] / count, 1.0 / GAMMA) + 0.5);
}

// Draw a file's picture into a part of the sheet. A picture that cannot be read is left out.
static void place(const char *path, struct image *sheet, const int low[2], const int size[2])
{
    struct image_bytes bytes;
    char why[IMAGE_WHY];
    double light[256];
    for (int i = 0; i < 256; i++)
        light[i] = pow(i / 255.0, GAMMA);
    if (!image_read_bytes(&bytes, path, 3, LARGEST, why))
        return;
    for (int y = 0; y < size[1]; y++)
        for (int x = 0; x < size[0]; x++) {
            const int from[2] = {x * bytes.width / size[0], y * bytes.height / size[1]};
            const int to[2] = {(x + 1) * bytes.width / size[0], (y + 1) * bytes.height / size[1]};
            const int high[2] = {to[0] > from[0] ? to[0] : from[0] + 1,
                                 to[1] > from[1] ? to[1] : from[1] + 1};
            size_t at = (size_t)(low[1] + y) * (size_t)sheet->width + (size_t)(low[0] + x);
            average(&bytes, light, from, high, &sheet->pixel[3 * at]);
        }
    free(bytes.value);
}

// Upload the sheet's pictures into the target, bottom row first.
static void upload(const struct gl *gl, const struct target *target, const struct image *sheet)
{
    unsigned char *rows = memory_zeros((size_t)sheet->width * (size_t)sheet->height, 4);
    for (int y = 0; y < sheet->height; y++)
        for (int x = 0; x < sheet->width; x++) {
            size_t from = (size_t)y * (size_t)sheet->width + (size_t)x;
            size_t to = (size_t)(sheet->height - 1 - y) * (size_t)sheet->width + (size_t)x;
            memcpy(rows + 4 * to, sheet->pixel + 3 * from, 3);
        }
    gl->BindTexture(GL_TEXTURE_2D, target->texture);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, sheet->width, sheet->height, 0, GL_RGBA,
                   GL_UNSIGNED_BYTE, rows);
    free(rows);
}

// Draw all pictures again if the window has another size. Returns false after reporting the error.
static bool update_sheet(struct window *window, const struct layout *layout)
{
    struct target *target = &window->contents.sheet;
    const struct contents *of = window->start->contents;
    const struct gl *gl = window->renderer->gl;
    const float scale = window->panel.overlay.scale;
    const int width = window->inputs.width, height = window->inputs.height;
    struct image sheet;
    if (target->framebuffer == 0)
        target_open(target, gl, GL_RGBA8);
    if (window->contents.of == of && target->width == width && target->height == height)
        return true;
    if (!target_bind(target, gl, width, height) || !image_create(&sheet, width, height))
        return false;
    for (int i = 0; i < width * height; i++)
        memcpy(&sheet.pixel[3 * i], background, sizeof background);
    const int size[2] = {(int)(layout->width * scale), (int)(layout->height * scale)};
    for (int i = 0; i < of->count; i++) {
        float corner[2];
        corner_of(layout, i, corner);
        const int low[2] = {(int)(corner[0] * scale), (int)(corner[1] * scale)};
        if (low[0] >= 0 && low[1] >= 0 && low[0] + size[0] <= width && low[1] + size[1] <= height)
            place(of->item[i].picture, &sheet, low, size);
    }
    upload(gl, target, &sheet);
    image_free(&sheet);
    window->contents.of = of;
    return true;
}

// ---- The sheet ----

void window_toggle_contents(struct window *window)
{
    window->contents.open = window_has_contents(window) && !window->contents.open;
    if (window->contents.open)
        window->contents.chosen = window->start->scene;
    window->stale |= !window->contents.open;
    window->dirty = true;
}

static void open_chosen(struct window *window)
{
    window->asked.scene = window->contents.chosen + 1;
    window_toggle_contents(window);
}

// Move the frame, which stops at the first and the last item.
static void choose(struct window *window, int by)
{
    int to = window->contents.chosen + by;
    if (to >= 0 && to < window->start->contents->count)
        window->contents.chosen = to;
}

static bool press(struct window *window, int key, int columns)
{
    if (key == GLFW_KEY_LEFT || key == GLFW_KEY_RIGHT)
        choose(window, key == GLFW_KEY_LEFT ? -1 : 1);
    else if (key == GLFW_KEY_UP || key == GLFW_KEY_DOWN)
        choose(window, key == GLFW_KEY_UP ? -columns : columns);
    else if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER)
        open_chosen(window);
    else if (key == GLFW_KEY_ESCAPE || key == GLFW_KEY_HOME)
        window_toggle_contents(window);
    else // the others do what they do elsewhere: the next chapter, full screen, quit
        return key != GLFW_KEY_PAGE_UP && key != GLFW_KEY_PAGE_DOWN && key != GLFW_KEY_F11 &&
               key != GLFW_KEY_BACKSPACE;
    return true;
}

bool window_contents_input(struct window *window, struct window_event *event)
{
    if (!window->contents.open)
        return false;
    const int count = window->start->contents->count;
    const struct layout layout = layout_of(&window->panel.overlay, count);
    window->dirty = true;
    if (event->kind == EVENT_KEY)
        return press(window, event->amount, layout.columns);
    if (event->kind == EVENT_HOVER || event->kind == EVENT_PRESS || event->kind == EVENT_RELEASE) {
        window_pointer_locate(window, event);
        window_panel_hover(window, event);
        int item = item_at(&layout, count, event->unit);
        if (item >= 0)
            window->contents.chosen = item;
        if (item >= 0 && event->kind == EVENT_RELEASE && event->amount == 1)
            open_chosen(window);
    }
    return true;
}

// Write a line of text in the middle of the sheet's width.
static void write_middle(struct overlay *overlay, float top, const char *text,
                         struct overlay_colour colour)
{
    float left = 0.5f * (pen_picture_width(overlay) - overlay_width(text));
    overlay_text(overlay, fmaxf(left, PEN_MARGIN), top, text, colour);
}

// Copy a text, with an ellipsis instead of the letters that do not fit into a width.
static void shorten(const char *text, float width, char line[OVERLAY_TEXT + 1])
{
    int length = (int)strlen(text);
    snprintf(line, OVERLAY_TEXT + 1, "%s", text);
    while (overlay_width(line) > width && length > 0) {
        while (--length > 0 &&
               (text[length - 1] == ' ' || ((unsigned char)text[length] & 0xC0) == 0x80))
            continue;
        snprintf(line, OVERLAY_TEXT + 1, "%.*s…", length, text);
    }
}

// Write a name below a picture in one line or, if it is too long, in two.
static void write_name(struct overlay *overlay, const float corner[2], const struct layout *layout,
                       const char *name, struct overlay_colour colour)
{
    char words[OVERLAY_TEXT + 1], line[OVERLAY_TEXT + 1], *blank;
    const float left = corner[0], top = corner[1] + layout->height + 3.0f;
    snprintf(words, sizeof words, "%s", name);
    while (overlay_width(words) > layout->width && (blank = strrchr(words, ' ')) != NULL)
        *blank = '\0';
    const char *rest = name + strlen(words);
    shorten(words, layout->width, line);
    overlay_text(overlay, left, top, line, colour);
    shorten(rest + strspn(rest, " "), layout->width, line);
    overlay_text(overlay, left, top + LINE, line, colour);
}

// Draw the frame of the chosen picture.
static void write_frame(struct overlay *overlay, const float corner[2], const struct layout *layout)
{
    const float right = layout->width + FRAME, below = layout->height + FRAME;
    overlay_box(overlay, corner[0] - FRAME, corner[1] - FRAME, right + FRAME, FRAME, PEN_BRIGHT);
    overlay_box(overlay, corner[0] - FRAME, corner[1] + below - FRAME, right + FRAME, FRAME,
                PEN_BRIGHT);
    overlay_box(overlay, corner[0] - FRAME, corner[1] - FRAME, FRAME, below + FRAME, PEN_BRIGHT);
    overlay_box(overlay, corner[0] + right - FRAME, corner[1] - FRAME, FRAME, below + FRAME,
                PEN_BRIGHT);
}

bool window_contents_draw(struct window *window)
{
    const struct gl *gl = window->renderer->gl;
    const struct contents *of = window->start->contents;
    const int width = window->inputs.width, height = window->inputs.height;
    const int chosen = window->contents.chosen;
    char about[OVERLAY_TEXT + 1];
    struct overlay *overlay = &window->panel.overlay;
    double scale = window->start->overlay_scale;
    overlay_begin(overlay, width, height, scale > 0.0 ? (float)scale : overlay_scale_of(height));
    struct layout layout = layout_of(overlay, of->count);
    if (!update_sheet(window, &layout))
        return false;
    write_middle(overlay, 9.0f, "arrow keys or mouse: choose    Enter or click: open    Home: back",
                 PEN_DIM);
    for (int i = 0; i < of->count; i++) {
        float corner[2];
        corner_of(&layout, i, corner);
        if (i == chosen)
            write_frame(overlay, corner, &layout);
        write_name(overlay, corner, &layout, of->item[i].name,
                   i == chosen ? PEN_BRIGHT : PEN_PLAIN);
    }
    snprintf(about, sizeof about, "%s: %s", of->item[chosen].name, of->item[chosen].shows);
    write_middle(overlay, pen_picture_height(overlay) - 17.0f, about, PEN_BRIGHT);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, window->contents.sheet.framebuffer);
    gl->BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl->BindFramebuffer(GL_FRAMEBUFFER, 0);
    overlay_draw(overlay, 0, height);
    return true;
}

void window_contents_close(struct window *window)
{
    if (window->contents.sheet.framebuffer != 0)
        target_close(&window->contents.sheet, window->panel.overlay.gl);
}
