#include "picture/renderer_ray.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"

// Each column of a probe's table marches the ray again, so only this many columns are drawn first:
// most rays need no more.
#define FIRST_COLUMNS 64

// ---- The eye ----

struct renderer_eye renderer_eye_of(const struct renderer *renderer,
                                    const struct renderer_inputs *inputs)
{
    struct renderer_eye eye = {.camera = inputs->camera,
                               .lens = {(double)renderer->focal_length, 0.0}};
    for (int i = 0; i < RENDERER_LENSES; i++) {
        const struct parameter *lens = parameters_find(&renderer->parameters, renderer_lens[i]);
        if (lens != NULL)
            eye.lens[i] = lens->value[0];
    }
    return eye;
}

struct renderer_inputs renderer_from_eye(const struct renderer_inputs *inputs)
{
    struct renderer_inputs from = *inputs;
    if (inputs->eye == NULL)
        return from;
    from.camera = inputs->eye->camera;
    from.lens = inputs->eye->lens;
    from.eye = NULL;
    return from;
}

// True if the selected ray's eye is not that of the picture, because its camera or its lens
// differs.
static bool is_pinned(const struct renderer *renderer, const struct renderer_inputs *inputs)
{
    if (inputs->eye == NULL)
        return false;
    struct renderer_eye here = renderer_eye_of(renderer, inputs);
    const struct camera *a = &here.camera, *b = &inputs->eye->camera;
    bool same = a->pan == b->pan && a->tilt == b->tilt;
    for (int i = 0; i < 3; i++)
        same = same && a->position[i] == b->position[i];
    for (int i = 0; i < RENDERER_LENSES; i++)
        same = same && here.lens[i] == inputs->eye->lens[i];
    return !same;
}

// ---- The march ----

bool renderer_march(struct renderer *renderer, const struct renderer_inputs *inputs, int x, int y,
                    struct probe *probe)
{
    const struct gl *gl = renderer->gl;
    const int low[2] = {x, y}, high[2] = {x + 1, y + 1};
    struct target *table = &renderer->table;
    if (!renderer_link(renderer, VIEW_PROBE) || !renderer_sculpt(renderer, inputs) ||
        !renderer_run_coarse(renderer, inputs, VIEW_PROBE, low, high) ||
        !target_bind(table, gl, PROBE_STEPS, PROBE_ROWS))
        return false;
    renderer_use(renderer, inputs, VIEW_PROBE);
    gl->Uniform2f(renderer->used[UNIFORM_iProbe], (float)x + 0.5f, (float)y + 0.5f);
    renderer_clear(gl);
    renderer_fill(renderer, table, 0, 0, FIRST_COLUMNS, PROBE_ROWS);
    float steps[4];
    gl->ReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, steps);
    int more = (int)fminf(steps[2], (float)PROBE_STEPS) - FIRST_COLUMNS;
    if (more > 0)
        renderer_fill(renderer, table, FIRST_COLUMNS, 0, more, PROBE_ROWS);
    float *values = memory_zeros(PROBE_STEPS * PROBE_ROWS, 4 * sizeof *values);
    target_read(table, gl, values);
    probe_unpack(probe, values);
    free(values);
    return true;
}

bool renderer_march_selected(struct renderer *renderer, struct renderer *beside,
                             const struct renderer_inputs *inputs, struct march *march)
{
    struct renderer_inputs from = renderer_from_eye(inputs);
    if (inputs->whole[0] > 0) {
        from.width = inputs->whole[0];
        from.height = inputs->whole[1];
    }
    int x = inputs->pixel[0] < 0 ? from.width / 2 : inputs->pixel[0];
    int y = inputs->pixel[0] < 0 ? from.height / 2 : inputs->pixel[1];
    float scale = (float)inputs->height / (float)from.height; // the same point of the screen
    march->pixel[0] =
        0.5f * (float)inputs->width + scale * ((float)x + 0.5f - 0.5f * (float)from.width);
    march->pixel[1] =
        0.5f * (float)inputs->height + scale * ((float)y + 0.5f - 0.5f * (float)from.height);
    struct probe *probe = memory_zeros(2, sizeof *probe);
    bool plots = renderer->view == VIEW_PLOT;
    bool done = (!plots || beside == NULL || renderer_march(beside, &from, x, y, &probe[1])) &&
                renderer_march(renderer, &from, x, y, probe);
    if (done) {
        march->steps = probe_rows(probe);
        march->at = fminf(inputs->shown, (float)march->steps) - 1.0f;
        march->end = probe->end;
        march->frame = slice_frame_of(probe, inputs->width, inputs->height, inputs->zoom);
        if (plots)
            march->plot = plot_frame_of(probe, 2, inputs->width, inputs->height, &march->frame);
        for (int k = 0; k < RENDERER_STEPS && k < march->steps; k++) {
            march->step[k][0] = probe->step[k].t;
            march->step[k][1] = probe->step[k].distance;
        }
    }
    free(probe);
    return done;
}

void renderer_set_slice(const struct renderer *renderer, const struct march *march)
{
    const struct gl *gl = renderer->gl;
    const GLint *at = renderer->used;
    const struct slice_frame *frame = &march->frame;
    const struct plot_frame *plot = &march->plot;
    gl->BindTexture(GL_TEXTURE_2D, renderer->table.texture);
    gl->Uniform1i(at[UNIFORM_iMarchSteps], march->steps);
    gl->Uniform1i(at[UNIFORM_iMarchHit], march->end == PROBE_HIT);
    gl->Uniform1f(at[UNIFORM_iMarchStep], march->at);
    gl->Uniform2f(at[UNIFORM_iMarchPixel], march->pixel[0], march->pixel[1]);
    gl->Uniform3f(at[UNIFORM_iSliceFrame], frame->left, frame->bottom, frame->unit);
    gl->Uniform1f(at[UNIFORM_iSliceTick], frame->tick);
    gl->Uniform1f(at[UNIFORM_iSliceLine], frame->line);
    gl->Uniform1i(at[UNIFORM_iSliceTickScaled], frame->digits[0]);
    gl->Uniform1i(at[UNIFORM_iSliceDecimals], frame->digits[1]);
    gl->Uniform3f(at[UNIFORM_iPlotFrame], plot->zero, plot->unit, plot->split);
    gl->Uniform1f(at[UNIFORM_iPlotTick], plot->tick);
    gl->Uniform1i(at[UNIFORM_iPlotTickScaled], plot->digits[0]);
    gl->Uniform1i(at[UNIFORM_iPlotDecimals], plot->digits[1]);
    gl->Uniform1i(at[UNIFORM_iPlotEnd], (int)march->end);
}

void renderer_set_steps(const struct renderer *renderer, const struct march *march)
{
    const struct gl *gl = renderer->gl;
    const GLint *at = renderer->used;
    gl->Uniform2fv(at[UNIFORM_iMarched], RENDERER_STEPS, march->step[0]);
    gl->Uniform1i(at[UNIFORM_iMarchedSteps],
                  march->steps < RENDERER_STEPS ? march->steps : RENDERER_STEPS);
    gl->Uniform1i(at[UNIFORM_iMarchedHit], march->end == PROBE_HIT);
}

// ---- The steps in the picture ----

// Find the pixels whose rays pass through the steps of a ray that does not start at the camera.
static bool find_steps(struct renderer *renderer, const struct renderer_inputs *inputs,
                       struct probe *probe)
{
    const struct gl *gl = renderer->gl;
    struct target *projected = &renderer->projected;
    if (!renderer_link(renderer, VIEW_POSITIONS) || !target_bind(projected, gl, PROBE_STEPS, 1))
        return false;
    renderer_use(renderer, inputs, VIEW_POSITIONS);
    gl->BindTexture(GL_TEXTURE_2D, renderer->table.texture);
    renderer_clear(gl);
    renderer_fill(renderer, projected, 0, 0, probe_rows(probe), 1);
    float(*pixel)[4] = memory_zeros(PROBE_STEPS, sizeof *pixel);
    target_read(projected, gl, pixel[0]);
    for (int k = 0; k < probe_rows(probe); k++) {
        memcpy(probe->step[k].pixel, pixel[k], sizeof probe->step[k].pixel);
        probe->step[k].seen = pixel[k][2] > 0.5f;
    }
    free(pixel);
    return true;
}

bool renderer_project_steps(struct renderer *renderer, const struct renderer_inputs *inputs, int x,
                            int y, struct probe *probe)
{
    probe->pinned = is_pinned(renderer, inputs);
    for (int k = 0; k < probe_rows(probe); k++) {
        probe->step[k].pixel[0] = (float)x + 0.5f;
        probe->step[k].pixel[1] = (float)y + 0.5f;
        probe->step[k].seen = true;
    }
    return !probe->pinned || probe_rows(probe) == 0 || find_steps(renderer, inputs, probe);
}
