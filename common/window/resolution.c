#include "window/resolution.h"

#include <math.h>

double resolution_divisor(int level)
{
    return exp2(0.25 * level);
}

int resolution_side(int level, int side)
{
    return (int)ceil(side / resolution_divisor(level));
}

void resolution_guess(struct resolution *resolution, double cost)
{
    for (int i = 0; i < 3; i++)
        resolution->cost[i] = cost;
    resolution->guessed = true;
}

void resolution_learn(struct resolution *resolution, double cost)
{
    if (resolution->guessed)
        resolution_guess(resolution, cost);
    resolution->guessed = false;
    resolution->cost[2] = resolution->cost[1];
    resolution->cost[1] = resolution->cost[0];
    resolution->cost[0] = cost;
}

double resolution_cost(const struct resolution *resolution)
{
    const double *cost = resolution->cost;
    double low = fmin(cost[0], cost[1]), high = fmax(cost[0], cost[1]);
    return fmax(low, fmin(high, cost[2]));
}

// What a frame of a level is foretold to take.
static double foretold(const struct resolution *resolution, int level, double pixels, double beside)
{
    return resolution_cost(resolution) * pixels / exp2(0.5 * level) + (level > 0 ? beside : 0.0);
}

int resolution_choose(struct resolution *resolution, double pixels, double beside)
{
    int level = resolution->level;
    while (level < RESOLUTION_COARSEST &&
           foretold(resolution, level, pixels, beside) > RESOLUTION_SLOW)
        level++;
    while (level > 0 && foretold(resolution, level - 1, pixels, beside) < RESOLUTION_QUICK)
        level--;
    resolution->level = level;
    return level;
}
