// slice.h - which part of the plane of a ray the slice view shows.
#ifndef SLICE_H
#define SLICE_H

#include "picture/probe.h"

// What slice and plot write in the picture, in cells of their digits: the axis along the ray, from
// the picture's bottom; a step's number, from the ray up.
#define SLICE_AXIS   13.0f
#define SLICE_NUMBER 10.0f

#define SLICE_ZOOM_MINIMUM 0.1f
#define SLICE_ZOOM_MAXIMUM 200.0f // beyond it a float's rounding shows in the lines

// The plane that holds a ray: (along, across), scene units along the ray from the eye, and up.
struct slice_frame {
    float left, bottom; // (along, across) of the picture's bottom left corner
    float unit;         // scene units a pixel
    float tick;         // scene units between ticks: 1, 2 or 5 times a power of ten
    float line;         // between lines of equal distance: a fourth or a fifth of the tick
    int digits[2];      // the tick as digits[0] / 10^digits[1]
};

// The side of a cell in a picture of a height, both in pixels.
float slice_cell(int height);

// The least of 1, 2 or 5 times a power of ten that is not less than a length.
//   digits  receives it as digits[0] / 10^digits[1]
void slice_round_tick(double length, float *tick, int digits[2]);

// Frame a march: from behind the eye to a little past its end. A ray that passed the far limit is
// shown to a little past the place where the scene was nearest, or to its last step where that is
// the eye.
//   zoom  1: as above; z: z times as large about that place; 0 counts as 1
struct slice_frame slice_frame_of(const struct probe *probe, int width, int height, float zoom);

#endif
