#include "weave.h"

#include <math.h>

#include "paint.h"

// The thread of one direction at a point.
//   along   position along the thread, 0 to 1
//   across  position across all threads of this direction, 0 to 1
static struct weave thread_at(double along, double across, bool warp)
{
    uint32_t seed = warp ? 1 : 2;
    // No thread is straight.
    double bend = paint_octaves(along, across, 9, WEAVE_THREADS / 4, 2, seed) - 0.5;
    double position = across * WEAVE_THREADS + 0.8 * bend, middle = floor(position) + 0.5;
    int thread = ((int)floor(position) + WEAVE_THREADS) % WEAVE_THREADS;
    // The thickness of a thread is not constant either: flax has thick spots.
    double thick =
        paint_octaves(along, (thread + 0.5) / WEAVE_THREADS, 10, WEAVE_THREADS, 2, seed + 10);
    double radius =
        0.38 + 0.12 * paint_random(thread, 0, seed + 20) + 0.30 * paint_step(0.5, 0.95, thick);
    double from = (position - middle) / radius;
    // The thread is on top at every second crossing, with a smooth transition down and up between
    // the crossings.
    double crossing = along * WEAVE_THREADS - 0.5, way = crossing - floor(crossing);
    bool from_above = ((int)floor(crossing) + thread + (warp ? 0 : 1)) % 2 == 0;
    double up = paint_step(0.0, 1.0, from_above ? 1.0 - way : way);
    double round = fmax(1.0 - from * from, 0.0);
    return (struct weave){.height = 0.42 * up + 0.58 * round * fmin(2.0 * radius, 1.0),
                          .warp = warp,
                          .thread = thread,
                          .along = along,
                          .across = from,
                          .covered = fabs(from) < 1.0};
}

struct weave weave_at(double u, double v)
{
    u -= floor(u);
    v -= floor(v);
    struct weave warp = thread_at(v, u, true), weft = thread_at(u, v, false);
    bool upper = warp.covered && (!weft.covered || warp.height > weft.height);
    struct weave top = upper ? warp : weft;
    if (!top.covered)
        top.height = 0.0;
    return top;
}
