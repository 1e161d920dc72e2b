#include "window/resolution.h"

#include <math.h>

static double median(const double of[3])
{
    double low = fmin(of[0], of[1]), high = fmax(of[0], of[1]);
    return fmax(low, fmin(high, of[2]));
}

// Add the newest of three values and drop the oldest.
static void push(double to[3], double newest)
{
    to[2] = to[1];
    to[1] = to[0];
    to[0] = newest;
}

double resolution_divisor(int level)
{
    return exp2(0.25 * level);
}

int resolution_side(int level, int side)
{
    return (int)ceil(side / resolution_divisor(level));
}

void resolution_guess(struct resolution *resolution, double fixed, double cost)
{
    resolution->fixed = fixed;
    for (int i = 0; i < 3; i++)
        resolution->cost[i] = cost;
    resolution->guessed = true;
}

void resolution_learn(struct resolution *resolution, double seconds, double pixels)
{
    resolution->fixed = fmin(resolution->fixed, seconds); // a measurement may have been disturbed
    double cost = (seconds - resolution->fixed) / pixels;
    if (resolution->guessed)
        resolution_guess(resolution, resolution->fixed, cost);
    resolution->guessed = false;
    push(resolution->cost, cost);
}

double resolution_cost(const struct resolution *resolution)
{
    return median(resolution->cost);
}

void resolution_learn_enlarging(struct resolution *resolution, double seconds, double pixels)
{
    push(resolution->enlarging, seconds / pixels);
}

// Return the seconds that a frame at a level is predicted to take.
static double predicted(const struct resolution *resolution, int level, double pixels)
{
    double enlarge = level > 0 ? median(resolution->enlarging) : 0.0;
    return (resolution_cost(resolution) / exp2(0.5 * level) + enlarge) * pixels;
}

int resolution_choose(struct resolution *resolution, double pixels)
{
    int level = resolution->level;
    while (level < RESOLUTION_COARSEST && predicted(resolution, level, pixels) > RESOLUTION_SLOW)
        level++;
    while (level > 0 && predicted(resolution, level - 1, pixels) < RESOLUTION_QUICK)
        level--;
    resolution->level = level;
    return level;
}
