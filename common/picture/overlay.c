#include "picture/overlay.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "report.h"
#include "shader/compile.h"

// A tile's corner in the target, in pixels; the texture has its pixels in the same place.
struct corner {
    float x, y;
};

static const char vertex_text[] = GL_GLSL "layout(location = 0) in vec2 corner;\n"
                                          "uniform vec2 size;\n"
                                          "out vec2 place;\n"
                                          "void main()\n"
                                          "{\n"
                                          "    place = corner / size;\n"
                                          "    gl_Position = vec4(2.0 * place - 1.0, 0.0, 1.0);\n"
                                          "}\n";

// Nothing but a read: llvmpipe then takes a way that is several times as fast.
static const char fragment_text[] = GL_GLSL "uniform sampler2D tiles;\n"
                                            "in vec2 place;\n"
                                            "out vec4 fragment;\n"
                                            "void main()\n"
                                            "{\n"
                                            "    fragment = texture(tiles, place);\n"
                                            "}\n";

// The order in which the framebuffer of most windows has its channels is the quickest to copy. With
// GL_RGBA for both, unlike with GL_RGBA8, a driver may keep them in that order.
#if GL_IS_ES
#define ORDER GL_RGBA
#else
#define ORDER GL_BGRA
#endif

static GLuint link_program(const struct gl *gl)
{
    enum shader_step step;
    char *log;
    GLuint program = shader_link_texts(gl, vertex_text, fragment_text, &step, &log);
    if (program == 0)
        report("overlay: the driver does not take its shader: try another --backend: %.800s",
               log != NULL ? log : "");
    free(log);
    return program;
}

bool overlay_open(struct overlay *overlay, const struct gl *gl)
{
    *overlay = (struct overlay){.gl = gl, .program = link_program(gl)};
    if (overlay->program == 0)
        return false;
    gl->GenVertexArrays(1, &overlay->vertex_array);
    gl->GenBuffers(1, &overlay->buffer);
    gl->BindVertexArray(overlay->vertex_array);
    gl->BindBuffer(GL_ARRAY_BUFFER, overlay->buffer);
    gl->VertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, sizeof(struct corner), NULL);
    gl->EnableVertexAttribArray(0);
    gl->GenTextures(1, &overlay->texture);
    overlay->letters = memory_zeros(1, sizeof *overlay->letters);
    overlay->tiles = memory_zeros(1, sizeof *overlay->tiles);
    return true;
}

void overlay_close(struct overlay *overlay)
{
    if (overlay->program != 0) {
        overlay->gl->DeleteTextures(1, &overlay->texture);
        overlay->gl->DeleteBuffers(1, &overlay->buffer);
        overlay->gl->DeleteVertexArrays(1, &overlay->vertex_array);
        overlay->gl->DeleteProgram(overlay->program);
        letters_close(overlay->letters);
        free(overlay->letters);
        tiles_close(overlay->tiles);
        free(overlay->tiles);
    }
    free(overlay->rectangle);
    *overlay = (struct overlay){0};
}

float overlay_scale_of(int height)
{
    float scale = 1.0f + 0.5f * ceilf((float)(height - 480) / 180.0f);
    return fminf(fmaxf(scale, 1.0f), (float)OVERLAY_SCALE_MAXIMUM);
}

void overlay_begin(struct overlay *overlay, int width, int height, float scale)
{
    overlay->width = width;
    overlay->height = height;
    overlay->scale = scale;
    overlay->count = 0;
}

static void add(struct overlay *overlay, struct overlay_rectangle rectangle)
{
    overlay->rectangle = memory_row(overlay->rectangle, overlay->count, sizeof *overlay->rectangle);
    overlay->rectangle[overlay->count++] = rectangle;
}

void overlay_box(struct overlay *overlay, float left, float top, float width, float height,
                 struct overlay_colour colour)
{
    add(overlay, (struct overlay_rectangle){left, top, left + width, top + height, colour, 0, 0});
}

void overlay_line(struct overlay *overlay, const float from[2], const float to[2], float width,
                  struct overlay_colour colour)
{
    add(overlay, (struct overlay_rectangle){from[0], from[1], to[0], to[1], colour, 0, width});
}

float overlay_width(const char *text)
{
    float width = 0.0f;
    for (const char *at = text; *at != '\0' && at < text + OVERLAY_TEXT;)
        width += letters_advance(letters_next(&at));
    return width;
}

void overlay_text(struct overlay *overlay, float left, float top, const char *text,
                  struct overlay_colour colour)
{
    for (const char *at = text; *at != '\0' && at < text + OVERLAY_TEXT;) {
        uint32_t letter = letters_next(&at);
        float right = left + letters_advance(letter);
        if (letter != ' ')
            add(overlay, (struct overlay_rectangle){left, top, right, top + OVERLAY_LINE, colour,
                                                    letter, 0});
        left = right;
    }
}

// A letter begins at the nearest quarter of a pixel and stands on a whole one.
//   up  pixels from the target's bottom row to the picture's top
static struct tiles_shape shape_of(const struct overlay *overlay,
                                   const struct overlay_rectangle *rectangle, float up)
{
    float scale = overlay->scale;
    struct tiles_shape shape = {.letter = {-1, -1}};
    memcpy(shape.colour, rectangle->colour.channel, sizeof shape.colour);
    if (rectangle->letter == 0) {
        bool line = rectangle->width > 0.0f;
        shape.left = scale * rectangle->left;
        shape.right = scale * rectangle->right;
        shape.low = up - scale * (line ? rectangle->top : rectangle->bottom);
        shape.high = up - scale * (line ? rectangle->bottom : rectangle->top);
        shape.width = scale * rectangle->width;
        return shape;
    }
    int begin = (int)floorf(LETTERS_PHASES * scale * rectangle->left + 0.5f);
    int pixel = (int)floorf((float)begin / LETTERS_PHASES), phase = begin - LETTERS_PHASES * pixel;
    const struct letter *letter = letters_find(overlay->letters, rectangle->letter, phase);
    float line = floorf(scale * (rectangle->top + LETTERS_BASELINE) + 0.5f);
    shape.left = (float)(pixel + letter->left);
    shape.right = shape.left + (float)letter->width;
    shape.high = up - line - (float)letter->top;
    shape.low = shape.high - (float)letter->height;
    shape.letter[0] = letter->x;
    shape.letter[1] = letter->y;
    return shape;
}

// Bring the texture to this frame.
static void paint_tiles(const struct overlay *overlay, int bottom, int rows)
{
    const struct gl *gl = overlay->gl;
    struct tiles *tiles = overlay->tiles;
    unsigned char pixel[TILES_SIDE * TILES_SIDE * 4];
    if (tiles->width != overlay->width || tiles->height != rows) {
        int width = (overlay->width + TILES_SIDE - 1) / TILES_SIDE * TILES_SIDE;
        int height = (rows + TILES_SIDE - 1) / TILES_SIDE * TILES_SIDE;
        gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, width, height, 0, ORDER, GL_UNSIGNED_BYTE, NULL);
        gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }
    tiles_begin(tiles, overlay->width, rows);
    // The images of letters at another scale may have the places of others.
    if (overlay->letters->scale != overlay->scale)
        tiles_forget(tiles);
    letters_begin(overlay->letters, overlay->scale);
    for (int i = 0; i < overlay->count; i++) {
        const struct tiles_shape shape =
            shape_of(overlay, &overlay->rectangle[i], (float)(overlay->height - bottom));
        tiles_add(tiles, &shape);
    }
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    for (int at = 0; tiles_paint(tiles, &at, overlay->letters->pixel, pixel); at++) {
        for (int i = 0; i < TILES_SIDE * TILES_SIDE && ORDER != GL_RGBA; i++) {
            unsigned char red = pixel[4 * i];
            pixel[4 * i] = pixel[4 * i + 2];
            pixel[4 * i + 2] = red;
        }
        gl->TexSubImage2D(GL_TEXTURE_2D, 0, at % tiles->columns * TILES_SIDE,
                          at / tiles->columns * TILES_SIDE, TILES_SIDE, TILES_SIDE, ORDER,
                          GL_UNSIGNED_BYTE, pixel);
    }
}

// Two triangles for each run of tiles. Returns how many corners.
static GLsizei hand_over_corners(const struct overlay *overlay)
{
    static const float across[] = {0, 1, 0, 0, 1, 1}, up[] = {0, 0, 1, 1, 0, 1};
    const struct tiles *tiles = overlay->tiles;
    struct corner *corner = NULL;
    int count = 0, run;
    for (int at = 0; (run = tiles_run(tiles, &at)) > 0; at += run)
        for (int i = 0; i < 6; i++) {
            corner = memory_row(corner, count, sizeof *corner);
            corner[count++] = (struct corner){
                TILES_SIDE * ((float)(at % tiles->columns) + across[i] * (float)run),
                TILES_SIDE * ((float)(at / tiles->columns) + up[i])};
        }
    overlay->gl->BufferData(GL_ARRAY_BUFFER, count * (GLsizeiptr)sizeof *corner, corner,
                            GL_STREAM_DRAW);
    free(corner);
    return count;
}

void overlay_draw(const struct overlay *overlay, int bottom, int rows)
{
    const struct gl *gl = overlay->gl;
    GLuint program = overlay->program;
    if (overlay->count == 0)
        return;
    gl->BindTexture(GL_TEXTURE_2D, overlay->texture);
    paint_tiles(overlay, bottom, rows);
    const struct tiles *tiles = overlay->tiles;
    int width = tiles->columns * TILES_SIDE, height = tiles->rows * TILES_SIDE;
    gl->UseProgram(program);
    gl->Uniform2f(gl->GetUniformLocation(program, "size"), (float)width, (float)height);
    gl->Uniform1i(gl->GetUniformLocation(program, "tiles"), 0);
    gl->BindVertexArray(overlay->vertex_array);
    gl->BindBuffer(GL_ARRAY_BUFFER, overlay->buffer);
    GLsizei corners = hand_over_corners(overlay);
    gl->Viewport(0, 0, width, height);
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl->DrawArrays(GL_TRIANGLES, 0, corners);
    gl->Disable(GL_BLEND);
    gl->BindTexture(GL_TEXTURE_2D, 0);
}
