#include "picture/march.h"

#include <math.h>
#include <stdlib.h>

#include "memory.h"
#include "picture/aside.h"
#include "picture/coarse.h"

// Each column of a probe's table marches the ray again: most rays need only these.
#define PROBE_FIRST 64

static void draw_columns(const struct renderer *renderer, int from, int count)
{
    const struct gl *gl = renderer->gl;
    gl->Viewport(0, 0, PROBE_STEPS, PROBE_ROWS);
    gl->Enable(GL_SCISSOR_TEST);
    gl->Scissor(from, 0, count, PROBE_ROWS);
    pass_draw(renderer, NULL, 0);
    gl->Disable(GL_SCISSOR_TEST);
}

bool march_pixel(struct renderer *renderer, const struct renderer_inputs *inputs, int x, int y,
                 struct probe *probe)
{
    const struct gl *gl = renderer->gl;
    const int low[2] = {x, y}, high[2] = {x + 1, y + 1};
    if (!pass_link(renderer, &renderer->fragment, SHADER_PROBE, renderer->program) ||
        !coarse_run(renderer, inputs, SHADER_PROBE, low, high) ||
        !target_bind(&renderer->table, gl, PROBE_STEPS, PROBE_ROWS))
        return false;
    pass_use(renderer, inputs, SHADER_PROBE);
    coarse_bind(renderer, SHADER_PROBE);
    gl->Uniform2f(pass_location(renderer, "iProbe"), (float)x + 0.5f, (float)y + 0.5f);
    pass_clear(gl);
    draw_columns(renderer, 0, PROBE_FIRST);
    float steps[4];
    gl->ReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, steps);
    if (steps[2] > (float)PROBE_FIRST)
        draw_columns(renderer, PROBE_FIRST, PROBE_STEPS - PROBE_FIRST);
    float *values = memory_zeros(PROBE_STEPS * PROBE_ROWS, 4 * sizeof *values);
    target_read(&renderer->table, gl, values);
    probe_unpack(probe, values);
    free(values);
    return true;
}

bool march_chosen(struct renderer *renderer, const struct renderer_inputs *inputs,
                  struct march *march)
{
    const struct renderer_inputs from = aside_from_eye(inputs);
    const int size[2] = {inputs->width, inputs->height};
    for (int i = 0; i < 2; i++)
        march->pixel[i] = inputs->pixel[i] < 0 ? size[i] / 2 : inputs->pixel[i];
    struct probe *probe = memory_zeros(1, sizeof *probe);
    bool done = march_pixel(renderer, &from, march->pixel[0], march->pixel[1], probe);
    if (done) {
        march->steps = probe_rows(probe);
        march->at = fminf(inputs->shown, (float)march->steps) - 1.0f;
        march->end = probe->end;
        march->hit = probe->end == PROBE_HIT;
        march->frame = slice_frame_of(probe, inputs->width, inputs->height, inputs->zoom);
        if (renderer->view == SHADER_PLOT)
            march->plot = plot_frame_of(probe, inputs->width, inputs->height, &march->frame);
        for (int k = 0; k < MARCH_STEPS && k < march->steps; k++) {
            march->step[k][0] = probe->step[k].t;
            march->step[k][1] = probe->step[k].distance;
        }
    }
    free(probe);
    return done;
}

void march_tell_slice(const struct renderer *renderer, const struct march *march)
{
    const struct gl *gl = renderer->gl;
    const struct slice_frame *frame = &march->frame;
    gl->BindTexture(GL_TEXTURE_2D, renderer->table.texture);
    gl->Uniform1i(pass_location(renderer, "iMarchSteps"), march->steps);
    gl->Uniform1i(pass_location(renderer, "iMarchHit"), march->hit);
    gl->Uniform1f(pass_location(renderer, "iMarchStep"), march->at);
    gl->Uniform2f(pass_location(renderer, "iMarchPixel"), (float)march->pixel[0] + 0.5f,
                  (float)march->pixel[1] + 0.5f);
    gl->Uniform3f(pass_location(renderer, "iSliceFrame"), frame->left, frame->bottom, frame->unit);
    gl->Uniform1f(pass_location(renderer, "iSliceTick"), frame->tick);
    gl->Uniform1f(pass_location(renderer, "iSliceLine"), frame->line);
    gl->Uniform1i(pass_location(renderer, "iSliceTickScaled"), frame->digits[0]);
    gl->Uniform1i(pass_location(renderer, "iSliceDecimals"), frame->digits[1]);
    const struct plot_frame *plot = &march->plot;
    gl->Uniform3f(pass_location(renderer, "iPlotFrame"), plot->zero, plot->unit, plot->split);
    gl->Uniform1f(pass_location(renderer, "iPlotTick"), plot->tick);
    gl->Uniform1i(pass_location(renderer, "iPlotTickScaled"), plot->digits[0]);
    gl->Uniform1i(pass_location(renderer, "iPlotDecimals"), plot->digits[1]);
    gl->Uniform1i(pass_location(renderer, "iPlotEnd"), (int)march->end);
}

void march_tell_steps(const struct renderer *renderer, const struct march *march)
{
    const struct gl *gl = renderer->gl;
    int steps = march->steps < MARCH_STEPS ? march->steps : MARCH_STEPS;
    gl->Uniform2fv(pass_location(renderer, "iMarched"), MARCH_STEPS, march->step[0]);
    gl->Uniform1i(pass_location(renderer, "iMarchedSteps"), steps);
    gl->Uniform1i(pass_location(renderer, "iMarchedHit"), march->hit);
}
