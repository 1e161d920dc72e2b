// cell.h - cellRandom of shaders/repetition.glsl in C.
#ifndef TESTS_CELL_H
#define TESTS_CELL_H

#include <stdint.h>

// The random number of a cell, in [0, 1), equal to the shader's to the last bit.
static inline double cell_hash(int x, int y, int z)
{
    uint32_t v[3] = {(uint32_t)x, (uint32_t)y, (uint32_t)z};
    for (int i = 0; i < 3; i++)
        v[i] = v[i] * 1664525u + 1013904223u;
    for (int round = 0; round < 2; round++) {
        uint32_t product[3] = {v[1] * v[2], v[2] * v[0], v[0] * v[1]};
        for (int i = 0; i < 3; i++)
            v[i] += product[i];
        for (int i = 0; i < 3 && round == 0; i++)
            v[i] ^= v[i] >> 16;
    }
    return (double)(v[0] >> 8) / 16777216.0;
}

#endif
