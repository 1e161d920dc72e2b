#include "picture/overlay.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "report.h"
#include "shader/compile.h"

// What the program draws: pixels from the picture's top left, y down, and where a letter's image
// begins in the table of letters; -1 for a box; -2 for a line between two places, and its width.
struct instance {
    float left, top, right, bottom;
    struct overlay_colour colour;
    float letter[2];
};

// Each instance's corners are those of the pixels that it touches, and each of these is covered by
// the share of its area. A letter's rectangle is whole pixels, and its image says what share of
// them.
static const char vertex_text[] =
    GL_GLSL "layout(location = 0) in vec4 box;\n"
            "layout(location = 1) in vec4 boxColour;\n"
            "layout(location = 2) in vec2 boxLetter;\n"
            "uniform vec2 screen;\n"
            "flat out vec4 edges;\n"
            "flat out vec4 colour;\n"
            "flat out vec2 letter;\n"
            "void main()\n"
            "{\n"
            "    edges = vec4(box.x, screen.y - box.w, box.z, screen.y - box.y);\n"
            "    colour = boxColour;\n"
            "    letter = boxLetter;\n"
            "    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));\n"
            "    vec2 low = edges.xy, high = edges.zw;\n"
            "    if (letter.x < -1.5) {\n"
            "        edges = vec4(box.x, screen.y - box.y, box.z, screen.y - box.w);\n"
            "        low = min(edges.xy, edges.zw) - 0.5 * letter.y - 1.0;\n"
            "        high = max(edges.xy, edges.zw) + 0.5 * letter.y + 1.0;\n"
            "    }\n"
            "    vec2 place = mix(floor(low), ceil(high), corner);\n"
            "    gl_Position = vec4(2.0 * place / screen - 1.0, 0.0, 1.0);\n"
            "}\n";

static const char fragment_text[] = GL_GLSL
    "uniform float bottom;\n"
    "uniform sampler2D letters;\n"
    "flat in vec4 edges;\n"
    "flat in vec4 colour;\n"
    "flat in vec2 letter;\n"
    "out vec4 fragment;\n"
    "void main()\n"
    "{\n"
    "    vec2 pixel = gl_FragCoord.xy + vec2(0.0, bottom);\n"
    "    vec2 covered = clamp(min(edges.zw, pixel + 0.5) - max(edges.xy, pixel - 0.5), 0.0, 1.0);\n"
    "    float share = covered.x * covered.y;\n"
    "    if (letter.x < -1.5) {\n"
    "        vec2 way = edges.zw - edges.xy, from = pixel - edges.xy;\n"
    "        float along = clamp(dot(from, way) / max(dot(way, way), 1e-9), 0.0, 1.0);\n"
    "        share = clamp(0.5 * letter.y + 0.5 - length(from - along * way), 0.0, 1.0);\n"
    "    }\n"
    "    if (letter.x >= 0.0) {\n"
    "        vec2 inside = vec2(pixel.x - edges.x, edges.w - pixel.y);\n"
    "        share = texelFetch(letters, ivec2(letter + inside), 0).r;\n"
    "    }\n"
    "    fragment = vec4(colour.rgb, colour.a * share);\n"
    "}\n";

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
    const GLsizei stride = sizeof(struct instance);
    const void *colour = (const void *)offsetof(struct instance, colour);
    const void *letter = (const void *)offsetof(struct instance, letter);
    gl->VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, stride, NULL);
    gl->VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, colour);
    gl->VertexAttribPointer(2, 2, GL_FLOAT, GL_FALSE, stride, letter);
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

// A letter begins at the nearest quarter of a pixel and stands on a whole one.
static struct instance instance_of(const struct overlay *overlay,
                                   const struct overlay_rectangle *rectangle)
{
    float scale = overlay->scale;
    struct instance instance = {.colour = rectangle->colour};
    if (rectangle->letter == 0) {
        instance.left = scale * rectangle->left;
        instance.top = scale * rectangle->top;
        instance.right = scale * rectangle->right;
        instance.bottom = scale * rectangle->bottom;
        instance.letter[0] = rectangle->width > 0.0f ? -2.0f : -1.0f;
        instance.letter[1] = scale * rectangle->width;
        return instance;
    }
    int begin = (int)floorf(LETTERS_PHASES * scale * rectangle->left + 0.5f);
    int pixel = (int)floorf((float)begin / LETTERS_PHASES), phase = begin - LETTERS_PHASES * pixel;
    const struct letter *letter = letters_find(overlay->letters, rectangle->letter, phase);
    float line = floorf(scale * (rectangle->top + LETTERS_BASELINE) + 0.5f);
    instance.left = (float)(pixel + letter->left);
    instance.top = line + (float)letter->top;
    instance.right = instance.left + (float)letter->width;
    instance.bottom = instance.top + (float)letter->height;
    instance.letter[0] = (float)letter->x;
    instance.letter[1] = (float)letter->y;
    return instance;
}

// Hand the letters' images to OpenGL where there are new ones.
static void upload_letters(const struct overlay *overlay)
{
    const struct gl *gl = overlay->gl;
    struct letters *letters = overlay->letters;
    gl->BindTexture(GL_TEXTURE_2D, overlay->texture);
    if (!letters->grown)
        return;
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_R8, LETTERS_ROW, letters->rows, 0, GL_RED, GL_UNSIGNED_BYTE,
                   letters->pixel);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    letters->grown = false;
}

void overlay_draw(const struct overlay *overlay, int bottom)
{
    const struct gl *gl = overlay->gl;
    GLuint program = overlay->program;
    if (overlay->count == 0)
        return;
    struct instance *instances = memory_zeros((size_t)overlay->count, sizeof *instances);
    letters_begin(overlay->letters, overlay->scale);
    for (int i = 0; i < overlay->count; i++)
        instances[i] = instance_of(overlay, &overlay->rectangle[i]);
    gl->UseProgram(program);
    gl->Uniform2f(gl->GetUniformLocation(program, "screen"), (float)overlay->width,
                  (float)overlay->height);
    gl->Uniform1f(gl->GetUniformLocation(program, "bottom"), (float)bottom);
    gl->Uniform1i(gl->GetUniformLocation(program, "letters"), 0);
    gl->BindVertexArray(overlay->vertex_array);
    gl->BindBuffer(GL_ARRAY_BUFFER, overlay->buffer);
    gl->BufferData(GL_ARRAY_BUFFER, overlay->count * (GLsizeiptr)sizeof *instances, instances,
                   GL_STREAM_DRAW);
    free(instances);
    upload_letters(overlay);
    gl->Viewport(0, -bottom, overlay->width, overlay->height);
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl->DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, overlay->count);
    gl->Disable(GL_BLEND);
    gl->BindTexture(GL_TEXTURE_2D, 0);
}
