#include "lib/random.h"

#include <stdint.h>
#include <stdlib.h>

double random_of(int x, int y, int sample, int dimension)
{
    const int key[4] = {x, y, sample, dimension};
    uint32_t v[4];
    for (int i = 0; i < 4; i++)
        v[i] = (uint32_t)key[i] * 1664525u + 1013904223u;
    for (int round = 0; round < 2; round++) {
        v[0] += v[1] * v[3];
        v[1] += v[2] * v[0];
        v[2] += v[0] * v[1];
        v[3] += v[1] * v[2];
        for (int i = 0; i < 4 && round == 0; i++)
            v[i] ^= v[i] >> 16;
    }
    return (double)(v[0] >> 8) / 16777216.0;
}

double random_in(double low, double high)
{
    return low + (high - low) * rand() / RAND_MAX;
}

struct d3 random_point(double low, double high)
{
    double x = random_in(low, high), y = random_in(low, high);
    return d3(x, y, random_in(low, high));
}

struct d3 random_direction(void)
{
    struct d3 v = random_point(-1.0, 1.0);
    while (d3_length(v) > 1.0 || d3_length(v) < 0.01)
        v = random_point(-1.0, 1.0);
    return d3_unit(v);
}
