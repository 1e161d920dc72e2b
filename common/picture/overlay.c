#include "picture/overlay.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <stb/stb_easy_font.h>

#include "memory.h"
#include "report.h"
#include "shader/compile.h"

// What stb_easy_font writes for one corner of a quad.
struct corner {
    float x, y, z;
    unsigned char colour[4];
};

// No letter of the font has more quads than this.
#define LETTER_QUADS 20

// Each box is one instance; its corners are those of the pixels that it touches, and each of these
// is covered by the share of its area: so text is even at a scale that is no whole number.
static const char vertex_text[] =
    "#version 330 core\n"
    "layout(location = 0) in vec4 box;\n"
    "layout(location = 1) in vec4 boxColour;\n"
    "uniform vec3 screen;\n" // width, height, scale
    "flat out vec4 edges;\n"
    "flat out vec4 colour;\n"
    "void main()\n"
    "{\n"
    "    vec4 pixels = screen.z * box;\n"
    "    edges = vec4(pixels.x, screen.y - pixels.w, pixels.z, screen.y - pixels.y);\n"
    "    colour = boxColour;\n"
    "    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));\n"
    "    vec2 place = mix(floor(edges.xy), ceil(edges.zw), corner);\n"
    "    gl_Position = vec4(2.0 * place / screen.xy - 1.0, 0.0, 1.0);\n"
    "}\n";

static const char fragment_text[] =
    "#version 330 core\n"
    "uniform float bottom;\n"
    "flat in vec4 edges;\n"
    "flat in vec4 colour;\n"
    "out vec4 fragment;\n"
    "void main()\n"
    "{\n"
    "    vec2 pixel = gl_FragCoord.xy + vec2(0.0, bottom);\n"
    "    vec2 covered = clamp(min(edges.zw, pixel + 0.5) - max(edges.xy, pixel - 0.5), 0.0, 1.0);\n"
    "    fragment = vec4(colour.rgb, colour.a * covered.x * covered.y);\n"
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
    const GLsizei stride = sizeof(struct overlay_rectangle);
    const void *colour = (const void *)offsetof(struct overlay_rectangle, colour);
    gl->VertexAttribPointer(0, 4, GL_FLOAT, GL_FALSE, stride, NULL);
    gl->VertexAttribPointer(1, 4, GL_UNSIGNED_BYTE, GL_TRUE, stride, colour);
    for (GLuint i = 0; i < 2; i++) {
        gl->EnableVertexAttribArray(i);
        gl->VertexAttribDivisor(i, 1);
    }
    return true;
}

void overlay_close(struct overlay *overlay)
{
    if (overlay->program != 0) {
        overlay->gl->DeleteBuffers(1, &overlay->buffer);
        overlay->gl->DeleteVertexArrays(1, &overlay->vertex_array);
        overlay->gl->DeleteProgram(overlay->program);
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
    add(overlay, (struct overlay_rectangle){left, top, left + width, top + height, colour});
}

// Copy a text as the font can draw it; one '?' for each character of several bytes.
static void ascii_of(const char *text, char ascii[OVERLAY_TEXT + 1])
{
    size_t length = 0;
    for (; *text != '\0' && length < OVERLAY_TEXT; text++) {
        unsigned char byte = (unsigned char)*text;
        if ((byte & 0xC0) != 0x80)
            ascii[length++] = byte >= ' ' && byte <= '~' ? *text : byte == '\t' ? ' ' : '?';
    }
    ascii[length] = '\0';
}

float overlay_width(const char *text)
{
    char ascii[OVERLAY_TEXT + 1];
    ascii_of(text, ascii);
    return (float)stb_easy_font_width(ascii);
}

void overlay_text(struct overlay *overlay, float left, float top, const char *text,
                  struct overlay_colour colour)
{
    static struct corner quads[OVERLAY_TEXT * LETTER_QUADS][4];
    char ascii[OVERLAY_TEXT + 1];
    ascii_of(text, ascii);
    int count = stb_easy_font_print(left, top, ascii, colour.channel, quads, (int)sizeof quads);
    for (int i = 0; i < count; i++)
        add(overlay, (struct overlay_rectangle){quads[i][0].x, quads[i][0].y, quads[i][2].x,
                                                quads[i][2].y, colour});
}

void overlay_draw(const struct overlay *overlay, int bottom)
{
    const struct gl *gl = overlay->gl;
    GLuint program = overlay->program;
    if (overlay->count == 0)
        return;
    gl->UseProgram(program);
    gl->Uniform3f(gl->GetUniformLocation(program, "screen"), (float)overlay->width,
                  (float)overlay->height, overlay->scale);
    gl->Uniform1f(gl->GetUniformLocation(program, "bottom"), (float)bottom);
    gl->BindVertexArray(overlay->vertex_array);
    gl->BindBuffer(GL_ARRAY_BUFFER, overlay->buffer);
    gl->BufferData(GL_ARRAY_BUFFER, overlay->count * (GLsizeiptr)sizeof *overlay->rectangle,
                   overlay->rectangle, GL_STREAM_DRAW);
    gl->Viewport(0, -bottom, overlay->width, overlay->height);
    gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    gl->DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, overlay->count);
    gl->Disable(GL_BLEND);
}
