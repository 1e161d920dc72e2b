#include "picture/renderer_pass.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"

#define TILE         512 // side of a tile in pixels
#define COARSE_BLOCK 8   // side of a block in pixels, as in shaders/coarse.glsl

const char *const renderer_lens[RENDERER_LENSES] = {"focalLength", "orthographic"};

// ---- Programs ----

// Look up the locations of a linked program's uniforms.
static GLint *locate(const struct renderer *renderer, GLuint program)
{
#define RENDERER_UNIFORM(name) #name,
    static const char *const names[] = {RENDERER_UNIFORMS(RENDERER_UNIFORM)};
#undef RENDERER_UNIFORM
    const struct gl *gl = renderer->gl;
    const struct shader_source *source = &renderer->fragment;
    const struct parameters *parameters = &renderer->parameters;
    int count = RENDERER_UNIFORM_COUNT + source->input_count + parameters->count +
                TEXTURE_UNIFORMS * renderer->textures.count;
    GLint *location = memory_zeros((size_t)count, sizeof *location), *at = location;
    for (int i = 0; i < RENDERER_UNIFORM_COUNT; i++)
        *at++ = gl->GetUniformLocation(program, names[i]);
    for (int i = 0; i < source->input_count; i++)
        *at++ = gl->GetUniformLocation(program, source->inputs[i].input->name);
    for (int i = 0; i < parameters->count; i++)
        *at++ = gl->GetUniformLocation(program, parameters->item[i].name);
    textures_locate(&renderer->textures, gl, program, at);
    return location;
}

bool renderer_link(struct renderer *renderer, enum shader_view view)
{
    GLuint *program = &renderer->program[view];
    if (!shader_has_view(&renderer->fragment, view))
        return false;
    if (*program == 0) {
        *program = shader_link(renderer->gl, &renderer->vertex, &renderer->fragment, view);
        if (*program == 0)
            return false;
        renderer->location[view] = locate(renderer, *program);
    }
    bool keeps = view != VIEW_KEPT && renderer->fragment.dialect == DIALECT_COURSE &&
                 samplers_keep(&renderer->parameters.samplers);
    return (!keeps || renderer_link(renderer, VIEW_KEPT)) &&
           (!shader_shows_ray(view) || renderer_link(renderer, VIEW_PROBE)) &&
           (!renderer_reads(renderer, view, UNIFORM_iCoarse) ||
            renderer_link(renderer, VIEW_COARSE));
}

void renderer_unlink(struct renderer *renderer)
{
    for (int i = 0; i < SHADER_PROGRAM_COUNT; i++) {
        if (renderer->program[i] != 0)
            renderer->gl->DeleteProgram(renderer->program[i]);
        free(renderer->location[i]);
        renderer->program[i] = 0;
        renderer->location[i] = NULL;
    }
}

bool renderer_reads(const struct renderer *renderer, enum shader_view view,
                    enum renderer_uniform uniform)
{
    return renderer->fragment.dialect == DIALECT_COURSE && renderer->location[view] != NULL &&
           renderer->location[view][uniform] >= 0;
}

// ---- Uniforms ----

static void set_inputs(const struct renderer *renderer, const struct renderer_inputs *inputs,
                       const GLint *location)
{
    struct camera_basis basis = camera_basis_of(&inputs->camera);
    const float *eye = inputs->camera.position, *mouse = inputs->mouse, *date = inputs->date;
    float width = (float)inputs->width, height = (float)inputs->height;
    double rate = inputs->time_delta > 0.0 ? 1.0 / inputs->time_delta : 60.0;
    float value[INPUT_VALUES][4] = {
        [INPUT_SIZE] = {width, height, 1.0f},
        [INPUT_TIME] = {(float)inputs->time},
        [INPUT_STEP] = {(float)inputs->time_delta},
        [INPUT_RATE] = {(float)(inputs->rate > 0.0 ? inputs->rate : rate)},
        [INPUT_FRAME] = {(float)inputs->frame},
        [INPUT_DATE] = {date[0], date[1], date[2], date[3]},
        [INPUT_MOUSE] = {mouse[0], mouse[1], mouse[2], mouse[3]},
        [INPUT_POINTER] = {mouse[0], mouse[1], fabsf(mouse[2]), fabsf(mouse[3])},
        [INPUT_POINTER_SHARE] = {mouse[0] / width, mouse[1] / height},
        [INPUT_EYE] = {eye[0], eye[1], eye[2]},
        [INPUT_RIGHT] = {basis.right[0], basis.right[1], basis.right[2]},
        [INPUT_UP] = {basis.up[0], basis.up[1], basis.up[2]},
        [INPUT_FORWARD] = {basis.forward[0], basis.forward[1], basis.forward[2]},
        [INPUT_FOCAL] = {renderer->focal_length},
        [INPUT_ORTHO] = {(float)renderer->orthographic},
        [INPUT_ASPECT] = {width / height},
        [INPUT_SOUND_RATE] = {44100.0f}};
    renderer->gl->Uniform3f(renderer->used[UNIFORM_harnessResolution], width, height, 1.0f);
    inputs_set(renderer->gl, &renderer->fragment, location, value);
}

static void set_parameter(const struct gl *gl, GLint location, const struct parameter *parameter)
{
    const double *value = parameter->value;
    float v[4] = {(float)value[0], (float)value[1], (float)value[2], (float)value[3]};
    if (parameter->type != PARAMETER_FLOAT)
        gl->Uniform1i(location, (GLint)value[0]);
    else if (parameter->components == 1)
        gl->Uniform1f(location, v[0]);
    else if (parameter->components == 2)
        gl->Uniform2f(location, v[0], v[1]);
    else if (parameter->components == 3)
        gl->Uniform3f(location, v[0], v[1], v[2]);
    else
        gl->Uniform4f(location, v[0], v[1], v[2], v[3]);
}

// Set a lens uniform to another value, whether it is one of the shader's parameters or not.
static void set_lens(const struct renderer *renderer, int lens, double value)
{
    const struct parameter *own = parameters_find(&renderer->parameters, renderer_lens[lens]);
    struct parameter other = {.type = PARAMETER_FLOAT, .components = 1};
    if (own != NULL)
        other = *own;
    other.value[0] = value;
    set_parameter(renderer->gl, renderer->used[UNIFORM_focalLength + lens], &other);
}

bool renderer_wants_coarse(const struct renderer *renderer, enum shader_view view)
{
    const struct parameter *parameter = parameters_find(&renderer->parameters, "coarsePass");
    return renderer_reads(renderer, view, UNIFORM_iCoarse) && parameter != NULL &&
           parameter->value[0] > 0.5;
}

bool renderer_sculpt(struct renderer *renderer, const struct renderer_inputs *inputs)
{
    return sculpture_follow(&renderer->sculpture, renderer->gl, &renderer->textures,
                            &renderer->parameters.samplers, &renderer->fragment, inputs->strokes);
}

void renderer_use(struct renderer *renderer, const struct renderer_inputs *inputs,
                  enum shader_view view)
{
    const struct gl *gl = renderer->gl;
    const GLint *at = renderer->location[view] + RENDERER_UNIFORM_COUNT;
    renderer->used = renderer->location[view];
    gl->UseProgram(renderer->program[view]);
    set_inputs(renderer, inputs, at);
    at += renderer->fragment.input_count;
    for (int i = 0; i < renderer->parameters.count; i++)
        set_parameter(gl, *at++, &renderer->parameters.item[i]);
    for (int i = 0; i < RENDERER_LENSES && inputs->lens != NULL; i++)
        set_lens(renderer, i, inputs->lens[i]);
    textures_bind(&renderer->textures, gl, at);
    if (renderer_wants_coarse(renderer, view)) // bound to unit 0, which is a sampler's default
        gl->BindTexture(GL_TEXTURE_2D, renderer->coarse.texture);
    gl->BindVertexArray(renderer->vertex_array);
}

// ---- Draws ----

void renderer_clear(const struct gl *gl)
{
    gl->ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    gl->Clear(GL_COLOR_BUFFER_BIT);
}

// Each of several samples adds its fraction to the target; a single sample replaces the target's
// value. Blending is on for a single sample too, because llvmpipe then compiles the program only
// once. Without blending, it compiles the program a second time, for squares of pixels that are
// completely inside the triangle.
static void blend(const struct gl *gl, int samples)
{
    float fraction = 1.0f / (float)samples;
    gl->Enable(GL_BLEND);
    gl->BlendColor(fraction, fraction, fraction, fraction);
    gl->BlendFunc(samples > 1 ? GL_CONSTANT_COLOR : GL_ONE, samples > 1 ? GL_ONE : GL_ZERO);
}

void renderer_pass(const struct renderer *renderer, const struct renderer_sample *sample,
                   int bottom)
{
    const struct gl *gl = renderer->gl;
    const GLint *at = renderer->used;
    const float *jitter = sample->jitter;
    const float offset[2] = {jitter[0], (float)bottom + jitter[1]};
    gl->Uniform1i(at[UNIFORM_iSample], sample->number);
    gl->Uniform1i(at[UNIFORM_iSamples], sample->count);
    gl->Uniform2f(at[UNIFORM_iPixelOffset], offset[0], offset[1]);
    gl->Uniform2f(at[UNIFORM_harnessPixelOffset], offset[0], offset[1]); // for other dialects
    gl->Uniform2f(at[UNIFORM_iPixelJitter], jitter[0], jitter[1]);
    if (!sample->exact)
        blend(gl, sample->count);
    gl->DrawArrays(GL_TRIANGLES, 0, 3);
    gl->Disable(GL_BLEND);
}

void renderer_fill(const struct renderer *renderer, const struct target *table, int left,
                   int bottom, int width, int height)
{
    static const struct renderer_sample only = {0, 1, {0.0f, 0.0f}, false};
    const struct gl *gl = renderer->gl;
    gl->Viewport(0, 0, table->width, table->height);
    gl->Enable(GL_SCISSOR_TEST);
    gl->Scissor(left, bottom, width, height);
    renderer_pass(renderer, &only, 0);
    gl->Disable(GL_SCISSOR_TEST);
}

// Draw all samples of the tile that the scissor selects. Blending averages the samples: it adds
// sample / count. Sample (i, j) of n x n is at ((i + 0.5) / n - 0.5, (j + 0.5) / n - 0.5) from the
// pixel's centre, so a single sample is at the centre, and the picture does not shift with n.
static void draw_samples(const struct renderer *renderer, int samples, int bottom)
{
    for (int k = 0; k < samples * samples; k++) {
        struct renderer_sample sample = {k,
                                         samples * samples,
                                         {((float)(k % samples) + 0.5f) / (float)samples - 0.5f,
                                          ((float)(k / samples) + 0.5f) / (float)samples - 0.5f},
                                         false};
        renderer_pass(renderer, &sample, bottom);
    }
}

void renderer_tiles(const struct renderer *renderer, const int low[2], const int high[2],
                    int bottom, int samples, int frame)
{
    const struct gl *gl = renderer->gl;
    const struct renderer_sample exact = {frame, 1, {0.0f, 0.0f}, true};
    gl->Enable(GL_SCISSOR_TEST);
    for (int y = low[1]; y < high[1]; y += TILE)
        for (int x = low[0]; x < high[0]; x += TILE) {
            gl->Scissor(x, y, high[0] - x < TILE ? high[0] - x : TILE,
                        high[1] - y < TILE ? high[1] - y : TILE);
            if (samples == 0)
                renderer_pass(renderer, &exact, bottom);
            else
                draw_samples(renderer, samples, bottom);
            gl->Flush();
        }
    gl->Disable(GL_SCISSOR_TEST);
}

// ---- The coarse pass ----

static int blocks(int pixels)
{
    return (pixels + COARSE_BLOCK - 1) / COARSE_BLOCK;
}

bool renderer_run_coarse(struct renderer *renderer, const struct renderer_inputs *inputs,
                         enum shader_view view, const int low[2], const int high[2])
{
    const struct gl *gl = renderer->gl;
    int left = low[0] / COARSE_BLOCK, bottom = low[1] / COARSE_BLOCK;
    if (!renderer_wants_coarse(renderer, view))
        return true;
    if (!target_bind(&renderer->coarse, gl, blocks(inputs->width), blocks(inputs->height)))
        return false;
    renderer_use(renderer, inputs, VIEW_COARSE);
    renderer_clear(gl);
    renderer_fill(renderer, &renderer->coarse, left, bottom, blocks(high[0]) - left,
                  blocks(high[1]) - bottom);
    return true;
}
