// noise.c - shaders/noise.glsl in double precision, written from the definitions in its comments.
#include "lib/noise.h"

double noise_fade(double x)
{
    return x * x * x * (x * (6.0 * x - 15.0) + 10.0);
}

double noise_slope(double x)
{
    return 30.0 * x * x * (1.0 - x) * (1.0 - x);
}

uint32_t noise_bits(int32_t x, int32_t y, int32_t z)
{
    uint32_t v = (uint32_t)x * 0x8da6b343u + (uint32_t)y * 0xd8163841u + (uint32_t)z * 0xcb1ab31fu;
    v = (v ^ (v >> 16)) * 0x7feb352du;
    v = (v ^ (v >> 15)) * 0x846ca68bu;
    return v ^ (v >> 16);
}

// The shares of the low and the high side along each axis, and their slopes, from which the weights
// of the eight corners are computed.
struct sides {
    double share[3][2], slope[3][2];
};

static struct sides sides_at(struct d3 x)
{
    double at[3] = {x.x, x.y, x.z};
    struct sides sides;
    for (int i = 0; i < 3; i++) {
        sides.share[i][1] = noise_fade(at[i]);
        sides.share[i][0] = 1.0 - sides.share[i][1];
        sides.slope[i][1] = noise_slope(at[i]);
        sides.slope[i][0] = -sides.slope[i][1];
    }
    return sides;
}

// The weight of a corner, and the weight's gradient.
static struct noise weight(const struct sides *sides, int corner)
{
    int x = corner & 1, y = corner >> 1 & 1, z = corner >> 2;
    double a = sides->share[0][x], b = sides->share[1][y], c = sides->share[2][z];
    return (struct noise){a * b * c, d3(sides->slope[0][x] * b * c, a * sides->slope[1][y] * c,
                                        a * b * sides->slope[2][z])};
}

struct noise noise_blend(struct d3 x, const double number[8])
{
    struct noise sum = {0.0, {0.0, 0.0, 0.0}};
    struct sides sides = sides_at(x);
    for (int k = 0; k < 8; k++) {
        struct noise w = weight(&sides, k);
        sum.value += number[k] * w.value;
        sum.gradient = d3_add(sum.gradient, d3_times(number[k], w.gradient));
    }
    return sum;
}

struct noise noise_slopes(struct d3 x, const struct d3 direction[8])
{
    struct noise sum = {0.0, {0.0, 0.0, 0.0}};
    struct sides sides = sides_at(x);
    for (int k = 0; k < 8; k++) {
        struct noise w = weight(&sides, k);
        struct d3 away = d3_sub(x, d3(k & 1, k >> 1 & 1, k >> 2));
        double height = d3_dot(direction[k], away);
        sum.value += w.value * height;
        sum.gradient = d3_add(
            sum.gradient, d3_add(d3_times(w.value, direction[k]), d3_times(height, w.gradient)));
    }
    return sum;
}

static uint32_t corner_bits(struct d3 low, int corner)
{
    return noise_bits((int32_t)low.x + (corner & 1), (int32_t)low.y + (corner >> 1 & 1),
                      (int32_t)low.z + (corner >> 2));
}

static struct d3 floor_of(struct d3 p)
{
    return d3(floor(p.x), floor(p.y), floor(p.z));
}

struct noise noise_value(struct d3 p)
{
    struct d3 low = floor_of(p);
    double number[8];
    for (int k = 0; k < 8; k++)
        number[k] = (corner_bits(low, k) >> 8) / 16777216.0;
    return noise_blend(d3_sub(p, low), number);
}

struct noise noise_gradient(struct d3 p)
{
    struct d3 low = floor_of(p), direction[8];
    for (int k = 0; k < 8; k++) {
        uint32_t bits = corner_bits(low, k);
        direction[k] = d3_unit(d3(2.0 * (bits & 1023) - 1023.0, 2.0 * (bits >> 10 & 1023) - 1023.0,
                                  2.0 * (bits >> 20 & 1023) - 1023.0));
    }
    return noise_slopes(d3_sub(p, low), direction);
}

struct noise noise_octaves(struct d3 p, int count, double gain, double lacunarity)
{
    struct noise sum = {0.0, {0.0, 0.0, 0.0}};
    double weight = 1.0, scale = 1.0;
    for (int i = 0; i < count; i++) {
        struct noise octave = noise_value(p);
        sum.value += weight * octave.value;
        sum.gradient = d3_add(sum.gradient, d3_times(weight * scale, octave.gradient));
        p = d3_add(d3_times(lacunarity, p), d3(17.17, 5.31, 29.73));
        weight *= gain;
        scale *= lacunarity;
    }
    double all = noise_sum(gain, count);
    return (struct noise){sum.value / all, d3_times(1.0 / all, sum.gradient)};
}

double noise_sum(double ratio, int count)
{
    double sum = 0.0;
    for (int i = 0; i < count; i++)
        sum += pow(ratio, i);
    return sum;
}

double noise_octave_stretch(int count, double gain, double lacunarity)
{
    return 1.875 * noise_sum(gain * lacunarity, count) / noise_sum(gain, count);
}
