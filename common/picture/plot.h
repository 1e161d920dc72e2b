// plot.h - how the graph of the distance along a ray is framed, below the slice.
#ifndef PLOT_H
#define PLOT_H

#include "picture/probe.h"
#include "picture/slice.h"

#define PLOT_SHARE 0.5f // of the picture's height, for the graph and its axis

// The graph fills the picture below the slice, down to the axis along the ray.
struct plot_frame {
    float zero;    // the picture's row of distance 0, pixels from its bottom
    float unit;    // distances a pixel
    float split;   // the lowest row of the slice
    float tick;    // distances from tick to tick, 1, 2 or 5 times a power of ten
    int digits[2]; // the tick as digits[0] / 10^digits[1]
};

// Frame the distances of the steps that a slice shows, 0 and what is below it too.
//   slice  receives the row in which its ray runs: the middle of its part of the picture
struct plot_frame plot_frame_of(const struct probe *probe, int width, int height,
                                struct slice_frame *slice);

#endif
