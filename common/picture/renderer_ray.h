// renderer_ray.h - the march of one ray, which a probe prints and a slice shows.
#ifndef RENDERER_RAY_H
#define RENDERER_RAY_H

#include "picture/probe.h"
#include "picture/renderer_pass.h"
#include "picture/slice.h"

#define RENDERER_STEPS 64 // maximum steps a picture can read; see shaders/marched.glsl

// Return the eye of a picture, from which its rays start. A selected ray keeps the eye with which
// it was selected, so that the ray does not move in space when the camera moves on.
struct renderer_eye renderer_eye_of(const struct renderer *renderer,
                                    const struct renderer_inputs *inputs);

// The march that a slice shows, or whose steps a picture reads.
struct march {
    float pixel[2]; // where its ray meets the picture that is drawn, in pixels
    int steps;      // number of steps in renderer->table
    float at;       // the step shown, from 0, with a fraction of the next one; -1 if there is none
    enum probe_end end;
    struct slice_frame frame;
    struct plot_frame plot;        // frame of a plot, below the slice
    float step[RENDERER_STEPS][2]; // t and distance of the first steps
};

// Return the inputs of the same picture, seen from the eye of the selected ray.
struct renderer_inputs renderer_from_eye(const struct renderer_inputs *inputs);

// March the ray of pixel (x, y). Its steps stay in renderer->table.
// Returns false after reporting the error.
bool renderer_march(struct renderer *renderer, const struct renderer_inputs *inputs, int x, int y,
                    struct probe *probe);

// March the selected ray, or the middle one if none is selected, and find the frame that shows it.
//   beside  a second renderer, whose distances must also fit into a plot; NULL if there is none
// Returns false after reporting the error.
bool renderer_march_selected(struct renderer *renderer, struct renderer *beside,
                             const struct renderer_inputs *inputs, struct march *march);

// Set the uniforms of shaders/slice.glsl and plot.glsl, or of shaders/marched.glsl. The slice reads
// the table from texture unit 0, which is a sampler's default.
void renderer_set_slice(const struct renderer *renderer, const struct march *march);
void renderer_set_steps(const struct renderer *renderer, const struct march *march);

// Find the positions of a march's steps in the picture: all are in the ray's pixel or, if the ray
// does not start at the camera, in the pixels whose rays pass through the steps.
//   probe  the probe of pixel (x, y), whose steps are still in renderer->table
// Returns false after reporting the error.
bool renderer_project_steps(struct renderer *renderer, const struct renderer_inputs *inputs, int x,
                            int y, struct probe *probe);

#endif
