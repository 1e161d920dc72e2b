#include "command/run.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "memory.h"
#include "picture/aside.h"
#include "picture/panel.h"
#include "report.h"
#include "sequence.h"

// Of a film of a march, while it waits at the first step; twice as long at the last.
#define WALK_WAIT 0.06

// Draw the overlay over a picture that is about to be written, or of a pair the labels alone. The
// caller closes the overlay.
//   probe  of the pixel that --probe names, or NULL
static bool add_overlay(const struct run *run, struct renderer *renderer,
                        const struct renderer_inputs *inputs, const struct probe *probe,
                        struct overlay *overlay)
{
    double asked = run->options.overlay;
    float scale = asked > 0.0 ? (float)asked : overlay_scale_of(inputs->height);
    struct panel panel = {.title = run->title,
                          .renderer = renderer,
                          .ranges = true,
                          .pixel = {inputs->pixel[0], inputs->pixel[1]},
                          .side = pair_side_name(renderer, inputs->width, inputs->pixel[0]),
                          .shown = inputs->shown,
                          .probe = probe};
    if (!overlay_open(overlay, renderer->gl))
        return false;
    if (run->options.has_overlay)
        panel_gather(&panel, overlay, inputs->width, inputs->height, scale);
    else
        pair_gather(renderer, overlay, inputs->width, inputs->height, scale);
    renderer->overlay = overlay;
    return true;
}

bool run_draw(const struct run *run, struct renderer *renderer,
              const struct renderer_inputs *inputs, const struct probe *probe, struct image *image)
{
    struct overlay overlay = {0};
    bool wants = run->options.has_overlay || renderer->pair != NULL;
    bool done = (!wants || add_overlay(run, renderer, inputs, probe, &overlay)) &&
                renderer_picture(renderer, inputs, image);
    renderer->overlay = NULL;
    overlay_close(&overlay);
    return done;
}

static bool write_picture(const struct run *run, struct renderer *renderer,
                          const struct renderer_inputs *inputs, const struct probe *probe,
                          const char *path)
{
    struct image image = {0};
    bool done = run_draw(run, renderer, inputs, probe, &image) && image_write_png(&image, path);
    image_free(&image);
    return done;
}

struct renderer_inputs run_still_inputs(const struct options *options)
{
    const int *pixel = options->probe_count > 0 ? options->probe[options->probe_count - 1] : NULL;
    return (struct renderer_inputs){
        .width = options->width,
        .height = options->height,
        .camera = options->camera,
        .time = options->time,
        .date = {1970.0f, 0.0f, 1.0f, (float)options->time},
        .samples = options->samples,
        .pixel = {pixel != NULL ? pixel[0] : -1, pixel != NULL ? pixel[1] : -1},
        .zoom = 1.0f,
        .shown = (float)(options->step + 1)};
}

void run_start_ray(const struct options *options, const struct renderer *renderer,
                   struct renderer_inputs *inputs, struct renderer_eye *eye)
{
    *eye = aside_eye(renderer, inputs);
    eye->camera = options->from;
    inputs->eye = options->has_from ? eye : NULL;
}

// March the ray that the pictures show, where its steps are counted.
//   probe  receives it
// Returns false, reported: --step is beyond its end.
static bool march_shown(const struct run *run, struct renderer *renderer,
                        const struct renderer_inputs *inputs, struct probe *probe)
{
    int x = inputs->pixel[0] < 0 ? inputs->width / 2 : inputs->pixel[0];
    int y = inputs->pixel[0] < 0 ? inputs->height / 2 : inputs->pixel[1];
    if (!renderer_probe(renderer, inputs, x, y, probe))
        return false;
    if (run->options.step < probe_rows(probe))
        return true;
    return report("--step %d: the march of pixel %d,%d has %d steps, from 0 on", run->options.step,
                  x, y, probe_rows(probe));
}

// How much of a march the picture i of n shows. The walk goes from the first step to the last; it
// waits at both for a while, so that a film that begins again shows where it is.
static float shown_of(int i, int n, int steps)
{
    double share = n > 1 ? (double)i / (n - 1) : 1.0;
    double walked = fmin(fmax((share - WALK_WAIT) / (1.0 - 3.0 * WALK_WAIT), 0.0), 1.0);
    return (float)(1.0 + walked * (steps > 0 ? steps - 1 : 0));
}

// The pictures of --frames, with one context and one program.
static bool write_frames(const struct run *run, struct renderer *renderer)
{
    const struct options *options = &run->options;
    struct renderer_inputs inputs = run_still_inputs(options);
    struct renderer_eye eye;
    char path[PLATFORM_PATH];
    struct probe *probe = options->walk ? memory_zeros(1, sizeof *probe) : NULL;
    run_start_ray(options, renderer, &inputs, &eye);
    bool done = probe == NULL || march_shown(run, renderer, &inputs, probe);
    for (int i = 0; i < options->frames && done; i++) {
        sequence_progress(i, options->frames);
        inputs.frame = i;
        // A walk is along one march: its time stands still.
        inputs.time = options->time + (options->walk ? 0.0 : i / options->fps);
        inputs.date[3] = (float)inputs.time;
        inputs.time_delta = i > 0 ? 1.0 / options->fps : 0.0;
        if (probe != NULL)
            inputs.shown = shown_of(i, options->frames, probe_rows(probe));
        done = sequence_path(options->output, i, path, sizeof path) &&
               write_picture(run, renderer, &inputs, probe, path);
    }
    if (done)
        sequence_progress(options->frames, options->frames);
    free(probe);
    return done;
}

bool run_still(const struct run *run, struct renderer *renderer)
{
    const struct options *options = &run->options;
    struct renderer_inputs inputs = run_still_inputs(options);
    struct renderer_eye eye;
    struct probe *probe = NULL;
    bool done = true;
    run_start_ray(options, renderer, &inputs, &eye);
    if (options->frames > 0)
        return write_frames(run, renderer);
    for (int i = 0; i < options->probe_count && done; i++) {
        probe = probe != NULL ? probe : memory_zeros(1, sizeof *probe);
        done = renderer_probe(renderer, &inputs, options->probe[i][0], options->probe[i][1], probe);
        if (done)
            probe_print(probe, stdout);
    }
    if (done && options->step >= 0) {
        probe = probe != NULL ? probe : memory_zeros(1, sizeof *probe);
        done = march_shown(run, renderer, &inputs, probe);
    }
    done = done && (options->output == NULL ||
                    write_picture(run, renderer, &inputs, probe, options->output));
    free(probe);
    return done;
}
