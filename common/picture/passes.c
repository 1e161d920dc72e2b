#include "picture/passes.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "report.h"

#define FILE_YEAR 1970.0f
#define MANY      100 // frames after which progress is reported

static bool keeps(const struct renderer *renderer)
{
    return samplers_keep(&renderer->parameters.samplers);
}

bool passes_keep(const struct renderer *renderer)
{
    return keeps(renderer) || (renderer->comparison != NULL && keeps(renderer->comparison->other));
}

// The number of passes, and one of them, from 0: those of a file with several, or the course
// shader's own.
static int count_of(const struct renderer *renderer)
{
    return renderer->pass_count > 0 ? renderer->pass_count : 1;
}

static struct renderer *pass_of(struct renderer *renderer, int number)
{
    return renderer->pass_count > 0 ? &renderer->pass[number] : renderer;
}

static enum shader_view view_of(const struct renderer *renderer)
{
    return renderer->pass_count > 0 ? VIEW_PICTURE : VIEW_KEPT;
}

bool passes_halves(const struct renderer *renderer)
{
    const struct renderer *pass = renderer->pass_count > 0 ? renderer->pass : renderer;
    return pass->kept.target[0].format == GL_RGBA16F;
}

struct renderer_inputs passes_inputs(const struct renderer_inputs *inputs, int frame)
{
    struct renderer_inputs at = *inputs;
    at.frame = frame;
    at.time = at.begin + (at.rate > 0.0 ? frame / at.rate : 0.0);
    at.time_delta = frame > 0 && at.rate > 0.0 ? 1.0 / at.rate : 0.0;
    if (at.date[0] == FILE_YEAR)
        at.date[3] = (float)at.time;
    return at;
}

// ---- The key ----

// Write the values that a linked view reads, apart from those that change with every frame or with
// the pointer. The linker keeps only the uniforms that are used.
static void write_values(FILE *key, const struct renderer *renderer,
                         const struct renderer_inputs *inputs, enum shader_view view)
{
    const struct shader_source *source = &renderer->fragment;
    const GLint *at = renderer->location[view];
    bool sees = false;
    if (at == NULL)
        return;
    at += RENDERER_UNIFORM_COUNT;
    for (int i = 0; i < source->input_count; i++) {
        enum input_meaning meaning = source->inputs[i].input->meaning;
        sees |= *at++ >= 0 && meaning >= INPUT_EYE && meaning <= INPUT_ORTHO;
    }
    for (int i = 0; i < renderer->parameters.count; i++) {
        const struct parameter *p = &renderer->parameters.item[i];
        for (int k = 0; *at >= 0 && k < p->components; k++)
            fprintf(key, " %a", p->value[k]);
        at++;
    }
    const struct camera *camera = &inputs->camera;
    const float *eye = camera->position;
    if (sees)
        fprintf(key, " %a %a %a %a %a %a %a", (double)eye[0], (double)eye[1], (double)eye[2],
                (double)camera->pan, (double)camera->tilt, (double)renderer->focal_length,
                renderer->orthographic);
}

// Each pass of a file reads the picture's parameters of the same names.
static void give_values(const struct renderer *renderer)
{
    for (int i = 0; i < renderer->pass_count; i++)
        parameters_keep(&renderer->pass[i].parameters, &renderer->parameters);
}

// Everything that the kept frames depend on. A new shader or texture needs no word here, because it
// comes with a struct kept of its own. The caller frees the text.
static char *key_of(const struct renderer *renderer, const struct renderer_inputs *inputs)
{
    char *text;
    FILE *key = memory_open(&text);
    const struct strokes *strokes = inputs->strokes;
    give_values(renderer);
    fprintf(key, "%d %d %a %a", inputs->width, inputs->height, inputs->begin, inputs->rate);
    for (int i = 0; i < renderer->pass_count; i++)
        write_values(key, &renderer->pass[i], inputs, VIEW_PICTURE);
    write_values(key, renderer, inputs, VIEW_KEPT);
    write_values(key, renderer, inputs, VIEW_COARSE);
    if (renderer->sculpture.tool != NULL && strokes != NULL) {
        fprintf(key, " %d", strokes->taken_back);
        for (int i = 0; i < strokes->count; i++)
            fprintf(key, " %d", strokes->item[i].points);
    }
    memory_close(key);
    return text;
}

int passes_drawn(const struct renderer *renderer, const struct renderer_inputs *inputs)
{
    const struct kept *kept = &renderer->kept;
    int drawn = inputs->frame + 1;
    if (keeps(renderer)) {
        char *key = key_of(renderer, inputs);
        bool same = kept->key != NULL && strcmp(kept->key, key) == 0 && kept->frames <= drawn;
        drawn = same ? kept->frames : 0;
        free(key);
    }
    int other =
        renderer->comparison != NULL ? passes_drawn(renderer->comparison->other, inputs) : drawn;
    return other < drawn ? other : drawn;
}

// ---- Frames ----

// Let a reader's samplers read what the passes have kept: the passes that have been drawn in a
// frame give this frame, and the others give the one before.
static void show(struct renderer *reader, struct renderer *renderer, int drawn, int frame)
{
    for (int i = 0; i < reader->textures.count; i++) {
        const struct sampler *sampler = &reader->parameters.samplers.item[i];
        if (sampler->pass == 0)
            continue;
        struct renderer *pass = pass_of(renderer, sampler->pass - 1);
        const struct target *target =
            kept_frame(&pass->kept, sampler->pass > drawn ? frame - 1 : frame);
        target_filter(target, renderer->gl, sampler->filter, pass->fragment.links.repeat);
        texture_borrow(&reader->textures.item[i], target);
    }
}

static void make_levels(const struct renderer *pass, const struct target *target)
{
    pass->gl->BindTexture(GL_TEXTURE_2D, target->texture);
    if (pass->fragment.links.mip_levels)
        pass->gl->GenerateMipmap(GL_TEXTURE_2D);
}

// Draw what the next frame keeps in one pass.
static bool draw_pass(struct renderer *renderer, int number, const struct renderer_inputs *inputs)
{
    const int low[2] = {0, 0}, high[2] = {inputs->width, inputs->height};
    struct renderer *pass = pass_of(renderer, number);
    struct target *target = kept_frame(&pass->kept, inputs->frame);
    enum shader_view view = view_of(renderer);
    show(pass, renderer, number, inputs->frame);
    if (!renderer_sculpt(pass, inputs) || !renderer_run_coarse(pass, inputs, view, low, high) ||
        !target_bind(target, pass->gl, inputs->width, inputs->height))
        return false;
    renderer_use(pass, inputs, view);
    if (pass->fragment.dialect == DIALECT_WHOLE)
        renderer_clear(pass->gl); // a discarded pixel is 0 in the other tools
    pass->gl->Viewport(0, 0, inputs->width, inputs->height);
    renderer_tiles(pass, low, high, 0, 0, inputs->frame);
    make_levels(pass, target);
    return true;
}

// Begin with empty frames.
static bool begin(struct renderer *renderer, const struct renderer_inputs *inputs)
{
    for (int i = 0; i < count_of(renderer); i++) {
        struct renderer *pass = pass_of(renderer, i);
        if (!kept_begin(&pass->kept, pass->gl, pass->fragment.links.shown, inputs->width,
                        inputs->height))
            return report("kept frames %dx%d (passes: %d, two pictures each): the driver has no "
                          "room for them: try a smaller --size",
                          inputs->width, inputs->height, count_of(renderer));
        for (int k = 0; k < 2; k++)
            make_levels(pass, &pass->kept.target[k]);
    }
    return true;
}

static bool follow(struct renderer *renderer, const struct renderer_inputs *inputs)
{
    struct kept *kept = &renderer->kept;
    kept_follow(kept, key_of(renderer, inputs), inputs->frame);
    int first = kept->frames, count = inputs->frame + 1 - first;
    if (first == 0 && !begin(renderer, inputs))
        return false;
    for (; kept->frames <= inputs->frame; kept->frames++) {
        const struct renderer_inputs next = passes_inputs(inputs, kept->frames);
        if (count > MANY)
            report_progress(kept->frames - first, count, "kept frames");
        for (int i = 0; i < count_of(renderer); i++)
            if (!draw_pass(renderer, i, &next))
                return false;
    }
    if (count > MANY)
        report_progress(count, count, "kept frames");
    show(renderer, renderer, renderer->fragment.links.shown ? 0 : count_of(renderer),
         inputs->frame);
    return true;
}

bool passes_follow(struct renderer *renderer, const struct renderer_inputs *inputs)
{
    return (!keeps(renderer) || follow(renderer, inputs)) &&
           (renderer->comparison == NULL || passes_follow(renderer->comparison->other, inputs));
}
