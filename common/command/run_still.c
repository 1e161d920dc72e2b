#include "command/run.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "command/sequence.h"
#include "memory.h"
#include "picture/panel.h"
#include "picture/passes.h"
#include "picture/renderer_ray.h"
#include "report.h"

// The fraction of a film during which it pauses at the first step of a march. It pauses at the last
// step for twice as long.
#define WALK_WAIT 0.06

// Add the overlay, or only the labels of a comparison, to a picture that is about to be written.
// The caller closes the overlay.
static bool add_overlay(struct run *run, const struct renderer_inputs *inputs,
                        const struct probe *probe, struct overlay *overlay)
{
    struct renderer *renderer = &run->picture[0].renderer;
    double asked = run->options.overlay;
    float scale = asked > 0.0 ? (float)asked : overlay_scale_of(inputs->height);
    struct panel panel = {.title = run->title,
                          .renderer = renderer,
                          .ranges = true,
                          .pixel = {inputs->pixel[0], inputs->pixel[1]},
                          .side = comparison_side_name(renderer, inputs->width, inputs->pixel[0]),
                          .shown = inputs->shown,
                          .probe = probe};
    if (!overlay_open(overlay, renderer->gl))
        return false;
    if (run->options.has_overlay)
        panel_gather(&panel, overlay, inputs->width, inputs->height, scale);
    else
        comparison_gather(renderer, overlay, inputs->width, inputs->height, scale);
    renderer->overlay = overlay;
    return true;
}

bool run_draw(struct run *run, const struct renderer_inputs *inputs, const struct probe *probe,
              struct image *image)
{
    struct renderer *renderer = &run->picture[0].renderer;
    struct overlay overlay = {0};
    bool wants = run->options.has_overlay || renderer->comparison != NULL;
    bool done = (!wants || add_overlay(run, inputs, probe, &overlay)) &&
                renderer_picture(renderer, inputs, image);
    renderer->overlay = NULL;
    overlay_close(&overlay);
    return done;
}

static bool write_picture(struct run *run, const struct renderer_inputs *inputs,
                          const struct probe *probe, const char *path)
{
    struct image image = {0};
    bool done = run_draw(run, inputs, probe, &image) && image_write_png(&image, path);
    image_free(&image);
    return done;
}

struct renderer_inputs run_still_inputs(const struct options *options)
{
    const int *pixel = options->probe_count > 0 ? options->probe[options->probe_count - 1] : NULL;
    const struct renderer_inputs inputs = {
        .width = options->width,
        .height = options->height,
        .camera = options->camera,
        .begin = options->time,
        .rate = options->fps,
        .date = {1970.0f, 0.0f, 1.0f},
        .samples = options->samples,
        .pixel = {pixel != NULL ? pixel[0] : -1, pixel != NULL ? pixel[1] : -1},
        .strokes = &options->strokes,
        .zoom = 1.0f,
        .shown = (float)(options->step + 1)};
    return passes_inputs(&inputs, options->frame);
}

void run_start_ray(const struct options *options, const struct renderer *renderer,
                   struct renderer_inputs *inputs, struct renderer_eye *eye)
{
    *eye = renderer_eye_of(renderer, inputs);
    eye->camera = options->from;
    inputs->eye = options->has_from ? eye : NULL;
}

// March the ray that the pictures show. Returns false after reporting the error, such as a --step
// beyond the end of the march.
static bool march_shown(struct run *run, const struct renderer_inputs *inputs, struct probe *probe)
{
    int x = inputs->pixel[0] < 0 ? inputs->width / 2 : inputs->pixel[0];
    int y = inputs->pixel[0] < 0 ? inputs->height / 2 : inputs->pixel[1];
    if (!renderer_probe(&run->picture[0].renderer, inputs, x, y, probe))
        return false;
    if (run->options.step < probe_rows(probe))
        return true;
    return report("--step %d: the march of pixel %d,%d has %d steps, counted from 0",
                  run->options.step, x, y, probe_rows(probe));
}

// Return the number of steps that picture i of n shows. The film pauses at the first and the last
// step, so that a viewer of a repeated film sees where it starts again.
static float shown_of(int i, int n, int steps)
{
    double time = n > 1 ? (double)i / (n - 1) : 1.0;
    double walked = fmin(fmax((time - WALK_WAIT) / (1.0 - 3.0 * WALK_WAIT), 0.0), 1.0);
    return (float)(1.0 + walked * (steps > 0 ? steps - 1 : 0));
}

// Write the pictures of --frames.
static bool write_frames(struct run *run, struct renderer_inputs inputs)
{
    const struct options *options = &run->options;
    char path[PLATFORM_PATH];
    struct probe *probe = options->walk ? memory_zeros(1, sizeof *probe) : NULL;
    bool done = probe == NULL || march_shown(run, &inputs, probe);
    int first = options->first_frame, count = options->frames - first;
    for (int i = first; i < options->frames && done; i++) {
        report_progress(i - first, count, "pictures");
        // The steps of a walk belong to one march, so they are all shown at frame 0.
        inputs = passes_inputs(&inputs, options->walk ? 0 : i);
        if (probe != NULL)
            inputs.shown = shown_of(i, options->frames, probe_rows(probe));
        done = sequence_path(options->output, i, path, sizeof path) &&
               write_picture(run, &inputs, probe, path);
    }
    if (done)
        report_progress(count, count, "pictures");
    free(probe);
    return done;
}

// Print the tables of --probe and write the picture of --output.
static bool write_still(struct run *run, const struct renderer_inputs *inputs)
{
    const struct options *options = &run->options;
    bool marched = options->probe_count > 0 || options->step >= 0, done = true;
    struct probe *probe = marched ? memory_zeros(1, sizeof *probe) : NULL;
    for (int i = 0; i < options->probe_count && done; i++) {
        done = renderer_probe(&run->picture[0].renderer, inputs, options->probe[i][0],
                              options->probe[i][1], probe);
        if (done)
            probe_print(probe, stdout);
    }
    done = done && (options->step < 0 || march_shown(run, inputs, probe)) &&
           (options->output == NULL || write_picture(run, inputs, probe, options->output));
    free(probe);
    return done;
}

bool run_still(struct run *run)
{
    struct renderer_inputs inputs = run_still_inputs(&run->options);
    struct renderer_eye eye;
    run_start_ray(&run->options, &run->picture[0].renderer, &inputs, &eye);
    return run->options.frames > 0 ? write_frames(run, inputs) : write_still(run, &inputs);
}
