#include "picture/renderer.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "picture/passes.h"
#include "picture/renderer_ray.h"
#include "picture/slice.h"
#include "report.h"

// A picture for a file is drawn in bands of at most this many pixels, so that the float target
// stays small.
#define BAND_PIXELS (4 * 1024 * 1024)

enum { TARGETS = 7 };

// ---- Open, load, close ----

static struct target *target_of(struct renderer *renderer, int number)
{
    struct target *const targets[TARGETS] = {
        &renderer->picture, &renderer->sharp,     &renderer->table, &renderer->single,
        &renderer->coarse,  &renderer->projected, &renderer->points};
    return targets[number];
}

bool renderer_open(struct renderer *renderer, const struct gl *gl, const char *root)
{
    char path[4096];
    *renderer = (struct renderer){.root = root, .focal_length = RENDERER_FOCAL_LENGTH};
    snprintf(path, sizeof path, "%s/shaders/screen.vert", root);
    if (!shader_expand(&renderer->vertex, path, root, NULL))
        return false;
    renderer->gl = gl;
    gl->GenVertexArrays(1, &renderer->vertex_array);
    GLenum format = target_format(gl, true);
    for (int i = 0; i < TARGETS; i++)
        target_open(target_of(renderer, i), gl, format);
    return true;
}

// Free the loaded shader.
static void unload(struct renderer *renderer)
{
    renderer_unlink(renderer);
    textures_free(&renderer->textures, renderer->gl);
    sculpture_forget(&renderer->sculpture);
    kept_free(&renderer->kept, renderer->gl);
    for (int i = 0; i < renderer->pass_count; i++)
        unload(&renderer->pass[i]);
    free(renderer->pass);
    renderer->pass = NULL;
    renderer->pass_count = 0;
    shader_free(&renderer->fragment);
    parameters_free(&renderer->parameters);
}

void renderer_close(struct renderer *renderer)
{
    if (renderer->gl == NULL)
        return;
    unload(renderer);
    axis_labels_free(&renderer->labels, renderer->gl);
    for (int i = 0; i < TARGETS; i++)
        target_close(target_of(renderer, i), renderer->gl);
    renderer->gl->DeleteVertexArrays(1, &renderer->vertex_array);
    shader_free(&renderer->vertex);
    *renderer = (struct renderer){0};
}

// Load the passes of a file that has several. A pass uses the vertex shader and the triangle of its
// renderer. Returns false after reporting the error; then those that are loaded must be freed.
static bool load_passes(struct renderer *next)
{
    struct shader_source *source = &next->fragment;
    bool done = true;
    next->pass = memory_zeros((size_t)source->pass_count + 1, sizeof *next->pass);
    next->pass_count = 0;
    while (done && next->pass_count < source->pass_count) {
        struct renderer *pass = &next->pass[next->pass_count];
        *pass = (struct renderer){.gl = next->gl,
                                  .root = next->root,
                                  .vertex = next->vertex,
                                  .vertex_array = next->vertex_array,
                                  .focal_length = next->focal_length};
        pass->fragment = source->pass[next->pass_count];
        source->pass[next->pass_count++] = (struct shader_source){0};
        pass->fragment.warned = source->warned; // a warning is printed once for all passes
        source->warned = NULL;
        done =
            parameters_read(&pass->parameters, &pass->fragment) &&
            textures_load(&pass->textures, pass->gl, &pass->parameters.samplers, &pass->fragment) &&
            renderer_link(pass, VIEW_PICTURE);
        source->warned = pass->fragment.warned;
        pass->fragment.warned = NULL;
        if (source->unset == NULL && pass->fragment.unset != NULL)
            source->unset = memory_text("%s", pass->fragment.unset);
    }
    return done;
}

bool renderer_prepare(const struct renderer *renderer, struct renderer *next, enum shader_view view,
                      struct shader_source *source, struct parameters *parameters)
{
    struct textures textures;
    if (!textures_load(&textures, renderer->gl, &parameters->samplers, source))
        return false;
    *next = *renderer;
    next->textures = textures;
    next->fragment = *source;
    next->parameters = *parameters;
    next->sculpture = (struct sculpture){.tool = renderer->sculpture.tool};
    next->kept = (struct kept){0};
    next->view = view;
    memset(next->program, 0, sizeof next->program);
    memset(next->location, 0, sizeof next->location);
    if (!load_passes(next) || !renderer_link(next, view)) {
        *source = next->fragment;
        next->fragment = (struct shader_source){0};
        next->parameters = (struct parameters){0};
        unload(next);
        *next = (struct renderer){0};
        return false;
    }
    *source = (struct shader_source){0};
    *parameters = (struct parameters){0};
    return true;
}

void renderer_take(struct renderer *renderer, struct renderer *next)
{
    unload(renderer);
    *renderer = *next;
    *next = (struct renderer){0};
}

void renderer_drop(struct renderer *next)
{
    if (next->gl != NULL)
        unload(next);
    *next = (struct renderer){0};
}

bool renderer_load(struct renderer *renderer, struct shader_source *source,
                   struct parameters *parameters)
{
    struct renderer next;
    bool first = renderer->fragment.text == NULL; // it must have the view that was asked for
    enum shader_view view =
        first || source->dialect == DIALECT_COURSE ? renderer->view : VIEW_PICTURE;
    if (!renderer_prepare(renderer, &next, view, source, parameters))
        return false;
    parameters_keep(&next.parameters, &renderer->parameters);
    renderer_take(renderer, &next);
    return true;
}

bool renderer_set_view(struct renderer *renderer, enum shader_view view)
{
    struct renderer *other = renderer->comparison != NULL ? renderer->comparison->other : NULL;
    if (!renderer_link(renderer, view) || (other != NULL && !renderer_set_view(other, view)))
        return false;
    renderer->view = view;
    return true;
}

// ---- Draw ----

int renderer_split(const struct renderer *renderer, int width)
{
    return renderer->comparison != NULL ? (int)lround(renderer->comparison->divider * width)
                                        : width;
}

struct renderer *renderer_at(struct renderer *renderer, int width, int x)
{
    bool first = renderer->comparison == NULL || x < renderer_split(renderer, width);
    return first ? renderer : renderer->comparison->other;
}

// The part of a picture that one call of draw_sides draws.
struct part {
    struct target *target;
    int bottom, height;      // the rows of the picture that the target contains
    int from, to;            // the rows of the target that are drawn
    int left, right;         // the columns that are drawn
    bool fresh;              // the target is cleared first
    struct march *shared;    // march of a comparison's first side, whose frame both slices use
    struct renderer *beside; // the comparison's other side, which must also fit into a plot's frame
};

// Use the frame of the comparison's first side, which is drawn first and stores its march in
// shared.
static void share_frame(struct march *march, struct march *shared)
{
    if (shared == NULL)
        return;
    if (shared->frame.unit == 0.0f)
        *shared = *march;
    march->frame = shared->frame;
    march->plot = shared->plot;
}

// If the view writes numbers and words, bind their texture to the unit after those of the shader's
// textures.
static void set_labels(struct renderer *renderer, const struct renderer_inputs *inputs)
{
    const struct gl *gl = renderer->gl;
    int unit = 1 + renderer->textures.count, cell = (int)slice_cell(inputs->height);
    if (renderer->view == VIEW_PICTURE)
        cell = (int)fmaxf((float)cell, roundf(inputs->digits / AXIS_LABELS_DIGIT));
    if (!renderer_reads(renderer, renderer->view, UNIFORM_iSigns))
        return;
    gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    axis_labels_bind(&renderer->labels, gl, cell);
    gl->Uniform1i(renderer->used[UNIFORM_iSigns], unit);
    gl->ActiveTexture(GL_TEXTURE0);
}

static bool draw_part(struct renderer *renderer, const struct renderer_inputs *asked,
                      const struct part *part)
{
    const struct gl *gl = renderer->gl;
    struct march march = {0};
    bool slice = shader_shows_ray(renderer->view);
    // The plane of a slice contains the ray, wherever the picture's camera is.
    const struct renderer_inputs own = slice ? renderer_from_eye(asked) : *asked, *inputs = &own;
    bool reads = slice || renderer_reads(renderer, renderer->view, UNIFORM_iMarched);
    const int low[2] = {part->left, part->bottom + part->from};
    const int high[2] = {part->right, part->bottom + part->to};
    if (!renderer_sculpt(renderer, inputs) ||
        (reads && !renderer_march_selected(renderer, part->beside, inputs, &march)) ||
        !renderer_run_coarse(renderer, inputs, renderer->view, low, high) ||
        !target_bind(part->target, gl, inputs->width, part->height))
        return false;
    share_frame(&march, part->shared);
    renderer_use(renderer, inputs, renderer->view);
    set_labels(renderer, inputs);
    if (slice)
        renderer_set_slice(renderer, &march);
    else if (reads)
        renderer_set_steps(renderer, &march);
    if (part->fresh)
        renderer_clear(gl);
    // The viewport covers the whole picture, whatever part the target contains, so the triangle
    // never changes.
    gl->Viewport(0, -part->bottom, inputs->width, inputs->height);
    renderer_tiles(renderer, (const int[]){part->left, part->from},
                   (const int[]){part->right, part->to}, part->bottom, inputs->samples, 0);
    return true;
}

// Draw a part, each side of a comparison with its own renderer.
static bool draw_sides(struct renderer *renderer, const struct renderer_inputs *inputs,
                       const struct part *part)
{
    int split = renderer_split(renderer, inputs->width);
    struct march shared = {0};
    struct part first = *part, second = *part;
    first.shared = second.shared = &shared;
    first.beside = split < inputs->width ? renderer->comparison->other : NULL;
    first.right = split < part->right ? split : part->right;
    second.left = split > part->left ? split : part->left;
    second.fresh = part->fresh && first.left >= first.right;
    return passes_follow(renderer, inputs) &&
           (first.left >= first.right || draw_part(renderer, inputs, &first)) &&
           (second.left >= second.right || draw_part(renderer->comparison->other, inputs, &second));
}

bool renderer_draw(struct renderer *renderer, const struct renderer_inputs *inputs, int bottom,
                   int rows)
{
    struct part part = {.target = &renderer->picture,
                        .bottom = bottom,
                        .height = rows,
                        .to = rows,
                        .right = inputs->width,
                        .fresh = true};
    return draw_sides(renderer, inputs, &part);
}

bool renderer_sharpen(struct renderer *renderer, const struct renderer_inputs *inputs,
                      const struct renderer_piece *piece)
{
    struct part part = {.target = &renderer->sharp,
                        .height = inputs->height,
                        .from = piece->bottom,
                        .to = piece->top,
                        .left = piece->left,
                        .right = piece->right,
                        .fresh = piece->top == inputs->height && piece->left == 0};
    return draw_sides(renderer, inputs, &part);
}

// Copy rows [from, from + rows) of a target into the framebuffer that is bound for drawing.
static void copy_rows(const struct gl *gl, const struct target *target, int from, int rows)
{
    int width = target->width, to = from + rows;
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, target->framebuffer);
    gl->BlitFramebuffer(0, from, width, to, 0, from, width, to, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void renderer_present(const struct renderer *renderer, int width, int height)
{
    const struct gl *gl = renderer->gl;
    const struct target *picture = &renderer->picture;
    bool same = picture->width == width && picture->height == height;
    gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, picture->framebuffer);
    gl->BlitFramebuffer(0, 0, picture->width, picture->height, 0, 0, width, height,
                        GL_COLOR_BUFFER_BIT, same ? GL_NEAREST : GL_LINEAR);
}

void renderer_present_sharp(const struct renderer *renderer, int from, int rows)
{
    renderer->gl->BindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    copy_rows(renderer->gl, &renderer->sharp, from, rows);
}

// Return the number of rows in a band: all rows, or an even number, because drivers compute
// derivatives in blocks of two by two pixels.
static int rows_of_band(const struct renderer_inputs *inputs)
{
    int band = BAND_PIXELS / inputs->width / 2 * 2;
    return band < inputs->height ? band : inputs->height;
}

// Store the rows of a target in an image, from row bottom upwards.
static bool store(const struct renderer *renderer, const struct target *target, struct image *image,
                  int bottom)
{
    size_t pixels = (size_t)target->width * (size_t)target->height;
    float *values = pixels > 0 ? malloc(4 * sizeof *values * pixels) : NULL;
    if (values == NULL)
        return report("picture %dx%d: not enough memory: try a smaller --size%s", image->width,
                      image->height, memory_limit());
    target_read(target, renderer->gl, values);
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

// The overlay is drawn over a copy, so the window's sharp picture does not change.
bool renderer_sharp_picture(struct renderer *renderer, struct image *image)
{
    const struct target *sharp = &renderer->sharp;
    if (!target_bind(&renderer->picture, renderer->gl, sharp->width, sharp->height))
        return false;
    copy_rows(renderer->gl, sharp, 0, sharp->height);
    if (renderer->overlay != NULL)
        overlay_draw(renderer->overlay, 0, sharp->height);
    bool done = image_create(image, sharp->width, sharp->height) &&
                store(renderer, &renderer->picture, image, 0);
    if (!done)
        image_free(image);
    return done;
}

// Draw a pixel at its position in its band of the picture, so that it gets the same bits as in the
// picture.
static bool colour_pixel(struct renderer *renderer, const struct renderer_inputs *inputs, int x,
                         int y, unsigned char colour[3])
{
    int band = rows_of_band(inputs), row = y % band;
    struct part part = {.target = &renderer->single,
                        .bottom = y - row,
                        .height = band,
                        .from = row,
                        .to = row + 1,
                        .left = x,
                        .right = x + 1,
                        .fresh = true};
    struct image pixel = {1, 1, colour};
    float value[4];
    enum shader_view view = renderer->view;
    if (shader_shows_ray(view)) {
        if (!renderer_link(renderer, VIEW_PICTURE))
            return false;
        renderer->view = VIEW_PICTURE;
    }
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
    renderer = renderer_at(renderer, inputs->width, x);
    const struct renderer_inputs from = renderer_from_eye(inputs);
    if (!passes_follow(renderer, inputs))
        return false;
    return (renderer->fragment.dialect != DIALECT_COURSE ||
            (renderer_march(renderer, &from, x, y, probe) &&
             renderer_project_steps(renderer, inputs, x, y, probe))) &&
           colour_pixel(renderer, &from, x, y, probe->colour);
}
