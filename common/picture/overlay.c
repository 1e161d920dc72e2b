#include "picture/overlay.h"

#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "picture/target.h"

// One instance: a box, a letter's image, or a line from (left, low) to (right, high).
struct shape {
    float left, low, right, high; // pixels from the target's bottom left
    float letter[2];              // top left of the letter's image in the atlas; -1 if not a letter
    float width;                  // width of a line, pixels; 0 if not a line
    unsigned char colour[4];      // red, green, blue, opacity
};

// Vertices 0 to 3 are the corners of the rectangle of pixels that the shape may touch; for a line,
// the rectangle is aligned with the line.
static const char vertex_text[] =
    GL_GLSL "layout(location = 0) in vec4 ends;\n"
            "layout(location = 1) in vec3 kind;\n"
            "layout(location = 2) in vec4 tint;\n"
            "uniform vec2 size;\n"
            "flat out vec4 shapeEnds, shapeTint;\n"
            "flat out vec3 shapeKind;\n"
            "void main()\n"
            "{\n"
            "    vec2 side = vec2(gl_VertexID & 1, gl_VertexID >> 1);\n"
            "    vec2 at = mix(floor(ends.xy), ceil(ends.zw), side);\n"
            "    if (kind.z > 0.0) {\n"
            "        vec2 along = ends.zw - ends.xy, right = vec2(1.0, 0.0);\n"
            "        right = length(along) > 0.0 ? normalize(along) : right;\n"
            "        vec2 margin = (2.0 * side - 1.0) * (0.5 * kind.z + 1.0);\n"
            "        at = ends.xy + side.x * along + margin.x * right + margin.y * vec2(-right.y, "
            "right.x);\n"
            "    }\n"
            "    shapeEnds = ends;\n"
            "    shapeKind = kind;\n"
            "    shapeTint = tint;\n"
            "    gl_Position = vec4(2.0 * at / size - 1.0, 0.0, 1.0);\n"
            "}\n";

// The fragment shader finds the fraction of the pixel that the shape covers.
static const char fragment_text[] =
    GL_GLSL "uniform sampler2D letters;\n"
            "flat in vec4 shapeEnds, shapeTint;\n"
            "flat in vec3 shapeKind;\n"
            "out vec4 fragment;\n"
            "void main()\n"
            "{\n"
            "    vec2 at = gl_FragCoord.xy, low = shapeEnds.xy, high = shapeEnds.zw;\n"
            "    vec2 inside = max(min(high, at + 0.5) - max(low, at - 0.5), 0.0);\n"
            "    float covered = inside.x * inside.y;\n"
            "    if (shapeKind.x >= 0.0) {\n"
            "        vec2 texel = shapeKind.xy + vec2(at.x - low.x, high.y - at.y);\n"
            "        covered = texelFetch(letters, ivec2(texel), 0).r;\n"
            "    } else if (shapeKind.z > 0.0) {\n"
            "        vec2 along = high - low;\n"
            "        float t = dot(at - low, along) / max(dot(along, along), 1e-9);\n"
            "        float far = length(at - low - clamp(t, 0.0, 1.0) * along);\n"
            "        covered = clamp(0.5 * shapeKind.z + 0.5 - far, 0.0, 1.0);\n"
            "    }\n"
            "    float opacity = shapeTint.a * covered;\n"
            "    fragment = vec4(opacity * shapeTint.rgb, opacity);\n"
            "}\n";

bool overlay_open(struct overlay *overlay, const struct gl *gl)
{
    *overlay = (struct overlay){
        .gl = gl, .program = target_program(gl, "overlay", vertex_text, fragment_text)};
    if (overlay->program == 0)
        return false;
    overlay->size = gl->GetUniformLocation(overlay->program, "size");
    gl->GenVertexArrays(1, &overlay->vertex_array);
    gl->GenBuffers(1, &overlay->buffer);
    gl->BindVertexArray(overlay->vertex_array);
    gl->BindBuffer(GL_ARRAY_BUFFER, overlay->buffer);
    const GLsizei stride = sizeof(struct shape);
    gl->VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, stride, NULL);
    gl->VertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, stride,
                            (const void *)offsetof(struct shape, letter));
    gl->VertexAttribPointer(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride,
                            (const void *)offsetof(struct shape, colour));
    for (GLuint i = 0; i < 3; i++) {
        gl->EnableVertexAttribArray(i);
        gl->VertexAttribDivisor(i, 1);
    }
    gl->GenTextures(1, &overlay->texture);
    overlay->letters = memory_zeros(1, sizeof *overlay->letters);
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

// Convert a rectangle to a shape. A letter begins at the nearest quarter of a pixel, and its
// baseline is at a whole pixel.
//   up  pixels from the target's bottom edge to the picture's top
static struct shape shape_of(const struct overlay *overlay,
                             const struct overlay_rectangle *rectangle, float up)
{
    float scale = overlay->scale;
    struct shape shape = {.letter = {-1.0f, -1.0f}};
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
    shape.letter[0] = (float)letter->x;
    shape.letter[1] = (float)letter->y;
    return shape;
}

// Upload the frame's shapes, and the atlas if it has new letters.
static void upload(const struct overlay *overlay, float up)
{
    const struct gl *gl = overlay->gl;
    struct letters *letters = overlay->letters;
    struct shape *shape = memory_zeros((size_t)overlay->count, sizeof *shape);
    letters_begin(letters, overlay->scale);
    for (int i = 0; i < overlay->count; i++)
        shape[i] = shape_of(overlay, &overlay->rectangle[i], up);
    gl->BufferData(GL_ARRAY_BUFFER, overlay->count * (GLsizeiptr)sizeof *shape, shape,
                   GL_STREAM_DRAW);
    free(shape);
    if (!letters->grown)
        return;
    letters->grown = false;
    target_upload(gl, LETTERS_ROW, letters->rows, letters->pixel);
}

void overlay_draw(const struct overlay *overlay, int bottom, int rows)
{
    const struct gl *gl = overlay->gl;
    if (overlay->count == 0)
        return;
    gl->UseProgram(overlay->program);
    gl->Uniform2f(overlay->size, (float)overlay->width, (float)rows);
    gl->BindTexture(GL_TEXTURE_2D, overlay->texture);
    gl->BindVertexArray(overlay->vertex_array);
    gl->BindBuffer(GL_ARRAY_BUFFER, overlay->buffer);
    upload(overlay, (float)(overlay->height - bottom));
    gl->Viewport(0, 0, overlay->width, rows);
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl->DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, overlay->count);
    gl->Disable(GL_BLEND);
    gl->BindTexture(GL_TEXTURE_2D, 0);
}
