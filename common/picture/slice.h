// slice.h - how the slice view frames the plane of a ray, and how the plot view frames the
// distances below it.
#ifndef SLICE_H
#define SLICE_H

#include "picture/probe.h"

// In cells: the height of the axis along the ray, from the picture's bottom, and the room above the
// ray for a step's number.
#define SLICE_AXIS   13.0f
#define SLICE_NUMBER 10.0f

#define SLICE_ZOOM_MINIMUM 0.1f
#define SLICE_ZOOM_MAXIMUM 200.0f // beyond it, the rounding of floats shows in the lines
#define SLICE_PLOT         0.5f   // fraction of the picture's height below a plot's slice

// The plane that contains a ray, with coordinates (along, across): scene units along the ray from
// the eye, and perpendicular to it, upwards.
struct slice_frame {
    float left, bottom; // (along, across) of the picture's bottom left corner
    float unit;         // scene units per pixel
    float tick;         // scene units between ticks: 1, 2 or 5 times a power of ten
    float line;         // between lines of equal distance: a quarter or a fifth of the tick
    int digits[2];      // the tick as digits[0] / 10^digits[1]
};

// The plot fills the picture below the slice, down to the axis along the ray.
struct plot_frame {
    float zero;    // the row of distance 0, pixels from the picture's bottom
    float unit;    // distance per pixel
    float split;   // the lowest row of the slice
    float tick;    // distance between ticks: 1, 2 or 5 times a power of ten
    int digits[2]; // the tick as digits[0] / 10^digits[1]
};

// The side of a cell in a picture of this height, pixels: 1 / 180 of it, rounded down, at least 1.
float slice_cell(int height);

// Frame a march: from behind the eye to a little past its end. A ray that passed the far limit is
// shown to a little past its point nearest to the scene, or, if that point is its start, a little
// past its last step.
//   zoom  1 or 0 frames the march as above; z enlarges it z times, around the point nearest to
//         the scene
struct slice_frame slice_frame_of(const struct probe *probe, int width, int height, float zoom);

// Frame the distances of the steps that a slice shows, including 0 and negative ones.
//   probe  count marches, which share the frame: those of a comparison's two sides
//   slice  moved up into its part of the picture
struct plot_frame plot_frame_of(const struct probe *probe, int count, int width, int height,
                                struct slice_frame *slice);

#endif
