#include "lib/cover.h"

#include <math.h>

static double empty(const struct cover_sample *sample)
{
    return fmax(sample->d, 0.0);
}

// The smallest number of intervals (t_i - d_i, t_j + d_j), with j = i + gap, that cover the ray
// from the first sample to goal: always take the interval that reaches farthest among those that
// begin in the part covered so far. Returns COVER_NEVER if the intervals do not reach goal.
static int fewest(const struct cover_sample *sample, int count, int gap, double goal)
{
    double covered = sample[0].t;
    int taken = 0;
    while (covered < goal) {
        double reach = covered;
        for (int i = 0; i + gap < count; i++)
            if (sample[i].t - empty(&sample[i]) <= covered)
                reach = fmax(reach, sample[i + gap].t + empty(&sample[i + gap]));
        if (reach <= covered)
            return COVER_NEVER;
        covered = reach;
        taken++;
    }
    return taken;
}

struct cover_count cover_of(const struct cover_sample *sample, int count, bool hit)
{
    const struct cover_sample *end = &sample[count - 1];
    double goal = hit ? end->t - empty(end) : end->t;
    int least = fewest(sample, count, count > 1 ? 1 : 0, goal);
    int most = fewest(sample, count, 0, goal), last = hit ? 1 : 0;
    return (struct cover_count){.least = least == COVER_NEVER ? least : least + last,
                                .most = most == COVER_NEVER ? most : most + last};
}

// ---- A plane ----

int cover_plane_march(double height, double slope, double far, double threshold, bool *hit)
{
    double t = 0.0;
    int steps = 0;
    *hit = false;
    while (!*hit && t < far) {
        double d = height - slope * t;
        steps++;
        *hit = d < threshold;
        t += *hit ? 0.0 : d;
    }
    return steps;
}

// Let c be the end of the covered part and e the distance there. The distance at t is then
// d = e - slope (t - c). The best position is where t - d = c: there d = e / (1 + slope), and at
// the next end of the covered part the distance is e (1 - slope) / (1 + slope).
int cover_plane_least(double height, double slope, double far, double threshold)
{
    bool hit;
    int steps = cover_plane_march(height, slope, far, threshold, &hit);
    double rate = (1.0 - slope) / (1.0 + slope);
    double end = hit ? height * pow(1.0 - slope, steps - 1) : height - slope * far;
    // For a hit, the goal is the beginning of the interval of the hit. The distance there is
    // end (1 + slope).
    double goal = hit ? (1.0 + slope) * end : end;
    if (slope == 0.0)
        return (int)ceil(far / (2.0 * height));
    return (int)fmax(ceil(log(goal / height) / log(rate)), 0.0) + (hit ? 1 : 0);
}

double cover_plane_ratio(double slope)
{
    return slope == 0.0 ? 2.0 : (log1p(-slope) - log1p(slope)) / log1p(-slope);
}

// ---- A ball ----

int cover_ball_march(double gap, double reach)
{
    int steps = 0;
    for (double t = -reach; t < reach; steps++)
        t += hypot(t, 1.0 + gap) - 1.0;
    return steps;
}

// The equation t - (hypot(t, b) - 1) = c is solved for t: with k = 1 - c, b^2 = 2 k t + k^2. If c
// is at least 1, the interval of every point of the ray begins in the covered part, however far
// away the point is.
int cover_ball_least(double gap, double reach)
{
    double covered = -reach, b = 1.0 + gap;
    int count = 0;
    for (; covered < reach; count++) {
        double k = 1.0 - covered;
        double t = k > 0.0 ? fmin((b * b - k * k) / (2.0 * k), reach) : reach;
        covered = t + hypot(t, b) - 1.0;
    }
    return count;
}
