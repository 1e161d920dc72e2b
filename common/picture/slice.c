#include "picture/slice.h"

#include <math.h>

#define BEHIND     0.10  // of the length shown, left of the eye
#define BEYOND     0.35  // of it, right of a hit
#define NOTHING    8.0   // scene units shown of a ray that was not marched
#define TICK_SHARE 0.115 // of the picture's width: at least so far from tick to tick
#define CELLS      180   // in the picture's height

float slice_cell(int height)
{
    return fmaxf(1.0f, floorf((float)height / CELLS));
}

// The step where the scene was nearest: of a hit the last.
static const struct probe_step *nearest_step(const struct probe *probe, int steps)
{
    const struct probe_step *nearest = &probe->step[0];
    for (int i = 1; i < steps; i++)
        if (probe->step[i].distance < nearest->distance)
            nearest = &probe->step[i];
    return nearest;
}

void slice_round_tick(double length, float *tick, int digits[2])
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
        // A ray that only leaves is shown whole: a shadow ray, or one into the sky.
        if (probe->end == PROBE_PASSED && nearest == &probe->step[0])
            end = 1.05 * last;
        else if (probe->end == PROBE_PASSED)
            end = fmin(last, 1.5 * centre + 2.0 * fabs((double)nearest->distance));
        else
            end = last * (1.0 + BEYOND);
    }
    if (!(fabs(centre) < 1e9)) // a broken distance
        centre = 0.0;
    if (!(end > 0.0 && end < 1e9)) // or a march that starts at the surface
        end = fmax(centre, 1.0);
    double times = zoom > 0.0f ? (double)zoom : 1.0;
    double left = -BEHIND * end;
    double shown = (1.0 + BEHIND) * end;
    left = centre + (left - centre) / times;
    shown /= times;
    struct slice_frame frame = {.left = (float)left, .unit = (float)(shown / width)};
    frame.bottom = -0.5f * (float)height * frame.unit;
    slice_round_tick(TICK_SHARE * shown, &frame.tick, frame.digits);
    // 1 and 10 are parted in fifths, 2 in fourths.
    bool fourths = frame.digits[0] == 2 * (int)lround(pow(10.0, floor(log10(frame.digits[0]))));
    frame.line = (float)((double)frame.tick / (fourths ? 4.0 : 5.0));
    return frame;
}
