#include "picture/renderer.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "report.h"
#include "picture/slice.h"

// A tile is what one draw call covers: small enough that no single draw holds a GPU for seconds.
#define TILE 512 // pixels

// A file is drawn in bands of at most this many pixels, so that the float target stays small.
#define BAND_PIXELS (4 * 1024 * 1024)

enum { TARGETS = 4 };

static struct renderer_target *target_of(struct renderer *renderer, int number)
{
    struct renderer_target *const targets[TARGETS] = {&renderer->picture, &renderer->sharp,
                                                      &renderer->table, &renderer->single};
    return targets[number];
}

bool renderer_open(struct renderer *renderer, const struct gl *gl, const char *root)
{
    *renderer = (struct renderer){.gl = gl, .root = root, .focal_length = RENDERER_FOCAL_LENGTH};
    char path[4096];
    snprintf(path, sizeof path, "%s/shaders/screen.vert", root);
    if (!shader_read(&renderer->vertex, path, root))
        return false;
    gl->GenVertexArrays(1, &renderer->vertex_array);
    for (int i = 0; i < TARGETS; i++) {
        gl->GenFramebuffers(1, &target_of(renderer, i)->framebuffer);
        gl->GenTextures(1, &target_of(renderer, i)->texture);
    }
    return true;
}

static void forget_programs(struct renderer *renderer)
{
    for (int i = 0; i < SHADER_PROGRAM_COUNT; i++) {
        if (renderer->program[i] != 0)
            renderer->gl->DeleteProgram(renderer->program[i]);
        renderer->program[i] = 0;
    }
}

void renderer_close(struct renderer *renderer)
{
    if (renderer->gl == NULL)
        return;
    forget_programs(renderer);
    textures_free(&renderer->textures, renderer->gl);
    for (int i = 0; i < TARGETS; i++) {
        renderer->gl->DeleteTextures(1, &target_of(renderer, i)->texture);
        renderer->gl->DeleteFramebuffers(1, &target_of(renderer, i)->framebuffer);
    }
    renderer->gl->DeleteVertexArrays(1, &renderer->vertex_array);
    shader_free(&renderer->vertex);
    shader_free(&renderer->fragment);
    parameters_free(&renderer->parameters);
    *renderer = (struct renderer){0};
}

// Link a view of a source. The slice view shows what a probe finds, so it needs both programs: an
// error in one of them is found here, while the old shader is still there.
//   program  by view; 0 where nothing was linked
static bool link_view(struct renderer *renderer, const struct shader_source *source,
                      enum shader_view view, GLuint program[SHADER_PROGRAM_COUNT])
{
    if (!shader_has_view(source, view))
        return false;
    if (program[view] == 0)
        program[view] = shader_link(renderer->gl, &renderer->vertex, source, view);
    if (program[view] == 0)
        return false;
    return view != SHADER_SLICE || link_view(renderer, source, SHADER_PROBE, program);
}

bool renderer_load(struct renderer *renderer, struct shader_source *source,
                   struct parameters *parameters)
{
    GLuint program[SHADER_PROGRAM_COUNT] = {0};
    struct textures textures;
    if (!textures_load(&textures, renderer->gl, &parameters->samplers, source))
        return false;
    if (!link_view(renderer, source, renderer->view, program)) {
        if (program[renderer->view] != 0)
            renderer->gl->DeleteProgram(program[renderer->view]);
        textures_free(&textures, renderer->gl);
        return false;
    }
    parameters_keep(parameters, &renderer->parameters);
    forget_programs(renderer);
    textures_free(&renderer->textures, renderer->gl);
    shader_free(&renderer->fragment);
    parameters_free(&renderer->parameters);
    renderer->fragment = *source;
    renderer->parameters = *parameters;
    renderer->textures = textures;
    *source = (struct shader_source){0};
    *parameters = (struct parameters){0};
    memcpy(renderer->program, program, sizeof program);
    return true;
}

bool renderer_set_view(struct renderer *renderer, enum shader_view view)
{
    if (!link_view(renderer, &renderer->fragment, view, renderer->program))
        return false;
    renderer->view = view;
    return true;
}

// Bind a float target, made anew when its size changes.
static bool bind_target(struct renderer *renderer, struct renderer_target *target, int width,
                        int height)
{
    const struct gl *gl = renderer->gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, target->framebuffer);
    if (target->width == width && target->height == height)
        return true;
    gl->BindTexture(GL_TEXTURE_2D, target->texture);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, NULL);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl->TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    gl->FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target->texture,
                             0);
    if (gl->CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE ||
        gl->GetError() != GL_NO_ERROR) {
        target->width = 0;
        return report(
            "float target %dx%d: the driver cannot make it: try a smaller --size or another "
            "--backend",
            width, height);
    }
    target->width = width;
    target->height = height;
    return true;
}

// The location of a uniform in the program in use; -1, which OpenGL ignores, where nothing reads
// it.
static GLint location(const struct renderer *renderer, const char *name)
{
    return renderer->gl->GetUniformLocation(renderer->used, name);
}

static void set_vector(const struct renderer *renderer, const char *name, const float v[3])
{
    renderer->gl->Uniform3f(location(renderer, name), v[0], v[1], v[2]);
}

static void set_parameter(const struct renderer *renderer, const struct parameter *parameter)
{
    const struct gl *gl = renderer->gl;
    GLint at = location(renderer, parameter->name);
    float v[4] = {(float)parameter->value[0], (float)parameter->value[1],
                  (float)parameter->value[2], (float)parameter->value[3]};
    if (parameter->type != PARAMETER_FLOAT)
        gl->Uniform1i(at, (GLint)parameter->value[0]);
    else if (parameter->components == 1)
        gl->Uniform1f(at, v[0]);
    else if (parameter->components == 2)
        gl->Uniform2f(at, v[0], v[1]);
    else if (parameter->components == 3)
        gl->Uniform3f(at, v[0], v[1], v[2]);
    else
        gl->Uniform4f(at, v[0], v[1], v[2], v[3]);
}

// Everything that stays the same for all tiles and samples of a picture.
static void use_program(struct renderer *renderer, const struct renderer_inputs *inputs,
                        enum shader_view view)
{
    const struct gl *gl = renderer->gl;
    renderer->used = renderer->program[view];
    struct camera_basis basis = camera_basis_of(&inputs->camera);
    gl->UseProgram(renderer->used);
    gl->Uniform3f(location(renderer, "iResolution"), (float)inputs->width, (float)inputs->height,
                  1.0f);
    gl->Uniform1f(location(renderer, "iTime"), (float)inputs->time);
    gl->Uniform1f(location(renderer, "iTimeDelta"), (float)inputs->time_delta);
    gl->Uniform1i(location(renderer, "iFrame"), inputs->frame);
    gl->Uniform4f(location(renderer, "iMouse"), inputs->mouse[0], inputs->mouse[1],
                  inputs->mouse[2], inputs->mouse[3]);
    gl->Uniform1f(location(renderer, "iFrameRate"),
                  inputs->time_delta > 0.0 ? (float)(1.0 / inputs->time_delta) : 60.0f);
    gl->Uniform4f(location(renderer, "iDate"), inputs->date[0], inputs->date[1], inputs->date[2],
                  inputs->date[3]);
    set_vector(renderer, "iCameraPosition", inputs->camera.position);
    set_vector(renderer, "iCameraRight", basis.right);
    set_vector(renderer, "iCameraUp", basis.up);
    set_vector(renderer, "iCameraForward", basis.forward);
    gl->Uniform1f(location(renderer, "focalLength"), renderer->focal_length);
    gl->Uniform1f(location(renderer, "iOrthoView"), (float)renderer->orthographic);
    for (int i = 0; i < renderer->parameters.count; i++)
        set_parameter(renderer, &renderer->parameters.item[i]);
    textures_bind(&renderer->textures, gl, renderer->used);
    gl->BindVertexArray(renderer->vertex_array);
}

// One sample of the pixels of a draw.
struct sample {
    int number, count; // from 0; of how many
    float jitter[2];   // from the pixel's centre, pixels
};

// One draw of the triangle.
//   bottom  the row of the picture with which the target begins
static void draw_pass(const struct renderer *renderer, const struct sample *sample, int bottom)
{
    const float *jitter = sample->jitter;
    const float offset[2] = {jitter[0], (float)bottom + jitter[1]};
    renderer->gl->Uniform1i(location(renderer, "iSample"), sample->number);
    renderer->gl->Uniform1i(location(renderer, "iSamples"), sample->count);
    renderer->gl->Uniform2f(location(renderer, "iPixelOffset"), offset[0], offset[1]);
    // What is not in the program is ignored: this is its name in Shadertoy's form.
    renderer->gl->Uniform2f(location(renderer, "harnessPixelOffset"), offset[0], offset[1]);
    renderer->gl->Uniform2f(location(renderer, "iPixelJitter"), jitter[0], jitter[1]);
    renderer->gl->DrawArrays(GL_TRIANGLES, 0, 3);
}

// All samples of the tile that the scissor holds, averaged by blending: sum of samples / count.
// Sample (i, j) of n x n stands at ((i + 0.5) / n - 0.5, (j + 0.5) / n - 0.5) from the pixel's
// centre, so that one sample is the centre and the picture does not shift with n.
static void draw_samples(const struct renderer *renderer, int samples, int bottom)
{
    for (int k = 0; k < samples * samples; k++) {
        struct sample sample = {k,
                                samples * samples,
                                {((float)(k % samples) + 0.5f) / (float)samples - 0.5f,
                                 ((float)(k / samples) + 0.5f) / (float)samples - 0.5f}};
        draw_pass(renderer, &sample, bottom);
    }
}

// Each column of a probe's table marches the ray again: most rays need only these.
#define PROBE_FIRST 64

static void draw_columns(const struct renderer *renderer, int from, int count)
{
    const struct gl *gl = renderer->gl;
    const struct sample only = {0, 1, {0.0f, 0.0f}}; // whatever the picture's samples
    gl->Viewport(0, 0, PROBE_STEPS, PROBE_ROWS);
    gl->Enable(GL_SCISSOR_TEST);
    gl->Scissor(from, 0, count, PROBE_ROWS);
    draw_pass(renderer, &only, 0);
    gl->Disable(GL_SCISSOR_TEST);
}

// March the ray of a pixel, which leaves its steps in the table.
static bool march_pixel(struct renderer *renderer, const struct renderer_inputs *inputs, int x,
                        int y, struct probe *probe)
{
    const struct gl *gl = renderer->gl;
    if (!link_view(renderer, &renderer->fragment, SHADER_PROBE, renderer->program) ||
        !bind_target(renderer, &renderer->table, PROBE_STEPS, PROBE_ROWS))
        return false;
    use_program(renderer, inputs, SHADER_PROBE);
    gl->Uniform2f(location(renderer, "iProbe"), (float)x + 0.5f, (float)y + 0.5f);
    draw_columns(renderer, 0, PROBE_FIRST);
    float steps[4];
    gl->ReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, steps);
    if (steps[2] > (float)PROBE_FIRST)
        draw_columns(renderer, PROBE_FIRST, PROBE_STEPS - PROBE_FIRST);
    float *values = memory_zeros(PROBE_STEPS * PROBE_ROWS, 4 * sizeof *values);
    renderer_read(renderer, &renderer->table, values);
    probe_unpack(probe, values);
    free(values);
    return true;
}

// The steps that a picture may read: the size of iMarched in shaders/marched.glsl.
#define MARCHED_STEPS 64

// The march that a slice shows, or a picture that reads its steps.
struct march {
    int pixel[2];
    int steps; // columns of the table that hold one
    bool hit;
    struct slice_frame frame;
    float step[MARCHED_STEPS][2]; // t and distance of the first ones
};

// March the chosen pixel's ray, which leaves its steps in the table, and frame it.
static bool march_chosen(struct renderer *renderer, const struct renderer_inputs *inputs,
                         struct march *march)
{
    const int size[2] = {inputs->width, inputs->height};
    for (int i = 0; i < 2; i++)
        march->pixel[i] = inputs->pixel[i] < 0 ? size[i] / 2 : inputs->pixel[i];
    struct probe *probe = memory_zeros(1, sizeof *probe);
    bool done = march_pixel(renderer, inputs, march->pixel[0], march->pixel[1], probe);
    if (done) {
        march->steps = probe_rows(probe);
        march->hit = probe->end == PROBE_HIT;
        march->frame = slice_frame_of(probe, inputs->width, inputs->height, inputs->zoom);
        for (int k = 0; k < MARCHED_STEPS && k < march->steps; k++) {
            march->step[k][0] = probe->step[k].t;
            march->step[k][1] = probe->step[k].distance;
        }
    }
    free(probe);
    return done;
}

// What shaders/slice.glsl reads. The table is the texture of unit 0, which
// a sampler reads unless told otherwise.
static void set_march(const struct renderer *renderer, const struct march *march)
{
    const struct gl *gl = renderer->gl;
    const struct slice_frame *frame = &march->frame;
    gl->BindTexture(GL_TEXTURE_2D, renderer->table.texture);
    gl->Uniform1i(location(renderer, "iMarchSteps"), march->steps);
    gl->Uniform1i(location(renderer, "iMarchHit"), march->hit);
    gl->Uniform2f(location(renderer, "iMarchPixel"), (float)march->pixel[0] + 0.5f,
                  (float)march->pixel[1] + 0.5f);
    gl->Uniform3f(location(renderer, "iSliceFrame"), frame->left, frame->bottom, frame->unit);
    gl->Uniform1f(location(renderer, "iSliceTick"), frame->tick);
    gl->Uniform1f(location(renderer, "iSliceLine"), frame->line);
    gl->Uniform1i(location(renderer, "iSliceTickScaled"), frame->digits[0]);
    gl->Uniform1i(location(renderer, "iSliceDecimals"), frame->digits[1]);
}

// What shaders/marched.glsl reads.
static void set_steps(const struct renderer *renderer, const struct march *march)
{
    const struct gl *gl = renderer->gl;
    int steps = march->steps < MARCHED_STEPS ? march->steps : MARCHED_STEPS;
    gl->Uniform2fv(location(renderer, "iMarched"), MARCHED_STEPS, march->step[0]);
    gl->Uniform1i(location(renderer, "iMarchedSteps"), steps);
    gl->Uniform1i(location(renderer, "iMarchedHit"), march->hit);
}

// The part of a picture that one call draws.
struct part {
    struct renderer_target *target;
    int bottom, height; // the rows of the picture that the target holds
    int from, to;       // the rows of the target to draw
    int left, right;    // and its columns
};

static bool draw_part(struct renderer *renderer, const struct renderer_inputs *inputs,
                      const struct part *part)
{
    const struct gl *gl = renderer->gl;
    struct march march = {0};
    bool slice = renderer->view == SHADER_SLICE;
    GLuint program = renderer->program[renderer->view];
    // The linker keeps only what is used.
    bool reads = slice || (renderer->fragment.form == SHADER_COURSE &&
                           gl->GetUniformLocation(program, "iMarched") >= 0);
    if ((reads && !march_chosen(renderer, inputs, &march)) ||
        !bind_target(renderer, part->target, inputs->width, part->height))
        return false;
    use_program(renderer, inputs, renderer->view);
    if (slice)
        set_march(renderer, &march);
    else if (reads)
        set_steps(renderer, &march);
    // The viewport is the whole picture, of which the target holds a part: so the triangle is set
    // up in the same way whatever the part.
    gl->Viewport(0, -part->bottom, inputs->width, inputs->height);
    gl->Enable(GL_SCISSOR_TEST);
    float share = 1.0f / (float)(inputs->samples * inputs->samples);
    if (inputs->samples > 1) {
        gl->Enable(GL_BLEND);
        gl->BlendColor(share, share, share, share);
        gl->BlendFunc(GL_CONSTANT_COLOR, GL_ONE);
    }
    gl->ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    for (int y = part->from; y < part->to; y += TILE)
        for (int x = part->left; x < part->right; x += TILE) {
            gl->Scissor(x, y, part->right - x < TILE ? part->right - x : TILE,
                        part->to - y < TILE ? part->to - y : TILE);
            gl->Clear(GL_COLOR_BUFFER_BIT); // a shader may discard its pixel
            draw_samples(renderer, inputs->samples, part->bottom);
            gl->Flush();
        }
    gl->Disable(GL_BLEND);
    gl->Disable(GL_SCISSOR_TEST);
    return true;
}

bool renderer_draw(struct renderer *renderer, const struct renderer_inputs *inputs, int bottom,
                   int rows)
{
    struct part part = {&renderer->picture, bottom, rows, 0, rows, 0, inputs->width};
    return draw_part(renderer, inputs, &part);
}

bool renderer_sharpen(struct renderer *renderer, const struct renderer_inputs *inputs, int from,
                      int rows)
{
    struct part part = {&renderer->sharp, 0, inputs->height, from, from + rows, 0, inputs->width};
    return draw_part(renderer, inputs, &part);
}

void renderer_present(struct renderer *renderer, int framebuffer_width, int framebuffer_height)
{
    const struct gl *gl = renderer->gl;
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, renderer->picture.framebuffer);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl->BlitFramebuffer(0, 0, renderer->picture.width, renderer->picture.height, 0, 0,
                        framebuffer_width, framebuffer_height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void renderer_present_sharp(struct renderer *renderer, int from, int rows)
{
    const struct gl *gl = renderer->gl;
    int width = renderer->sharp.width;
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, renderer->sharp.framebuffer);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl->BlitFramebuffer(0, from, width, from + rows, 0, from, width, from + rows,
                        GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void renderer_read(const struct renderer *renderer, const struct renderer_target *target,
                   float *values)
{
    const struct gl *gl = renderer->gl;
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, target->framebuffer);
    gl->PixelStorei(GL_PACK_ALIGNMENT, 1);
    gl->ReadPixels(0, 0, target->width, target->height, GL_RGBA, GL_FLOAT, values);
}

// An even number: drivers take the derivatives of other people's shaders in squares of two by two.
static int rows_of_band(const struct renderer_inputs *inputs)
{
    int band = BAND_PIXELS / inputs->width / 2 * 2;
    return band < inputs->height ? band : inputs->height;
}

// Store the rows of a target in a picture, from one of its rows on.
static bool store(const struct renderer *renderer, const struct renderer_target *target,
                  struct image *image, int bottom)
{
    size_t pixels = (size_t)target->width * (size_t)target->height;
    float *values = pixels > 0 ? malloc(4 * sizeof *values * pixels) : NULL;
    if (values == NULL)
        return report("picture %dx%d: not enough memory: try a smaller --size", image->width,
                      image->height);
    renderer_read(renderer, target, values);
    image_store(image, values, bottom, target->height);
    free(values);
    return true;
}

bool renderer_picture(struct renderer *renderer, const struct renderer_inputs *inputs,
                      struct image *image)
{
    int band = rows_of_band(inputs);
    bool done = image_create(image, inputs->width, inputs->height);
    for (int bottom = 0; bottom < inputs->height && done; bottom += band) {
        int rows = inputs->height - bottom < band ? inputs->height - bottom : band;
        done = renderer_draw(renderer, inputs, bottom, rows);
        if (done && renderer->overlay != NULL)
            overlay_draw(renderer->overlay, bottom);
        done = done && store(renderer, &renderer->picture, image, bottom);
    }
    if (!done)
        image_free(image);
    return done;
}

// The overlay goes over a copy: the window carries on with the picture alone.
static bool copy_under_overlay(struct renderer *renderer)
{
    const struct gl *gl = renderer->gl;
    int width = renderer->sharp.width, height = renderer->sharp.height;
    if (!bind_target(renderer, &renderer->picture, width, height))
        return false;
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, renderer->sharp.framebuffer);
    gl->BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    overlay_draw(renderer->overlay, 0);
    return true;
}

bool renderer_sharp_picture(struct renderer *renderer, struct image *image)
{
    bool over = renderer->overlay != NULL;
    return (!over || copy_under_overlay(renderer)) &&
           image_create(image, renderer->sharp.width, renderer->sharp.height) &&
           store(renderer, over ? &renderer->picture : &renderer->sharp, image, 0);
}

void renderer_pixel_at(const struct renderer_inputs *inputs, const double place[2],
                       const int window[2], int pixel[2])
{
    pixel[0] = (int)floor(place[0] * inputs->width / window[0]);
    pixel[1] = inputs->height - 1 - (int)floor(place[1] * inputs->height / window[1]);
}

// Draw a pixel where its band of the picture has it, so that it gets the same bits.
static bool colour_pixel(struct renderer *renderer, const struct renderer_inputs *inputs, int x,
                         int y, unsigned char colour[3])
{
    int band = rows_of_band(inputs), row = y % band;
    struct part part = {&renderer->single, y - row, band, row, row + 1, x, x + 1};
    struct image pixel = {1, 1, colour};
    float value[4];
    enum shader_view view = renderer->view;
    if (view == SHADER_SLICE &&
        !link_view(renderer, &renderer->fragment, SHADER_PICTURE, renderer->program))
        return false;
    if (view == SHADER_SLICE)
        renderer->view = SHADER_PICTURE;
    bool done = draw_part(renderer, inputs, &part);
    renderer->view = view;
    if (done) {
        renderer->gl->ReadPixels(x, row, 1, 1, GL_RGBA, GL_FLOAT, value);
        image_store(&pixel, value, 0, 1);
    }
    return done;
}

bool renderer_probe(struct renderer *renderer, const struct renderer_inputs *inputs, int x, int y,
                    struct probe *probe)
{
    memset(probe, 0, sizeof *probe);
    return (renderer->fragment.form != SHADER_COURSE ||
            march_pixel(renderer, inputs, x, y, probe)) &&
           colour_pixel(renderer, inputs, x, y, probe->colour);
}
