#include "picture/plot.h"

#include <math.h>

#define ABOVE 10.0 // cells over the highest step, for the axis' name
#define BELOW 9.0  // cells under the lowest one: what is inside goes on there
#define TICKS 4.5  // in the graph's height, at most

// The lowest and highest distance of the steps that are shown, and 0.
static void range_of(const struct probe *probe, double left, double right, double range[2])
{
    range[0] = range[1] = 0.0;
    for (int i = 0; i < probe_rows(probe); i++) {
        double t = (double)probe->step[i].t, distance = (double)probe->step[i].distance;
        if (!(t >= left && t <= right && fabs(distance) < 1e9))
            continue;
        range[0] = fmin(range[0], distance);
        range[1] = fmax(range[1], distance);
    }
    if (!(range[1] - range[0] > 0.0))
        range[1] = 1.0;
}

struct plot_frame plot_frame_of(const struct probe *probe, int width, int height,
                                struct slice_frame *slice)
{
    double unit = (double)slice->unit, left = (double)slice->left, range[2];
    double cell = (double)slice_cell(height), split = floor((double)PLOT_SHARE * height + 0.5);
    slice->bottom = (float)(-(split + 0.5 * (height - split)) * unit);
    range_of(probe, left, left + width * unit, range);
    double room = fmax(split - ((double)SLICE_AXIS + ABOVE + BELOW) * cell, 1.0);
    double scale = (range[1] - range[0]) / room;
    struct plot_frame frame = {.split = (float)split, .unit = (float)scale};
    frame.zero = (float)(((double)SLICE_AXIS + BELOW) * cell - range[0] / scale);
    slice_round_tick((range[1] - range[0]) / TICKS, &frame.tick, frame.digits);
    return frame;
}
