#include "lib/paths.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lib/gpu.h"

// 64 paths for each pixel.
enum { WIDE = 160, HIGH = 90, PIXELS = WIDE * HIGH, SIDE = 8 };

// The mean over the samples of each pixel. The caller frees the result.
static float *means(const char *stem, int what)
{
    struct renderer_inputs inputs = gpu_inputs(WIDE, HIGH, SIDE);
    inputs.camera = gpu_camera(stem);
    gpu_set("what", what);
    return gpu_numbers(&inputs);
}

// Add a pixel's light.
static void add(struct paths_light *light, int *count, const float *paths, const float *estimate,
                double scale)
{
    (*count)++;
    for (int k = 0; k < 3; k++) {
        light->paths[k] += scale * (double)paths[k];
        light->estimate[k] += scale * (double)estimate[k];
        light->apart += scale * fabs((double)(estimate[k] - paths[k])) / 3.0;
    }
}

static void divide(struct paths_light *light, int count)
{
    for (int k = 0; k < 3; k++) {
        light->paths[k] /= count;
        light->estimate[k] /= count;
    }
    light->apart /= count;
}

// Compare two kinds of light in chapter 13.
static void compare(struct paths_light *light, int kind, int estimated)
{
    const char *stem = "13_soft_shadows";
    int count = 0;
    float *paths = means(stem, kind), *estimate = means(stem, estimated), *sky = means(stem, 2);
    *light = (struct paths_light){0};
    for (int i = 0; i < 4 * PIXELS; i += 4)
        if (sky[i] <= 0.0f)
            add(light, &count, paths + i, estimate + i, 8.0);
    divide(light, count);
    free(paths);
    free(estimate);
    free(sky);
}

void paths_terrace(struct paths_light *light)
{
    gpu_open_shader("tests/shaders/terrace_light.frag");
    compare(light, 0, 1);
}

void paths_sun(int method, struct paths_light *light)
{
    gpu_open_shader("tests/shaders/terrace_light.frag");
    gpu_set("shadow", method);
    gpu_set("rays", 2); // in each of the 64 samples of a pixel
    compare(light, 3, 4);
}

void paths_court(enum paths_openness openness, struct paths_light *all, struct paths_light *dark)
{
    static const float near[3] = {0.66f, 0.56f, 0.46f}; // NEAR of the chapter
    const char *stem = "14_occlusion";
    int count = 0, few = 0;
    gpu_open_shader("tests/shaders/court_light.frag");
    float *paths = means(stem, 0), *series = means(stem, 1), *open = means(stem, 2);
    *all = *dark = (struct paths_light){0};
    for (int i = 0; i < 4 * PIXELS; i += 4) {
        if (open[i] > 0.0f)
            continue;
        // The series of the mean openness; the mean of the series of each sample would be smaller.
        for (int k = 0; k < 3 && openness == PATHS_TRUE_OPENNESS; k++)
            series[i + k] =
                0.5f * open[i + 1] / fmaxf(1.0f - near[k] * (1.0f - open[i + 1]), 1e-6f);
        add(all, &count, paths + i, series + i, 2.0);
        if (open[i + 1] < 0.05f)
            add(dark, &few, paths + i, series + i, 2.0);
    }
    divide(all, count);
    divide(dark, few);
    free(paths);
    free(series);
    free(open);
}

static void print(const char *name, const struct paths_light *light)
{
    printf("%s", name);
    for (int k = 0; k < 3; k++)
        printf(",%.3f", light->paths[k]);
    for (int k = 0; k < 3; k++)
        printf(",%.3f", light->estimate[k]);
    for (int k = 0; k < 3; k++)
        printf(",%+.1f %%", 100.0 * (light->estimate[k] / light->paths[k] - 1.0));
    printf(",%.3f\n", light->apart);
    fflush(stdout);
}

int paths_print(void)
{
    static const char *const formulas[] = {"14: series with the taps",
                                           "14: series with the true openness"};
    struct paths_light light, dark;
    puts("# the mean light of paths and of a chapter's estimate; difference; mean absolute "
         "difference\n"
         "estimate,paths red,green,blue,estimate red,green,blue,red,green,blue,apart");
    paths_terrace(&light);
    print("13: ambient light", &light);
    for (int method = 0; method < 4; method++) {
        char name[40];
        paths_sun(method, &light);
        snprintf(name, sizeof name, "13: the sun with shadow=%d", method);
        print(name, &light);
    }
    for (int formula = 0; formula < 2; formula++) {
        char name[80];
        paths_court((enum paths_openness)formula, &light, &dark);
        print(formulas[formula], &light);
        snprintf(name, sizeof name, "%s; openness below 0.05", formulas[formula]);
        print(name, &dark);
    }
    return 0;
}
