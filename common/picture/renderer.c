#include "picture/renderer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "report.h"
#include "picture/aside.h"
#include "picture/coarse.h"
#include "picture/march.h"
#include "picture/pair.h"

// A tile is what one draw call covers: small enough that no single draw holds a GPU for seconds.
#define TILE 512 // pixels

// A file is drawn in bands of at most this many pixels, so that the float target stays small.
#define BAND_PIXELS (4 * 1024 * 1024)

enum { TARGETS = 6 };

static struct target *target_of(struct renderer *renderer, int number)
{
    struct target *const targets[TARGETS] = {&renderer->picture, &renderer->sharp,
                                             &renderer->table,   &renderer->single,
                                             &renderer->coarse,  &renderer->places};
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
    GLenum form = target_form(gl);
    for (int i = 0; i < TARGETS; i++)
        target_open(target_of(renderer, i), gl, form);
    return true;
}

static void forget_programs(const struct gl *gl, GLuint program[SHADER_PROGRAM_COUNT])
{
    for (int i = 0; i < SHADER_PROGRAM_COUNT; i++) {
        if (program[i] != 0)
            gl->DeleteProgram(program[i]);
        program[i] = 0;
    }
}

void renderer_close(struct renderer *renderer)
{
    if (renderer->gl == NULL)
        return;
    forget_programs(renderer->gl, renderer->program);
    textures_free(&renderer->textures, renderer->gl);
    signs_free(&renderer->signs, renderer->gl);
    for (int i = 0; i < TARGETS; i++)
        target_close(target_of(renderer, i), renderer->gl);
    enlarge_close(&renderer->enlarge, renderer->gl);
    renderer->gl->DeleteVertexArrays(1, &renderer->vertex_array);
    shader_free(&renderer->vertex);
    shader_free(&renderer->fragment);
    parameters_free(&renderer->parameters);
    *renderer = (struct renderer){0};
}

bool renderer_load(struct renderer *renderer, struct shader_source *source,
                   struct parameters *parameters)
{
    GLuint program[SHADER_PROGRAM_COUNT] = {0};
    struct textures textures;
    if (!textures_load(&textures, renderer->gl, &parameters->samplers, source))
        return false;
    if (!pass_link(renderer, source, renderer->view, program)) {
        forget_programs(renderer->gl, program);
        textures_free(&textures, renderer->gl);
        return false;
    }
    parameters_keep(parameters, &renderer->parameters);
    forget_programs(renderer->gl, renderer->program);
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
    struct renderer *other = renderer->pair != NULL ? renderer->pair->other : NULL;
    if ((other != NULL && !renderer_set_view(other, view)) ||
        !pass_link(renderer, &renderer->fragment, view, renderer->program))
        return false;
    renderer->view = view;
    return true;
}

// All samples of the tile that the scissor holds, averaged by blending: sum of samples / count.
// Sample (i, j) of n x n stands at ((i + 0.5) / n - 0.5, (j + 0.5) / n - 0.5) from the pixel's
// centre, so that one sample is the centre and the picture does not shift with n.
static void draw_samples(const struct renderer *renderer, int samples, int bottom)
{
    for (int k = 0; k < samples * samples; k++) {
        struct pass_sample sample = {k,
                                     samples * samples,
                                     {((float)(k % samples) + 0.5f) / (float)samples - 0.5f,
                                      ((float)(k / samples) + 0.5f) / (float)samples - 0.5f}};
        pass_draw(renderer, &sample, bottom);
    }
}

// The part of a picture that one call draws.
struct part {
    struct target *target;
    int bottom, height; // the rows of the picture that the target holds
    int from, to;       // the rows of the target to draw
    int left, right;    // and its columns
    bool fresh;         // what the target held is of no use any more
    // Of a pair: the march of the side that is drawn first, whose frame both sides of a slice have.
    struct march *shared;
};

// Take over the frame of the first side; the first side leaves its own.
static void share_frame(struct march *march, struct march *shared)
{
    if (shared == NULL)
        return;
    if (shared->frame.unit == 0.0f)
        *shared = *march;
    march->frame = shared->frame;
    march->plot = shared->plot;
}

// The numbers and words of a view that writes some, on the unit behind those of the shader's own
// textures.
static void tell_signs(struct renderer *renderer, int height)
{
    const struct gl *gl = renderer->gl;
    int unit = 1 + renderer->textures.count;
    if (!pass_reads(renderer, renderer->view, "iSigns"))
        return;
    gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    signs_bind(&renderer->signs, gl, height);
    gl->Uniform1i(pass_location(renderer, "iSigns"), unit);
    gl->ActiveTexture(GL_TEXTURE0);
}

static bool draw_part(struct renderer *renderer, const struct renderer_inputs *asked,
                      const struct part *part)
{
    const struct gl *gl = renderer->gl;
    struct march march = {0};
    bool slice = form_shows_ray(renderer->view);
    // The plane of a slice is that of the ray, wherever the picture's camera is.
    const struct renderer_inputs own = slice ? aside_from_eye(asked) : *asked, *inputs = &own;
    bool reads = slice || pass_reads(renderer, renderer->view, "iMarched");
    const int low[2] = {part->left, part->bottom + part->from};
    const int high[2] = {part->right, part->bottom + part->to};
    if ((reads && !march_chosen(renderer, inputs, &march)) ||
        !coarse_run(renderer, inputs, renderer->view, low, high) ||
        !target_bind(part->target, gl, inputs->width, part->height))
        return false;
    share_frame(&march, part->shared);
    pass_use(renderer, inputs, renderer->view);
    tell_signs(renderer, inputs->height);
    if (slice)
        march_tell_slice(renderer, &march);
    else if (reads)
        march_tell_steps(renderer, &march);
    coarse_bind(renderer, renderer->view);
    if (part->fresh)
        pass_clear(gl);
    // The viewport is the whole picture, of which the target holds a part: so the triangle is set
    // up in the same way whatever the part.
    gl->Viewport(0, -part->bottom, inputs->width, inputs->height);
    gl->Enable(GL_SCISSOR_TEST);
    for (int y = part->from; y < part->to; y += TILE)
        for (int x = part->left; x < part->right; x += TILE) {
            gl->Scissor(x, y, part->right - x < TILE ? part->right - x : TILE,
                        part->to - y < TILE ? part->to - y : TILE);
            draw_samples(renderer, inputs->samples, part->bottom);
            gl->Flush();
        }
    gl->Disable(GL_SCISSOR_TEST);
    return true;
}

// Draw a part, of a pair each side by its own renderer.
static bool draw_sides(struct renderer *renderer, const struct renderer_inputs *inputs,
                       const struct part *part)
{
    int split = pair_split(renderer, inputs->width);
    struct march shared = {0};
    struct part first = *part, second = *part;
    first.shared = second.shared = &shared;
    first.right = split < part->right ? split : part->right;
    second.left = split > part->left ? split : part->left;
    second.fresh = part->fresh && first.left >= first.right;
    pair_follow(renderer);
    return (first.left >= first.right || draw_part(renderer, inputs, &first)) &&
           (second.left >= second.right || draw_part(renderer->pair->other, inputs, &second));
}

bool renderer_draw(struct renderer *renderer, const struct renderer_inputs *inputs, int bottom,
                   int rows)
{
    struct part part = {&renderer->picture, bottom, rows, 0, rows, 0, inputs->width, true, NULL};
    return draw_sides(renderer, inputs, &part);
}

bool renderer_sharpen(struct renderer *renderer, const struct renderer_inputs *inputs, int from,
                      int rows)
{
    bool first = from + rows == inputs->height;
    struct part part = {
        &renderer->sharp, 0, inputs->height, from, from + rows, 0, inputs->width, first, NULL};
    return draw_sides(renderer, inputs, &part);
}

bool renderer_present(struct renderer *renderer, enum enlarge_filter filter, int width, int height)
{
    const struct gl *gl = renderer->gl;
    const struct target *picture = &renderer->picture;
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, picture->framebuffer);
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    if (picture->width != width || picture->height != height)
        return enlarge_draw(&renderer->enlarge, gl, filter, picture, width, height);
    gl->BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    return true;
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

void renderer_read(const struct renderer *renderer, const struct target *target, float *values)
{
    target_read(target, renderer->gl, values);
}

// An even number: drivers take the derivatives of other people's shaders in squares of two by two.
static int rows_of_band(const struct renderer_inputs *inputs)
{
    int band = BAND_PIXELS / inputs->width / 2 * 2;
    return band < inputs->height ? band : inputs->height;
}

// Store the rows of a target in a picture, from one of its rows on.
static bool store(const struct renderer *renderer, const struct target *target, struct image *image,
                  int bottom)
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
            overlay_draw(renderer->overlay, bottom, rows);
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
    if (!target_bind(&renderer->picture, gl, width, height))
        return false;
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, renderer->sharp.framebuffer);
    gl->BlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    overlay_draw(renderer->overlay, 0, height);
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
    struct part part = {&renderer->single, y - row, band, row, row + 1, x, x + 1, true, NULL};
    struct image pixel = {1, 1, colour};
    float value[4];
    enum shader_view view = renderer->view;
    if (form_shows_ray(view) &&
        !pass_link(renderer, &renderer->fragment, SHADER_PICTURE, renderer->program))
        return false;
    if (form_shows_ray(view))
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
    pair_follow(renderer);
    renderer = pair_at(renderer, inputs->width, x);
    const struct renderer_inputs from = aside_from_eye(inputs);
    return (renderer->fragment.form != SHADER_COURSE ||
            (march_pixel(renderer, &from, x, y, probe) &&
             aside_places(renderer, inputs, x, y, probe))) &&
           colour_pixel(renderer, &from, x, y, probe->colour);
}
