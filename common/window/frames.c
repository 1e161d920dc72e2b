#include "window/frames.h"

#include <math.h>
#include <string.h>

#include "picture/passes.h"

#define MEASURED    3    // frames from which the resolution is chosen
#define SETTLED     64   // frames after which it stays
#define MUCH_FINER  4    // levels by which another one must be finer until then
#define CALM        128  // frames of a mean after which it begins again, finer and more slowly
#define PATIENCE    6    // levels by which it is finer: 8 times as many pixels
#define MEAN_FRAMES 1024 // of a mean in a page, which then saves the battery
#define HALF_FRAMES 64   // of a mean in half floats, which rounding would spoil

bool window_keeps(const struct window *window)
{
    return passes_keep(window->renderer);
}

struct renderer_inputs window_inputs_at(const struct window *window, int level)
{
    struct renderer_inputs inputs = window->inputs;
    double divisor = resolution_divisor(level);
    inputs.width = resolution_side(level, inputs.width);
    inputs.height = resolution_side(level, inputs.height);
    // A selected ray is that of the picture at full size, as in its table; but frames that are kept
    // have only the reduced size.
    for (int i = 0; i < 2 && inputs.pixel[0] >= 0 && window_keeps(window); i++)
        inputs.pixel[i] = (int)(inputs.pixel[i] / divisor);
    if (!window_keeps(window))
        memcpy(inputs.whole, (const int[]){window->inputs.width, window->inputs.height},
               sizeof inputs.whole);
    for (int i = 0; i < 4; i++)
        inputs.mouse[i] /= (float)divisor;
    inputs.digits /= (float)divisor;
    return inputs;
}

struct renderer_inputs window_inputs_shown(const struct window *window)
{
    return window_inputs_at(window, window_keeps(window) ? window->pace.resolution.level : 0);
}

bool window_averages(const struct window *window)
{
    const struct renderer *renderer = window->renderer;
    GLuint program = renderer->program[VIEW_KEPT];
    return program != 0 &&
           !inputs_reads(renderer->gl, program, &renderer->fragment, INPUT_TIME, INPUT_RATE);
}

int window_last_frame(const struct window *window)
{
    const struct renderer *renderer = window->renderer;
    int last = window->start->frame, most = -1;
    if (window_averages(window))
        most = passes_halves(renderer) ? HALF_FRAMES - 1
               : window->panel.in_page ? MEAN_FRAMES - 1
                                       : -1;
    return last < 0 || (most >= 0 && most < last) ? most : last;
}

bool window_next_frame(struct window *window)
{
    struct renderer_inputs *inputs = &window->inputs;
    const struct renderer_inputs shown = window_inputs_shown(window);
    bool last = inputs->frame == window_last_frame(window);
    if (last || passes_drawn(window->renderer, &shown) <= inputs->frame)
        return !last;
    inputs->frame++;
    return true;
}

void window_follow_frames(struct window *window, int level)
{
    window->inputs.rate = 0.0;
    if (!window_keeps(window))
        return;
    double rate = window->start->rate;
    window->inputs.rate = rate > 0.0 ? rate : PASSES_RATE;
    const struct renderer_inputs drawn = window_inputs_at(window, level);
    if (passes_drawn(window->renderer, &drawn) == 0) {
        window->inputs.frame = 0;
        window->pace.patient &= window->pace.begins; // whatever else has changed, somebody waits
        window->pace.begins = false;
    }
    window->inputs = passes_inputs(&window->inputs, window->inputs.frame);
}

// As the cost of few pixels says little about that of many, a finer level is approached in steps. A
// mean that has become calm while nobody touched anything, or that is paused, is looked at: it
// begins again with more pixels, and each frame may take longer.
int window_choose_level(struct window *window)
{
    struct resolution *resolution = &window->pace.resolution, other = *resolution;
    double pixels = (double)window->inputs.width * window->inputs.height;
    int frame = window->inputs.frame, level = resolution->level;
    bool keeps = window_keeps(window), patient = keeps && window->pace.patient;
    if (!patient && (!keeps || frame < MEASURED))
        return resolution_choose(resolution, pixels);
    if (!patient && frame < SETTLED && resolution_choose(&other, pixels) <= level - MUCH_FINER)
        resolution->level = (int)fmax(other.level, level - 2 * MUCH_FINER);
    else if (!patient && (frame == CALM || window->pace.refines) && level > 0 &&
             window_averages(window)) {
        window->pace.patient = window->pace.begins = true;
        resolution->level = (int)fmax(level - PATIENCE, 0.0);
    }
    return resolution->level;
}
