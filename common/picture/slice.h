// slice.h - how the slice view frames the plane of a ray, and how the plot view frames the
// distances, which it plots below the slice.
#ifndef SLICE_H
#define SLICE_H

#include "picture/probe.h"

// In cells: the height of the axis along the ray, from the picture's bottom, and the room above the
// ray for a step's number.
#define SLICE_AXIS   13.0f
#define SLICE_NUMBER 10.0f

#define SLICE_ZOOM_MINIMUM 0.1f
#define SLICE_ZOOM_MAXIMUM 200.0f // beyond this zoom, the rounding of floats shows in the lines
#define SLICE_PLOT         0.5f   // fraction of the picture's height below a plot's slice

// The plane that contains a ray, with coordinates (along, across): scene units along the ray from
// the eye, and upwards, perpendicular to the ray.
struct slice_frame {
    float left, bottom; // (along, across) of the picture's bottom left corner
    float unit;         // scene units per pixel
    float tick;         // scene units between ticks: 1, 2 or 5 times a power of ten
    float line;         // scene units between lines of equal distance: 1/4 or 1/5 of the tick
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

// Return the side of a cell in pixels: 1 / 180 of the picture's height, rounded down, but at least
// 1.
float slice_cell(int height);

// Frame a march from behind the eye to a little past the march's end. A ray that passed the far
// limit is shown to a little past its point nearest to the scene or, if that point is its start, to
// a little past its last step.
//   zoom  1 or 0 frames the march as above; any other value z enlarges the frame's contents z
//         times, around the point of the march nearest to the scene
struct slice_frame slice_frame_of(const struct probe *probe, int width, int height, float zoom);

// Frame the distances of the steps that a slice shows. The frame always contains 0, and negative
// distances if there are any.
//   probe  count marches that share the frame, such as those of a comparison's two sides
//   slice  the slice's frame, which is moved up into the slice's part of the picture
struct plot_frame plot_frame_of(const struct probe *probe, int count, int width, int height,
                                struct slice_frame *slice);

#endif
