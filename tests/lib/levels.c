#include "lib/levels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "lib/compare.h"
#include "lib/mirror.h"

enum { SIDE = LEVELS_SIDE, POINTS = 32 };

// The linear light of granite.png, bottom row first.
static double light[SIDE][SIDE][3];

bool levels_open(void)
{
    struct image image = {0};
    char path[8192];
    snprintf(path, sizeof path, "%s/shaders/textures/granite.png", gpu.root);
    bool read = image_read_png(&image, path) && image.width == SIDE && image.height == SIDE;
    for (int i = 0; read && i < SIDE * SIDE * 3; i++) {
        double *texel = light[SIDE - 1 - i / (3 * SIDE)][i / 3 % SIDE];
        texel[i % 3] = mirror_decode(image.pixel[i] / 255.0);
    }
    image_free(&image);
    return read && gpu_load("tests/shaders/levels.frag");
}

float *levels_read(enum levels_reading reading, double x, double y, double factor, double sine)
{
    struct renderer_inputs inputs = {
        .width = POINTS, .height = POINTS, .time = reading, .samples = 1};
    double unit = reading == LEVELS_LEVEL ? 1.0 : 1.0 / SIDE;
    inputs.mouse[0] = (float)(x * unit);
    inputs.mouse[1] = (float)(y * unit);
    inputs.mouse[2] = (float)fmax(factor, 1e-6);
    inputs.mouse[3] = (float)sine;
    return gpu_numbers(&inputs);
}

// The length of the part of a texel that is between two positions on an axis.
static double overlap(int texel, double from, double to)
{
    return fmax(fmin(texel + 1.0, to) - fmax(texel, from), 0.0);
}

// The mean light over a rectangle around (x, y); all lengths are in texels.
static void mean_over(double x, double y, double width, double height, double mean[3])
{
    double left = x - 0.5 * width, low = y - 0.5 * height;
    mean[0] = mean[1] = mean[2] = 0.0;
    for (int j = (int)floor(low); j < low + height; j++)
        for (int i = (int)floor(left); i < left + width; i++) {
            double share = overlap(i, left, left + width) * overlap(j, low, low + height);
            const double *texel = light[(j + 8 * SIDE) % SIDE][(i + 8 * SIDE) % SIDE];
            for (int c = 0; c < 3; c++)
                mean[c] += share * texel[c] / (width * height);
        }
}

double levels_error(double width, double height, double factor, double sine)
{
    enum levels_reading reading = sine < 1.0 ? LEVELS_FLOOR : LEVELS_SIDES;
    float *values = levels_read(reading, width, height, factor, sine);
    double sum = 0.0;
    for (int k = 0; k < POINTS * POINTS; k++) {
        int i = k % POINTS, j = k / POINTS; // the same points as in the shader
        double mean[3];
        mean_over((167 * i + 59 * j) % SIDE + 0.375, (101 * i + 211 * j) % SIDE + 0.375, width,
                  height, mean);
        for (int c = 0; c < 3; c++) {
            double off = (double)values[4 * k + c] - mean[c];
            sum += off * off / (3.0 * POINTS * POINTS);
        }
    }
    free(values);
    return sqrt(sum);
}
