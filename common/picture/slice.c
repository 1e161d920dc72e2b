#include "picture/slice.h"

#include <math.h>

#define BEHIND     0.10  // length shown left of the eye, as a fraction of the length to its right
#define BEYOND     0.35  // length shown right of a hit, as a fraction of the length up to the hit
#define NOTHING    8.0   // length shown of a ray that was not marched, scene units
#define TICK_SHARE 0.115 // minimum distance between ticks, as a fraction of the picture's width
#define CELLS      180   // cells in the picture's height
#define PLOT_ABOVE 10.0  // cells above the highest distance, for the axis's name
#define PLOT_BELOW 9.0   // cells below the lowest distance
#define PLOT_TICKS 4.5   // maximum number of tick intervals in the plotted range

float slice_cell(int height)
{
    return fmaxf(1.0f, floorf((float)height / CELLS));
}

// Return the step with the smallest distance, which for a hit is usually the last step.
static const struct probe_step *nearest_step(const struct probe *probe, int steps)
{
    const struct probe_step *nearest = &probe->step[0];
    for (int i = 1; i < steps; i++)
        if (probe->step[i].distance < nearest->distance)
            nearest = &probe->step[i];
    return nearest;
}

// Find the smallest number that is not less than a length and is 1, 2 or 5 times a power of ten.
static void round_tick(double length, float *tick, int digits[2])
{
    int power = (int)floor(log10(length));
    double share = length / pow(10.0, power);
    int first = share <= 1.0 ? 1 : share <= 2.0 ? 2 : share <= 5.0 ? 5 : 10;
    if (first == 10) {
        first = 1;
        power++;
    }
    double rounded = first * pow(10.0, power);
    *tick = (float)rounded;
    digits[0] = power < 0 ? first : (int)lround(rounded);
    digits[1] = power < 0 ? -power : 0;
}

struct slice_frame slice_frame_of(const struct probe *probe, int width, int height, float zoom)
{
    int steps = probe_rows(probe);
    double centre = 0.0, end = NOTHING;
    if (steps > 0) {
        const struct probe_step *nearest = nearest_step(probe, steps);
        double last = (double)probe->step[steps - 1].t;
        centre = (double)nearest->t;
        // A ray that only moves away from the scene, such as a shadow ray or a ray into the sky, is
        // shown in full.
        if (probe->end == PROBE_PASSED && nearest == &probe->step[0])
            end = 1.05 * last;
        else if (probe->end == PROBE_PASSED)
            end = fmin(last, 1.5 * centre + 2.0 * fabs((double)nearest->distance));
        else
            end = last * (1.0 + BEYOND);
    }
    if (!(fabs(centre) < 1e9)) // NaN or infinite, because of a mistake in the shader
        centre = 0.0;
    if (!(end > 0.0 && end < 1e9)) // likewise, or 0 for a march that starts on the surface
        end = fmax(centre, 1.0);
    double times = zoom > 0.0f ? (double)zoom : 1.0, shown = (1.0 + BEHIND) * end / times;
    double left = centre + (-BEHIND * end - centre) / times;
    struct slice_frame frame = {.left = (float)left, .unit = (float)(shown / width)};
    frame.bottom = -0.5f * (float)height * frame.unit;
    round_tick(TICK_SHARE * shown, &frame.tick, frame.digits);
    // A tick of 1 or 5 is divided into fifths, a tick of 2 into quarters.
    bool quarters = frame.digits[0] == 2 * (int)lround(pow(10.0, floor(log10(frame.digits[0]))));
    frame.line = (float)((double)frame.tick / (quarters ? 4.0 : 5.0));
    return frame;
}

// Extend a range to include the distances of the steps between two positions on the ray.
static void extend(double range[2], const struct probe *probe, double left, double right)
{
    for (int i = 0; i < probe_rows(probe); i++) {
        double t = (double)probe->step[i].t, distance = (double)probe->step[i].distance;
        if (!(t >= left && t <= right && fabs(distance) < 1e9))
            continue;
        range[0] = fmin(range[0], distance);
        range[1] = fmax(range[1], distance);
    }
}

struct plot_frame plot_frame_of(const struct probe *probe, int count, int width, int height,
                                struct slice_frame *slice)
{
    double unit = (double)slice->unit, left = (double)slice->left, range[2] = {0.0, 0.0};
    double cell = (double)slice_cell(height), split = floor((double)SLICE_PLOT * height + 0.5);
    slice->bottom = (float)(-(split + 0.5 * (height - split)) * unit);
    for (int i = 0; i < count; i++)
        extend(range, &probe[i], left, left + width * unit);
    if (!(range[1] - range[0] > 0.0))
        range[1] = 1.0;
    double low = (double)SLICE_AXIS + PLOT_BELOW;
    double scale = (range[1] - range[0]) / fmax(split - (low + PLOT_ABOVE) * cell, 1.0);
    struct plot_frame frame = {.split = (float)split, .unit = (float)scale};
    frame.zero = (float)(low * cell - range[0] / scale);
    round_tick((range[1] - range[0]) / PLOT_TICKS, &frame.tick, frame.digits);
    return frame;
}
