#include "support_random.h"

#include <stdint.h>

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
