#include "shader/inputs.h"

#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "shader/source.h"

// clang-format off
static const struct input rows[] = {
    // Shadertoy has these, too.
    INPUT_ROW("iResolution", "vec3", SIZE), INPUT_ROW("iTime", "float", TIME),
    INPUT_ROW("iTimeDelta", "float", STEP), INPUT_ROW("iFrame", "int", FRAME),
    INPUT_ROW("iMouse", "vec4", MOUSE), INPUT_ROW("iDate", "vec4", DATE),
    // The course alone
    INPUT_ROW("iCameraPosition", "vec3", EYE), INPUT_ROW("iCameraRight", "vec3", RIGHT),
    INPUT_ROW("iCameraUp", "vec3", UP), INPUT_ROW("iCameraForward", "vec3", FORWARD),
    INPUT_ROW("focalLength", "float", FOCAL), INPUT_ROW("iOrthoView", "float", ORTHO),
    INPUT_ROW("iPixelOffset", "vec2", DRAW), INPUT_ROW("iPixelJitter", "vec2", DRAW),
    INPUT_ROW("iSample", "int", DRAW), INPUT_ROW("iSamples", "int", DRAW)
};
// clang-format on
enum { COUNT = sizeof rows / sizeof *rows };

const struct input *inputs_course(int index)
{
    return index < COUNT ? &rows[index] : NULL;
}

bool inputs_is_course(const struct input *input)
{
    return input >= rows && input < rows + COUNT;
}

bool inputs_is_shared(const struct input *input)
{
    return input >= rows && input < rows + INPUTS_SHARED;
}

bool inputs_type(const char *type, struct shader_input *into)
{
    char base = '\0';
    into->components = glsl_type(type, &base);
    into->integer = base == 'i';
    return base == 'f' || (into->integer && into->components == 1);
}

struct shader_input inputs_default(const struct input *input)
{
    struct shader_input in = {.input = input};
    inputs_type(input->type, &in);
    return in;
}

void inputs_add(struct shader_source *source, struct shader_input input)
{
    for (int i = 0; i < source->input_count; i++)
        if (source->inputs[i].input == input.input)
            return;
    source->inputs = memory_row(source->inputs, source->input_count, sizeof *source->inputs);
    source->inputs[source->input_count++] = input;
}

int inputs_add_sampler(struct shader_source *source, struct shader_sampler sampler)
{
    int count = source->sampler_count;
    for (int i = 0; i < count; i++)
        if (strcmp(source->samplers[i].name, sampler.name) == 0)
            return source->samplers[i].channel;
    source->samplers = memory_row(source->samplers, count, sizeof *source->samplers);
    source->samplers[source->sampler_count++] = sampler;
    return sampler.channel;
}

bool inputs_reads(const struct gl *gl, GLuint program, const struct shader_source *source,
                  enum input_meaning first, enum input_meaning last)
{
    for (int i = 0; i < source->input_count; i++) {
        const struct input *input = source->inputs[i].input;
        if (input->meaning >= first && input->meaning <= last &&
            gl->GetUniformLocation(program, input->name) >= 0)
            return true;
    }
    return false;
}

// ---- The vertex shader ----

// The vertex shader's own FragCoord, the position on the screen, is renamed to harnessPosition.
// Each position that the source reads is computed from harnessPosition, with as many components as
// the source declares.
void inputs_vertex(const struct shader_source *source, char **before, char **after)
{
    static const char *const types[] = {"float", "vec2", "vec3", "vec4"};
    static const char *const values[] = {"(%s).x", "%s", "vec3(%s, 0.0)", "vec4(%s, 0.0, 1.0)"};
    FILE *declarations = memory_open(before), *main = memory_open(after);
    fputs("#define iResolution harnessResolution\n", declarations);
    fputs("#undef FragCoord\n#undef main\nvoid main()\n{\n    harnessMain();\n", main);
    for (int i = 0; i < source->input_count; i++) {
        const struct shader_input *in = &source->inputs[i];
        if (in->input->meaning != INPUT_POSITION)
            continue;
        fprintf(declarations, "out %s %s;\n", types[in->components - 1], in->input->name);
        fprintf(main, "    %s = ", in->input->name);
        fprintf(main, values[in->components - 1], in->input->text);
        fputs(";\n", main);
    }
    fputs("#define FragCoord harnessPosition\n#define main harnessMain\n", declarations);
    fputs("}\n", main);
    memory_close(declarations);
    memory_close(main);
}

// ---- Values ----

void inputs_set(const struct gl *gl, const struct shader_source *source, const GLint *location,
                float value[INPUT_VALUES][4])
{
    for (int i = 0; i < source->input_count; i++) {
        const struct shader_input *in = &source->inputs[i];
        if (in->input->meaning >= INPUT_VALUES)
            continue;
        GLint at = location[i];
        const float *v = value[in->input->meaning];
        if (in->integer)
            gl->Uniform1i(at, (GLint)v[0]);
        else if (in->components == 1)
            gl->Uniform1f(at, v[0]);
        else if (in->components == 2)
            gl->Uniform2f(at, v[0], v[1]);
        else if (in->components == 3)
            gl->Uniform3f(at, v[0], v[1], v[2]);
        else
            gl->Uniform4f(at, v[0], v[1], v[2], v[3]);
    }
}
