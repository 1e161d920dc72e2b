#include "weave.h"

#include <math.h>

#include "paint.h"

// One of the threads at a point.
//   along, across  the point, across in threads
//   sign           1 for the warp, -1 for the weft: where the one is up the other is down
static struct weave thread_at(double along, double across, bool warp)
{
    uint32_t seed = warp ? 1 : 2;
    // No thread is straight.
    across += 0.5 * (paint_octaves(along, across / WEAVE_THREADS, 6, WEAVE_THREADS, 2, seed) - 0.5);
    int thread = ((int)floor(across) + WEAVE_THREADS) % WEAVE_THREADS;
    double thick =
        paint_octaves(along, (thread + 0.5) / WEAVE_THREADS, 7, WEAVE_THREADS, 3, seed + 10);
    double radius = 0.40 + 0.22 * (thick - 0.5) + 0.06 * paint_random(thread, 0, seed + 20);
    double from = (across - floor(across) - 0.5) / radius;
    // Up at every second crossing, with a smooth way between.
    double crossing = along * WEAVE_THREADS - 0.5, s = crossing - floor(crossing);
    double up = ((int)floor(crossing) + thread + (warp ? 0 : 1)) % 2 == 0 ? 1.0 : -1.0;
    up *= 1.0 - 2.0 * paint_step(0.0, 1.0, s);
    double round = sqrt(fmax(1.0 - from * from, 0.0));
    return (struct weave){.height = 0.5 + 0.22 * up + 0.28 * (round * 2.0 * radius - 0.1),
                          .warp = warp,
                          .thread = thread,
                          .along = along,
                          .across = from,
                          .covered = fabs(from) < 1.0};
}

struct weave weave_at(double u, double v)
{
    struct weave warp = thread_at(v, u * WEAVE_THREADS, true);
    struct weave weft = thread_at(u, v * WEAVE_THREADS, false);
    struct weave none = {.height = 0.0, .covered = false};
    struct weave top = warp.covered && (!weft.covered || warp.height > weft.height) ? warp : weft;
    return top.covered ? top : none;
}
