#include "picture/slice.h"

#include <math.h>

#define BEHIND     0.10  // of the length shown, left of the eye
#define BEYOND     0.35  // of it, right of a hit
#define NOTHING    8.0   // scene units shown of a ray that was not marched
#define TICK_SHARE 0.115 // of the picture's width: at least so far from tick to tick

// The step where the scene was nearest: of a hit the last.
static const struct probe_step *nearest_step(const struct probe *probe, int steps)
{
    const struct probe_step *nearest = &probe->step[0];
    for (int i = 1; i < steps; i++)
        if (probe->step[i].distance < nearest->distance)
            nearest = &probe->step[i];
    return nearest;
}

// The least of 1, 2 or 5 times a power of ten that is not less than a length.
static void round_tick(struct slice_frame *frame, double length)
{
    int power = (int)floor(log10(length));
    double share = length / pow(10.0, power);
    int first = share <= 1.0 ? 1 : share <= 2.0 ? 2 : share <= 5.0 ? 5 : 10;
    if (first == 10) {
        first = 1;
        power++;
    }
    double tick = first * pow(10.0, power);
    frame->tick = (float)tick;
    frame->line = (float)(tick / (first == 2 ? 4.0 : 5.0));
    frame->digits[0] = power < 0 ? first : (int)lround(tick);
    frame->digits[1] = power < 0 ? -power : 0;
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
    round_tick(&frame, TICK_SHARE * shown);
    return frame;
}
