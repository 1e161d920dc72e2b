#include "picture/enlarge.h"

#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>

#include "report.h"
#include "shader/compile.h"

static const char begin_text[] = GL_GLSL "uniform sampler2D picture;\n"
                                         "uniform vec2 step;\n" // from pixel to pixel, in texels
                                         "out vec4 fragment;\n"
                                         "vec3 texel(int x, int y)\n"
                                         "{\n"
                                         "    return texelFetch(picture, ivec2(x, y), 0).rgb;\n"
                                         "}\n";

static const char end_text[] =
    "void main()\n"
    "{\n"
    "    vec2 place = gl_FragCoord.xy * step - 0.5;\n"
    "    vec2 base = floor(place);\n"
    "    ivec2 last = textureSize(picture, 0) - 1;\n"
    "    ivec4 column = clamp(int(base.x) + ivec4(-1, 0, 1, 2), 0, last.x);\n"
    "    ivec4 row = clamp(int(base.y) + ivec4(-1, 0, 1, 2), 0, last.y);\n"
    "    fragment = vec4(filtered(column, row, place - base), 1.0);\n"
    "}\n";

static const char nearest_text[] =
    "vec3 filtered(ivec4 x, ivec4 y, vec2 f)\n"
    "{\n"
    "    return texel(f.x < 0.5 ? x.y : x.z, f.y < 0.5 ? y.y : y.z);\n"
    "}\n";

static const char bilinear_text[] = "vec3 filtered(ivec4 x, ivec4 y, vec2 f)\n"
                                    "{\n"
                                    "    vec3 low = mix(texel(x.y, y.y), texel(x.z, y.y), f.x);\n"
                                    "    vec3 high = mix(texel(x.y, y.z), texel(x.z, y.z), f.x);\n"
                                    "    return mix(low, high, f.y);\n"
                                    "}\n";

// Weights of the texels at -1, 0, 1, 2 for a place f behind texel 0.
static const char bicubic_text[] =
    "vec4 weights(float f)\n"
    "{\n"
    "    return 0.5 * vec4(f * (-1.0 + f * (2.0 - f)), 2.0 + f * f * (3.0 * f - 5.0),\n"
    "                      f * (1.0 + f * (4.0 - 3.0 * f)), f * f * (f - 1.0));\n"
    "}\n"
    "vec3 across(ivec4 x, int y, vec4 w)\n"
    "{\n"
    "    return w.x * texel(x.x, y) + w.y * texel(x.y, y) + w.z * texel(x.z, y) +\n"
    "           w.w * texel(x.w, y);\n"
    "}\n"
    "vec3 filtered(ivec4 x, ivec4 y, vec2 f)\n"
    "{\n"
    "    vec4 w = weights(f.x), v = weights(f.y);\n"
    "    return v.x * across(x, y.x, w) + v.y * across(x, y.y, w) + v.z * across(x, y.z, w) +\n"
    "           v.w * across(x, y.w, w);\n"
    "}\n";

// look adds, for one of the 4 nearest texels, by its bilinear weight: the slope there, and how far
// it is one edge (1) and no thin line (0), along which no kernel may be laid. add takes one texel
// into the mean: its offset is turned so that x goes up the slope and y along the edge, and
// stretched: 4 texels along the edge, 2 across. The kernel is (25/16 (2/5 r - 1)^2 - 9/16)
// (0.21 r - 1)^2, r the length squared, which follows Lanczos' of order 2 without its sines. Where
// there is no single edge, bilinear has the say.
static const char edge_text[] =
    "vec2 slope;\n"
    "float single;\n"
    "vec2 up, stretch;\n"
    "vec4 sum;\n"
    "float light(vec3 colour)\n"
    "{\n"
    "    return dot(colour, vec3(0.25, 0.5, 0.25));\n"
    "}\n"
    "void look(float weight, float middle, float left, float right, float below, float above)\n"
    "{\n"
    "    vec2 difference = vec2(right - left, above - below);\n"
    "    vec2 larger = max(abs(vec2(right, above) - middle), abs(middle - vec2(left, below)));\n"
    "    vec2 one = min(abs(difference) / max(larger, 1.0e-5), 1.0);\n"
    "    slope += weight * difference;\n"
    "    single += weight * 0.5 * dot(one, one);\n"
    "}\n"
    "void add(vec2 offset, vec3 colour)\n"
    "{\n"
    "    vec2 turned = vec2(dot(offset, up), dot(offset, vec2(-up.y, up.x))) * stretch;\n"
    "    float r = min(dot(turned, turned), 1.0 / 0.21);\n"
    "    float hump = 0.4 * r - 1.0, end = 0.21 * r - 1.0;\n"
    "    float weight = (1.5625 * hump * hump - 0.5625) * end * end;\n"
    "    sum += weight * vec4(colour, 1.0);\n"
    "}\n"
    "vec3 filtered(ivec4 x, ivec4 y, vec2 f)\n"
    "{\n"
    "    vec3 a1 = texel(x.y, y.x), a2 = texel(x.z, y.x);\n"
    "    vec3 b0 = texel(x.x, y.y), b1 = texel(x.y, y.y), b2 = texel(x.z, y.y),\n"
    "         b3 = texel(x.w, y.y);\n"
    "    vec3 c0 = texel(x.x, y.z), c1 = texel(x.y, y.z),\n"
    "         c2 = texel(x.z, y.z), c3 = texel(x.w, y.z);\n"
    "    vec3 d1 = texel(x.y, y.w), d2 = texel(x.z, y.w);\n"
    "    float l1 = light(b1), l2 = light(b2), m1 = light(c1), m2 = light(c2);\n"
    "    slope = vec2(0.0);\n"
    "    single = 0.0;\n"
    "    look((1.0 - f.x) * (1.0 - f.y), l1, light(b0), l2, light(a1), m1);\n"
    "    look(f.x * (1.0 - f.y), l2, l1, light(b3), light(a2), m2);\n"
    "    look((1.0 - f.x) * f.y, m1, light(c0), m2, l1, light(d1));\n"
    "    look(f.x * f.y, m2, m1, light(c3), l2, light(d2));\n"
    "    float steep = dot(slope, slope);\n"
    "    up = steep < 3.0e-5 ? vec2(1.0, 0.0) : slope * inversesqrt(steep);\n"
    "    single *= single;\n"
    "    stretch = vec2(1.0 / max(abs(up.x), abs(up.y)), 0.5);\n"
    "    sum = vec4(0.0);\n"
    "    add(vec2(0.0, -1.0) - f, a1);\n"
    "    add(vec2(1.0, -1.0) - f, a2);\n"
    "    add(vec2(-1.0, 0.0) - f, b0);\n"
    "    add(-f, b1);\n"
    "    add(vec2(1.0, 0.0) - f, b2);\n"
    "    add(vec2(2.0, 0.0) - f, b3);\n"
    "    add(vec2(-1.0, 1.0) - f, c0);\n"
    "    add(vec2(0.0, 1.0) - f, c1);\n"
    "    add(vec2(1.0, 1.0) - f, c2);\n"
    "    add(vec2(2.0, 1.0) - f, c3);\n"
    "    add(vec2(0.0, 2.0) - f, d1);\n"
    "    add(vec2(1.0, 2.0) - f, d2);\n"
    "    vec3 low = min(min(b1, b2), min(c1, c2)), high = max(max(b1, b2), max(c1, c2));\n"
    "    vec3 linear = mix(mix(b1, b2, f.x), mix(c1, c2, f.x), f.y);\n"
    "    return mix(linear, clamp(sum.rgb / sum.a, low, high), single);\n"
    "}\n";

static const struct {
    const char *name, *text;
} filters[ENLARGE_FILTERS] = {
    {"nearest", nearest_text},
    {"bilinear", bilinear_text},
    {"bicubic", bicubic_text},
    {"edge", edge_text},
};

const char *enlarge_name(enum enlarge_filter filter)
{
    return filters[filter].name;
}

static GLuint link_program(const struct gl *gl, const char *text)
{
    char fragment[sizeof begin_text + sizeof edge_text + sizeof end_text];
    enum shader_step step;
    char *log;
    snprintf(fragment, sizeof fragment, "%s%s%s", begin_text, text, end_text);
    GLuint program = shader_link_texts(gl, target_vertex, fragment, &step, &log);
    if (program == 0)
        report("enlarging: the driver does not take its shader: try another --backend: %.800s",
               log != NULL ? log : "");
    free(log);
    return program;
}

// A copy of 8 bits a channel: it has the values brought into [0, 1], and is quicker to read.
static void copy_target(struct enlarge *enlarge, const struct gl *gl, const struct target *target)
{
    int width = target->width, height = target->height;
    GLint drawn = 0;
    gl->GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn);
    if (enlarge->framebuffer == 0) {
        gl->GenFramebuffers(1, &enlarge->framebuffer);
        gl->GenTextures(1, &enlarge->texture);
    }
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, enlarge->framebuffer);
    if (enlarge->width != width || enlarge->height != height) {
        gl->BindTexture(GL_TEXTURE_2D, enlarge->texture);
        gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                       NULL);
        gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        gl->FramebufferTexture2D(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D,
                                 enlarge->texture, 0);
        enlarge->width = width;
        enlarge->height = height;
    }
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, target->framebuffer);
    gl->BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, (GLuint)drawn);
}

bool enlarge_draw(struct enlarge *enlarge, const struct gl *gl, enum enlarge_filter filter,
                  const struct target *target, int width, int height)
{
    GLuint *program = &enlarge->program[filter];
    if (enlarge->vertex_array == 0)
        gl->GenVertexArrays(1, &enlarge->vertex_array);
    if (*program == 0)
        *program = link_program(gl, filters[filter].text);
    if (*program == 0)
        return false;
    copy_target(enlarge, gl, target);
    const float step[2] = {(float)target->width / (float)width,
                           (float)target->height / (float)height};
    gl->UseProgram(*program);
    gl->Uniform1i(gl->GetUniformLocation(*program, "picture"), 0);
    gl->Uniform2f(gl->GetUniformLocation(*program, "step"), step[0], step[1]);
    gl->BindTexture(GL_TEXTURE_2D, enlarge->texture);
    gl->BindVertexArray(enlarge->vertex_array);
    gl->Viewport(0, 0, width, height);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    return true;
}

void enlarge_close(struct enlarge *enlarge, const struct gl *gl)
{
    for (int i = 0; i < ENLARGE_FILTERS; i++)
        if (enlarge->program[i] != 0)
            gl->DeleteProgram(enlarge->program[i]);
    if (enlarge->framebuffer != 0) {
        gl->DeleteFramebuffers(1, &enlarge->framebuffer);
        gl->DeleteTextures(1, &enlarge->texture);
    }
    if (enlarge->vertex_array != 0)
        gl->DeleteVertexArrays(1, &enlarge->vertex_array);
    *enlarge = (struct enlarge){0};
}
