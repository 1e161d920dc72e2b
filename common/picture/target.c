#include "picture/target.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "report.h"
#include "shader/program.h"

const char target_vertex[] = GL_GLSL
    "void main()\n"
    "{\n"
    "    vec2 corner = vec2(float((gl_VertexID & 1) << 2), float((gl_VertexID & 2) << 1));\n"
    "    gl_Position = vec4(corner - 1.0, 0.0, 1.0);\n"
    "}\n";

static const char fragment_text[] = GL_GLSL "out vec4 fragment;\n"
                                            "void main()\n"
                                            "{\n"
                                            "    fragment = vec4(0.25);\n"
                                            "}\n";

// In one pixel, draw a quarter or, with blending, add a quarter to 0 twice.
static void draw_trial(const struct gl *gl, GLuint program, bool blends)
{
    GLuint vertex_array;
    gl->GenVertexArrays(1, &vertex_array);
    gl->BindVertexArray(vertex_array);
    gl->UseProgram(program);
    gl->Viewport(0, 0, 1, 1);
    gl->ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    gl->Clear(GL_COLOR_BUFFER_BIT);
    if (blends)
        gl->Enable(GL_BLEND);
    gl->BlendFunc(GL_ONE, GL_ONE);
    for (int i = 0; i < 2; i++)
        gl->DrawArrays(GL_TRIANGLES, 0, 3);
    gl->Disable(GL_BLEND);
    gl->DeleteVertexArrays(1, &vertex_array);
}

GLuint target_program(const struct gl *gl, const char *what, const char *vertex,
                      const char *fragment)
{
    enum shader_step step;
    char *log;
    GLuint program = shader_link_texts(gl, vertex, fragment, &step, &log);
    if (program == 0)
        report("%s: the driver rejects its shader: try another --backend: %.800s", what,
               log != NULL ? log : "");
    free(log);
    return program;
}

static void read_nearest(const struct gl *gl)
{
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void target_upload(const struct gl *gl, int width, int height, const unsigned char *pixel)
{
    gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, pixel);
    read_nearest(gl);
}

bool target_make(struct target *target, const struct gl *gl, int width, int height)
{
    gl->BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    if (target->width == width && target->height == height)
        return true;
    gl->BindTexture(GL_TEXTURE_2D, target->texture);
    gl->TexImage2D(GL_TEXTURE_2D, 0, (GLint)target->format, width, height, 0, GL_RGBA,
                   target->format == GL_RGBA8 ? GL_UNSIGNED_BYTE : GL_FLOAT, NULL);
    read_nearest(gl);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target->texture,
                             0);
    bool made = gl->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE &&
                gl->GetError() == GL_NO_ERROR;
    target->width = made ? width : 0;
    target->height = height;
    return made;
}

// True if the browser has an extension.
static bool has(const struct gl *gl, const char *extension)
{
    return strstr((const char *)gl->GetString(GL_EXTENSIONS), extension) != NULL;
}

GLenum target_format(const struct gl *gl, bool blends)
{
    if (GL_IS_ES && blends && !has(gl, "float_blend")) // a trial would be an error
        return GL_RGBA16F;
    struct target target;
    enum shader_step step;
    char *log;
    float sum[4] = {0.0f};
    GLuint program = shader_link_texts(gl, target_vertex, fragment_text, &step, &log);
    free(log);
    target_open(&target, gl, GL_RGBA32F);
    if (program != 0 && target_make(&target, gl, 1, 1)) {
        draw_trial(gl, program, blends);
        target_read(&target, gl, sum);
    }
    target_close(&target, gl);
    gl->DeleteProgram(program);
    return sum[0] == (blends ? 0.5f : 0.25f) ? GL_RGBA32F : GL_RGBA16F;
}

void target_filter(const struct target *target, const struct gl *gl, char filter, bool repeat)
{
    bool can = !GL_IS_ES || target->format != GL_RGBA32F || has(gl, "texture_float_linear");
    GLint plain = can && filter != 'n' ? GL_LINEAR : GL_NEAREST;
    GLint edge = repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    gl->BindTexture(GL_TEXTURE_2D, target->texture);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                      can && filter == 'm' ? GL_LINEAR_MIPMAP_LINEAR : plain);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, plain);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, edge);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, edge);
}

void target_open(struct target *target, const struct gl *gl, GLenum format)
{
    *target = (struct target){.format = format};
    gl->GenFramebuffers(1, &target->framebuffer);
    gl->GenTextures(1, &target->texture);
}

void target_close(struct target *target, const struct gl *gl)
{
    gl->DeleteTextures(1, &target->texture);
    gl->DeleteFramebuffers(1, &target->framebuffer);
    *target = (struct target){0};
}

bool target_bind(struct target *target, const struct gl *gl, int width, int height)
{
    return target_make(target, gl, width, height) ||
           report("float target %dx%d: the driver cannot make it: try a smaller --size or another "
                  "--backend",
                  width, height);
}

void target_read(const struct target *target, const struct gl *gl, float *values)
{
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, target->framebuffer);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl->ReadPixels(0, 0, target->width, target->height, GL_RGBA, GL_FLOAT, values);
}
