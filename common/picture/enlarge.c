#include "picture/enlarge.h"

#include <stdio.h>

static const char begin_text[] = GL_GLSL "uniform sampler2D picture;\n"
                                         "uniform vec2 step;\n" // a pixel's size in texels
                                         "out vec4 fragment;\n"
                                         "vec3 texel(int x, int y)\n"
                                         "{\n"
                                         "    return texelFetch(picture, ivec2(x, y), 0).rgb;\n"
                                         "}\n";

static const char end_text[] =
    "void main()\n"
    "{\n"
    "    vec2 texel = gl_FragCoord.xy * step - 0.5;\n"
    "    vec2 base = floor(texel);\n"
    "    ivec2 last = textureSize(picture, 0) - 1;\n"
    "    ivec4 column = clamp(int(base.x) + ivec4(-1, 0, 1, 2), 0, last.x);\n"
    "    ivec4 row = clamp(int(base.y) + ivec4(-1, 0, 1, 2), 0, last.y);\n"
    "    fragment = vec4(filtered(column, row, texel - base), 1.0);\n"
    "}\n";

static const char bilinear_text[] = "vec3 filtered(ivec4 x, ivec4 y, vec2 f)\n"
                                    "{\n"
                                    "    vec3 low = mix(texel(x.y, y.y), texel(x.z, y.y), f.x);\n"
                                    "    vec3 high = mix(texel(x.y, y.z), texel(x.z, y.z), f.x);\n"
                                    "    return mix(low, high, f.y);\n"
                                    "}\n";

// For one of the 4 nearest texels, look adds the slope of the light to slope, and adds to single a
// value that is 1/2 at an edge parallel to an axis, up to 1 at a slanted edge, and 0 at a thin
// line, where the kernel must not be used. Both are multiplied by the texel's bilinear weight. add
// adds one texel to the weighted mean: its offset is rotated so that x points up the slope and y
// along the edge, and scaled so that the kernel reaches about 4 texels along the edge and at most
// about 2 across it. The kernel is (25/16 (2/5 r - 1)^2 - 9/16) (0.21 r - 1)^2, where r is the
// squared length of this offset; it approximates the Lanczos kernel of order 2 without sines. The
// square of single is the weight of the kernel's mean; the bilinear mean has the rest of the
// weight.
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
    {"bilinear", bilinear_text},
    {"edge", edge_text},
};

const char *enlarge_name(enum enlarge_filter filter)
{
    return filters[filter].name;
}

static GLuint link_program(const struct gl *gl, const char *text)
{
    char fragment[sizeof begin_text + sizeof edge_text + sizeof end_text];
    snprintf(fragment, sizeof fragment, "%s%s%s", begin_text, text, end_text);
    return target_program(gl, "enlarging", target_vertex, fragment);
}

// Copy the target's picture with 8 bits per channel, so that the copy is clamped to [0, 1] and
// faster to read.
static bool copy_target(struct enlarge *enlarge, const struct gl *gl, const struct target *target)
{
    int width = target->width, height = target->height;
    GLint drawn = 0;
    gl->GetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn);
    bool made = target_bind(&enlarge->copy, gl, width, height);
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, target->framebuffer);
    if (made)
        gl->BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                            GL_NEAREST);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, (GLuint)drawn);
    return made;
}

bool enlarge_draw(struct enlarge *enlarge, const struct gl *gl, enum enlarge_filter filter,
                  const struct target *target, int width, int height)
{
    GLuint *program = &enlarge->program[filter];
    if (enlarge->vertex_array == 0) {
        gl->GenVertexArrays(1, &enlarge->vertex_array);
        target_open(&enlarge->copy, gl, GL_RGBA8);
    }
    if (*program == 0) {
        *program = link_program(gl, filters[filter].text);
        if (*program == 0)
            return false;
        enlarge->step[filter] = gl->GetUniformLocation(*program, "step");
    }
    if (!copy_target(enlarge, gl, target))
        return false;
    gl->UseProgram(*program);
    gl->Uniform2f(enlarge->step[filter], (float)target->width / (float)width,
                  (float)target->height / (float)height);
    gl->BindTexture(GL_TEXTURE_2D, enlarge->copy.texture);
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
    if (enlarge->vertex_array != 0) {
        gl->DeleteVertexArrays(1, &enlarge->vertex_array);
        target_close(&enlarge->copy, gl);
    }
    *enlarge = (struct enlarge){0};
}
