// march.h - the march of one pixel's ray: for a probe, and for a picture that shows its steps.
#ifndef MARCH_H
#define MARCH_H

#include "picture/pass.h"
#include "picture/plot.h"
#include "picture/probe.h"
#include "picture/slice.h"

// The steps that a picture may read: the size of iMarched in shaders/marched.glsl.
#define MARCH_STEPS 64

// The march that a slice shows, or a picture that reads its steps.
struct march {
    int pixel[2];
    int steps; // columns of the table that hold one
    float at;  // the step that is looked at, from 0, with a part of the way to the next; -1: none
    bool hit;
    enum probe_end end;
    struct slice_frame frame;
    struct plot_frame plot;     // of a plot, below the slice
    float step[MARCH_STEPS][2]; // t and distance of the first ones
};

// March the ray of pixel (x, y), which leaves its steps in renderer->table.
// Returns false, reported.
bool march_pixel(struct renderer *renderer, const struct renderer_inputs *inputs, int x, int y,
                 struct probe *probe);

// March the ray that is looked at, the middle one where none is chosen, and frame it.
//   inputs  of the picture; the ray starts where they say that it does
// Returns false, reported.
bool march_chosen(struct renderer *renderer, const struct renderer_inputs *inputs,
                  struct march *march);

// Tell the program in use what shaders/slice.glsl reads, and plot.glsl. The table becomes the
// texture of unit 0, which a sampler reads unless told otherwise.
void march_tell_slice(const struct renderer *renderer, const struct march *march);

// Tell the program in use what shaders/marched.glsl reads.
void march_tell_steps(const struct renderer *renderer, const struct march *march);

#endif
