#include "dialects/tool_inputs.h"

#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "shader/parameter.h"

#define COUNT(array) ((int)(sizeof(array) / sizeof *(array)))

// The position in the picture, as fractions of its width and height.
#define SHARE "0.5 * harnessPosition / vec2(iResolution.x / iResolution.y, 1.0) + 0.5"
#define SOUND "there is no sound here"
#define SELF  "there is no earlier pass here"
#define MIDI  "there is no MIDI here"

// The table of inputs.
// clang-format off
#define FLOAT(name, meaning) INPUT_ROW(name, "float", meaning)
#define INT(name, meaning) INPUT_ROW(name, "int", meaning)
#define VEC2(name, meaning) INPUT_ROW(name, "vec2", meaning)
#define VEC3(name, meaning) INPUT_ROW(name, "vec3", meaning)
#define VEC4(name, meaning) INPUT_ROW(name, "vec4", meaning)
#define CHANNEL(name, channel) {name, "sampler2D", INPUT_CHANNEL, channel, ""}
#define POSITION(name, value)     {name, "vec2", INPUT_POSITION, 0, value}
#define SILENT(name, why)      {name, "sampler2D", INPUT_SILENT, 0, why}
#define LAST(name, filter)     {name, "sampler2D", INPUT_LAST, 0, filter}

// Inputs that only Shadertoy has.
static const struct input toys[] = {
    FLOAT("iFrameRate", RATE), CHANNEL("iChannel0", 0), CHANNEL("iChannel1", 1),
    CHANNEL("iChannel2", 2), CHANNEL("iChannel3", 3),
    {"iChannelResolution", "vec3[4]", INPUT_CHANNEL_SIZE, -1, ""}, FLOAT("iSampleRate", SOUND_RATE),
    {"iChannelTime", "float[4]", INPUT_SILENT, 0, "there are no films or sounds here"}
};

static const struct input rows[] = {
    FLOAT("iGlobalTime", TIME), // Shadertoy's old name for iTime
    // The Book of Shaders, glslViewer, glsl.app
    VEC2("u_resolution", SIZE), FLOAT("u_time", TIME), VEC2("u_mouse", POINTER),
    FLOAT("u_delta", STEP), VEC4("u_date", DATE), INT("u_frame", FRAME), CHANNEL("u_tex0", 0),
    CHANNEL("u_tex1", 1), CHANNEL("u_tex2", 2), CHANNEL("u_tex3", 3),
    {"u_tex0Resolution", "vec2", INPUT_CHANNEL_SIZE, 0, ""},
    {"u_tex1Resolution", "vec2", INPUT_CHANNEL_SIZE, 1, ""},
    {"u_tex2Resolution", "vec2", INPUT_CHANNEL_SIZE, 2, ""},
    {"u_tex3Resolution", "vec2", INPUT_CHANNEL_SIZE, 3, ""}, POSITION("v_texcoord", SHARE),
    POSITION("uv", SHARE),
    // GLSL Sandbox, twigl, veda, Hydra, KodeLife
    VEC2("resolution", SIZE), FLOAT("time", TIME), VEC2("mouse", POINTER_SHARE),
    FLOAT("frame", FRAME), VEC4("date", DATE),
    POSITION("surfacePosition", "0.5 * harnessPosition"),
    CHANNEL("texture0", 0), CHANNEL("texture1", 1), CHANNEL("texture2", 2),
    CHANNEL("texture3", 3), LAST("backbuffer", "n"), LAST("prevFrame", "n"),
    SILENT("prevPass", SELF), LAST("prevBuffer", "n"), SILENT("spectrum", SOUND),
    SILENT("samples", SOUND),
    {"volume", "float", INPUT_SILENT, 0, SOUND}, {"sound", "float", INPUT_SILENT, 0, SOUND},
    SILENT("midi", MIDI), SILENT("note", MIDI), SILENT("key", "there is no keyboard here"),
    SILENT("gamepad", "there is no gamepad here"),
    // Bonzomatic
    FLOAT("fGlobalTime", TIME), VEC2("v2Resolution", SIZE), FLOAT("fFrameTime", STEP),
    {"texFFT", "sampler1D", INPUT_SILENT, 0, SOUND},
    {"texFFTSmoothed", "sampler1D", INPUT_SILENT, 0, SOUND},
    {"texFFTIntegrated", "sampler1D", INPUT_SILENT, 0, SOUND}, LAST("texPreviousFrame", "lr"),
    POSITION("out_texcoord", SHARE),
    // Three.js, p5.js and ISF
    FLOAT("uTime", TIME), VEC2("uResolution", SIZE), VEC2("uMouse", POINTER),
    FLOAT("millis", TIME), POSITION("vUv", SHARE), POSITION("vTexCoord", SHARE),
    POSITION("vTextureCoord", SHARE), POSITION("isf_FragNormCoord", SHARE),
    VEC2("RENDERSIZE", SIZE),
    FLOAT("TIME", TIME), FLOAT("TIMEDELTA", STEP), INT("FRAMEINDEX", FRAME), VEC4("DATE", DATE),
    // EnginPasTangible, the engine of the report that the course follows
    POSITION("FragCoord", "harnessPosition"), FLOAT("Time", TIME), VEC3("Ex", RIGHT),
    VEC3("Ey", UP),
    VEC3("Ez", FORWARD), VEC3("CamPos", EYE), FLOAT("fovValue", FOCAL),
    FLOAT("FacteurLargeur", ASPECT), FLOAT("OrthoView", ORTHO), FLOAT("CustomToggle", ZERO),
    FLOAT("CustomInt", ZERO)
};
// clang-format on

const struct input *tool_inputs_row(int index)
{
    int course = 0;
    if (index < COUNT(toys))
        return &toys[index];
    while (inputs_course(course) != NULL)
        course++;
    index -= COUNT(toys);
    if (index < course)
        return inputs_course(index);
    index -= course;
    return index < COUNT(rows) ? &rows[index] : NULL;
}

const struct input *tool_inputs_find(const char *name)
{
    const struct input *input;
    for (int i = 0; (input = tool_inputs_row(i)) != NULL; i++)
        if (strcmp(input->name, name) == 0)
            return input;
    return NULL;
}

bool tool_inputs_is_shadertoy(const struct input *input)
{
    return inputs_is_shared(input) || (input >= toys && input < toys + COUNT(toys));
}

bool tool_inputs_is_own(const struct shader_input *in)
{
    struct shader_input own = inputs_default(in->input);
    return tool_inputs_is_shadertoy(in->input) &&
           (in->input->meaning >= INPUT_VALUES ||
            (own.components == in->components && own.integer == in->integer));
}

// ---- Channels ----

// What a channel contains in the author's tool, if the file says so.
struct kind {
    const char *was, *words;
    const char *type; // of the black sampler that replaces it; NULL if black does not
};

static const struct kind *kind_of(const struct shader_source *source, int channel)
{
    static const struct kind kinds[] = {{"buffer", "a buffer, the picture of another pass", NULL},
                                        {"keyboard", "the keyboard", "sampler2D"},
                                        {"cubemap", "a cube map", "samplerCube"},
                                        {"volume", "a volume", "sampler3D"},
                                        {"mic", "a sound", "sampler2D"},
                                        {"music", "a sound", "sampler2D"},
                                        {"musicstream", "a sound", "sampler2D"},
                                        {"video", "a film", "sampler2D"},
                                        {"webcam", "a film", "sampler2D"}};
    for (int i = 0; i < COUNT(kinds); i++)
        if (channel >= 0 && strcmp(source->was[channel], kinds[i].was) == 0)
            return &kinds[i];
    return NULL;
}

// The channel whose picture a token names as the first of several arguments; -1 if there is none.
static int channel_of(const struct glsl_token *t)
{
    bool may = t->kind == GLSL_WORD && !t->macro && t[-1].sign == '(' && t[1].sign == ',';
    const struct input *input = may ? tool_inputs_find(t->text) : NULL;
    return input != NULL && input->meaning == INPUT_CHANNEL ? input->channel : -1;
}

// True for a vec3, as in the lookup of a cube map or a volume: texture(iChannel0, vec3(...)).
static bool is_vec3(const struct glsl *code, const struct glsl_token *t)
{
    static const char *const words[] = {"vec3", "reflect", "refract", "normalize", NULL};
    if (glsl_is_any(t, words))
        return glsl_is_sign(glsl_next(code, t + 1), ",)");
    if (t->kind != GLSL_WORD || !glsl_is_sign(t + 1, ",)"))
        return false;
    const struct glsl_token *v = t - 1; // look for the declaration of a variable of type vec3
    while (v >= code->statement &&
           !(v->kind == GLSL_WORD && v->name == t->name && v[-1].kind == GLSL_WORD))
        v--;
    return v >= code->statement && glsl_is(v - 1, "vec3");
}

static bool is_read_at_vec3(const struct glsl *code, int channel)
{
    static const char *const lookups[] = {"texture", "textureLod", "textureCube", NULL};
    const struct glsl_token *t = code->statement;
    while (t->kind != GLSL_END &&
           !(channel_of(t) == channel && glsl_is_any(t - 2, lookups) && is_vec3(code, t + 2)))
        t++;
    return t->kind != GLSL_END;
}

const char *tool_inputs_sampler(const struct shader_source *source, const struct input *input)
{
    const struct shader_sampler sampler = {.name = input->name, .channel = input->channel};
    const struct kind *kind = kind_of(source, input->channel);
    if (sampler_has_picture(source, &sampler))
        return "sampler2D";
    return kind != NULL                                     ? kind->type
           : is_read_at_vec3(&source->code, input->channel) ? "sampler3D"
                                                            : "sampler2D";
}

bool tool_inputs_lacks(const struct shader_source *source, const struct input *input)
{
    return input->meaning == INPUT_CHANNEL && tool_inputs_sampler(source, input) == NULL;
}

bool tool_inputs_has_size(const struct shader_source *source, const struct input *input)
{
    for (int i = 0; i < source->sampler_count; i++)
        if ((input->channel < 0 || input->channel == source->samplers[i].channel) &&
            sampler_has_picture(source, &source->samplers[i]))
            return true;
    return false;
}

char *tool_inputs_why_black(const struct shader_source *source,
                            const struct shader_sampler *sampler)
{
    const struct kind *kind = kind_of(source, sampler->channel);
    if (kind != NULL)
        return memory_text("%s is %s, and is black here", sampler->name, kind->words);
    if (strcmp(sampler->type, "sampler2D") != 0)
        return memory_text("%s is read at a vec3, as a cube map or a volume, and is black here",
                           sampler->name);
    if (GL_IS_ES)
        return memory_text("%s has no picture, and is black: this page cannot read your pictures",
                           sampler->name);
    return sampler->channel < 0
               ? memory_text("%s has no picture, and is black: give --texture %s=FILE.png",
                             sampler->name, sampler->name)
               : memory_text("%s has no picture, and is black: give --channel %d=FILE.png",
                             sampler->name, sampler->channel);
}

bool tool_inputs_refuse(const struct shader_source *source, const struct input *input, int line)
{
    if (input->meaning != INPUT_CHANNEL)
        return shader_refuse(source, line,
                             "%s is not supported: %s: compute the value in the shader",
                             input->name, input->text);
    return shader_refuse(source, line, "%s is read as %s, which is not in this file", input->name,
                         kind_of(source, input->channel)->words);
}
