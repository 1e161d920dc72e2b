#include "lib/bounces.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lib/gpu.h"
#include "lib/test.h"
#include "picture/kept.h"
#include "picture/passes.h"

#define MOVING "chapters/experiments/24_reprojected.frag"

// ---- Frames and their errors ----

// Load the shader of a run with its parameters, and return the inputs of a frame.
static struct renderer_inputs open_run(const struct bounces_run *run, int frame)
{
    struct renderer_inputs inputs = gpu_inputs(run->width, run->height, 1);
    char settings[400], *rest = settings;
    snprintf(settings, sizeof settings, "%s", run->settings);
    gpu_open_shader(run->shader);
    for (char *word; (word = strtok_r(rest, " ", &rest)) != NULL;) {
        char *value = strchr(word, '=');
        assert_non_null(value);
        *value = '\0';
        gpu_set(word, atof(value + 1));
    }
    inputs.camera = gpu_camera("24_bounces");
    inputs.camera.position[0] += (float)run->right;
    inputs.rate = PASSES_RATE;
    inputs.frame = frame;
    inputs.time = frame / PASSES_RATE;
    return inputs;
}

float *bounces_kept(const struct bounces_run *run, int frames)
{
    struct renderer_inputs inputs = open_run(run, frames - 1);
    float *light = malloc(4 * sizeof *light * (size_t)run->width * (size_t)run->height);
    assert_non_null(light);
    assert_true(passes_follow(&gpu.renderer, &inputs));
    target_read(kept_frame(&gpu.renderer.kept, frames - 1), gpu.renderer.gl, light);
    return light;
}

float *bounces_shown(const struct bounces_run *run, int frames)
{
    struct renderer_inputs inputs = open_run(run, frames - 1);
    return gpu_numbers(&inputs);
}

double bounces_mean(const float *light, const struct bounces_run *run, int channel)
{
    int pixels = run->width * run->height;
    double sum = 0.0;
    for (int i = 0; i < 4 * pixels; i++)
        if (channel == 3 ? i % 4 != 3 : i % 4 == channel)
            sum += (double)light[i];
    return sum / pixels / (channel == 3 ? 3.0 : 1.0);
}

double bounces_apart(const float *a, const float *b, const struct bounces_run *run)
{
    int pixels = run->width * run->height;
    double squares = 0.0;
    for (int i = 0; i < 4 * pixels; i++)
        if (i % 4 != 3)
            squares += ((double)a[i] - (double)b[i]) * ((double)a[i] - (double)b[i]);
    return sqrt(squares / (3.0 * pixels));
}

double bounces_blocks_apart(const float *a, const float *b, const struct bounces_run *run)
{
    double squares = 0.0;
    int count = 0;
    for (int y = 0; y + 8 <= run->height; y += 8)
        for (int x = 0; x + 8 <= run->width; x += 8)
            for (int k = 0; k < 3; k++, count++) {
                double sum = 0.0;
                for (int i = 0; i < 64; i++) {
                    int at = 4 * ((y + i / 8) * run->width + x + i % 8) + k;
                    sum += (double)a[at] - (double)b[at];
                }
                squares += sum * sum / (64.0 * 64.0);
            }
    return sqrt(squares / count);
}

double bounces_noise(const struct bounces_run *run, int frames)
{
    struct bounces_run other = *run;
    char settings[400];
    snprintf(settings, sizeof settings, "%s seed=77", run->settings);
    other.settings = settings;
    float *a = bounces_kept(run, frames), *b = bounces_kept(&other, frames);
    double apart = bounces_apart(a, b, run);
    free(a);
    free(b);
    return apart / sqrt(2.0);
}

double bounces_slope(int count, const double *x, const double *y)
{
    double sx = 0.0, sy = 0.0, xx = 0.0, xy = 0.0;
    for (int i = 0; i < count; i++) {
        double a = log(x[i]), b = log(y[i]);
        sx += a;
        sy += b;
        xx += a * a;
        xy += a * b;
    }
    return (count * xy - sx * sy) / (count * xx - sx * sx);
}

// ---- build/tests/measure bounces ----

enum { WIDE = 96, HIGH = 54 };

static struct bounces_run small(const char *shader, const char *settings)
{
    return (struct bounces_run){shader, settings, WIDE, HIGH, 0.0};
}

// Print the mean light of estimators with the same expectation, and of some that are biased.
static void print_means(void)
{
    static const struct {
        const char *name, *shader, *settings;
    } rows[] = {
        {"both weighted", BOUNCES_CHAPTER, ""},
        {"paths that leave", BOUNCES_CHAPTER, "lights=0"},
        {"rays to the window", BOUNCES_CHAPTER, "lights=1"},
        {"no roulette", BOUNCES_CHAPTER, "roulette=0"},
        {"with the patch", "chapters/solutions/24_bounces_4.frag", ""},
        {"a path is missed", "chapters/experiments/24_patch.frag", ""},
        {"clamped at 8", BOUNCES_CHAPTER, "clampAt=8"},
        {"clamped at 4", BOUNCES_CHAPTER, "clampAt=4"},
        {"clamped at 2", BOUNCES_CHAPTER, "clampAt=2"},
        {"clamped at 1", BOUNCES_CHAPTER, "clampAt=1"},
    };
    enum { FRAMES = 1024 };
    double first[4] = {1.0, 1.0, 1.0, 1.0};
    puts("# mean light of 1024 frames: red, green, blue, and differences from the first row\n"
         "estimator,red,green,blue,red,green,blue,all,error at 64 frames");
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct bounces_run run = small(rows[i].shader, rows[i].settings);
        float *light = bounces_kept(&run, FRAMES);
        printf("%s", rows[i].name);
        for (int k = 0; k < 3; k++)
            printf(",%.5f", bounces_mean(light, &run, k));
        for (int k = 0; k < 4; k++) {
            double mean = bounces_mean(light, &run, k);
            first[k] = i == 0 ? mean : first[k];
            printf(",%+.2f %%", 100.0 * (mean / first[k] - 1.0));
        }
        free(light);
        printf(",%.4f\n", bounces_noise(&run, 64));
        fflush(stdout);
    }
}

// Print the error of the mean against the number of frames.
static void print_noise(void)
{
    static const struct {
        const char *name, *settings;
        int steps;
    } rows[] = {
        {"hash", "sequence=0", 6},
        {"one good pair", "sequence=1", 6},
        {"Sobol pairs", "sequence=2", 6},
        {"hash, no bounce", "sequence=0 bounces=0", 5},
        {"Sobol pairs, no bounce", "sequence=2 bounces=0", 5},
    };
    puts("# error of the mean light, root mean square over pixels and channels\n"
         "random numbers,1,4,16,64,256,1024,slope");
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct bounces_run run = small(BOUNCES_CHAPTER, rows[i].settings);
        double frames[6], error[6];
        printf("%s", rows[i].name);
        for (int k = 0; k < rows[i].steps; k++) {
            frames[k] = pow(4.0, k);
            error[k] = bounces_noise(&run, (int)frames[k]);
            printf(",%.4f", error[k]);
            fflush(stdout);
        }
        printf("%s,%.3f\n", rows[i].steps < 6 ? "," : "",
               bounces_slope(rows[i].steps, frames, error));
    }
}

// Print the light that each further bounce adds. A path with fewer bounces is the beginning of the
// same path.
static void print_series(void)
{
    static const int counts[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 12, 16, 32};
    double before[3] = {0.0};
    puts("# mean light after so many bounces, 256 frames, and what the last of them added\n"
         "bounces,red,green,blue,red,green,blue");
    for (size_t i = 0; i < sizeof counts / sizeof *counts; i++) {
        char settings[60];
        snprintf(settings, sizeof settings, "roulette=0 bounces=%d", counts[i]);
        struct bounces_run run = small(BOUNCES_CHAPTER, settings);
        float *light = bounces_kept(&run, 256);
        printf("%d", counts[i]);
        for (int k = 0; k < 3; k++)
            printf(",%.4f", bounces_mean(light, &run, k));
        for (int k = 0; k < 3; k++) {
            double mean = bounces_mean(light, &run, k);
            printf(",%.4f", mean - before[k]);
            before[k] = mean;
        }
        printf("\n");
        fflush(stdout);
        free(light);
    }
}

// Print how much of the light in a pixel comes straight from the sun or the window.
static void print_direct(void)
{
    struct bounces_run all = small(BOUNCES_CHAPTER, ""),
                       direct = small(BOUNCES_CHAPTER, "bounces=0");
    float *light = bounces_kept(&all, 1024), *first = bounces_kept(&direct, 1024);
    int half = 0, quarter = 0;
    for (int i = 0; i < WIDE * HIGH; i++) {
        double a = 0.0, b = 0.0;
        for (int k = 0; k < 3; k++) {
            a += (double)light[4 * i + k];
            b += (double)first[4 * i + k];
        }
        half += b < 0.5 * a;
        quarter += b < 0.25 * a;
    }
    printf("# less than half of the light is direct in %.0f %% of the pixels, less than a quarter "
           "in %.0f %%\n",
           100.0 * half / (WIDE * HIGH), 100.0 * quarter / (WIDE * HIGH));
    free(light);
    free(first);
}

int bounces_print(void)
{
    print_direct();
    print_means();
    print_series();
    print_noise();
    return 0;
}

// ---- build/tests/measure quiet ----

static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// The median difference of two pictures, over pixels and channels.
static double median_apart(const float *a, const float *b, const struct bounces_run *run)
{
    int count = 3 * run->width * run->height;
    double *off = malloc(sizeof *off * (size_t)count);
    assert_non_null(off);
    for (int i = 0; i < count; i++)
        off[i] = fabs((double)a[i / 3 * 4 + i % 3] - (double)b[i / 3 * 4 + i % 3]);
    qsort(off, (size_t)count, sizeof *off, by_size);
    double median = off[count / 2];
    free(off);
    return median;
}

// Print how far pictures are from a reference, 255 being the difference of black and white.
static void print_pictures(const float *reference, int count, const struct bounces_run *runs,
                           const int *frames, const char *const *names)
{
    puts("picture,error,median,8x8 blocks,mean");
    for (int i = 0; i < count; i++) {
        float *shown = bounces_shown(&runs[i], frames[i]);
        printf("%s,%.1f,%.1f,%.1f,%+.1f %%\n", names[i],
               255.0 * bounces_apart(shown, reference, &runs[i]),
               255.0 * median_apart(shown, reference, &runs[i]),
               255.0 * bounces_blocks_apart(shown, reference, &runs[i]),
               100.0 *
                   (bounces_mean(shown, &runs[i], 3) / bounces_mean(reference, &runs[i], 3) - 1.0));
        fflush(stdout);
        free(shown);
    }
}

// The experiment with a moving eye, at rest, is the chapter without jitter in a pixel: the filter
// is judged with sharp edges.
#define AT_REST "speed=0 keeping=1 most=1024 "

static void print_filters(void)
{
    enum { W = 320, H = 180 };
    static const struct bounces_run runs[] = {
        {MOVING, AT_REST, W, H, 0.0},
        {"chapters/experiments/24_median.frag", "", W, H, 0.0},
        {"chapters/experiments/24_everything.frag", "filterPasses=4", W, H, 0.0},
        {BOUNCES_CHAPTER, "filterPasses=1", W, H, 0.0},
        {BOUNCES_CHAPTER, "filterPasses=2", W, H, 0.0},
        {BOUNCES_CHAPTER, "filterPasses=3", W, H, 0.0},
        {BOUNCES_CHAPTER, "filterPasses=4", W, H, 0.0},
        {BOUNCES_CHAPTER, "filterPasses=5", W, H, 0.0},
        {MOVING, AT_REST, W, H, 0.0},
        {MOVING, AT_REST, W, H, 0.0},
        {MOVING, AT_REST, W, H, 0.0},
    };
    static const int frames[] = {16, 16, 20, 17, 18, 19, 20, 21, 64, 256, 1024};
    static const char *const names[] = {
        "16 frames",        "median",           "filter over everything, 4 passes",
        "filter, 1 pass",   "filter, 2 passes", "filter, 3 passes",
        "filter, 4 passes", "filter, 5 passes", "64 frames",
        "256 frames",       "1024 frames"};
    const struct bounces_run truth = {MOVING, AT_REST "seed=9", W, H, 0.0};
    puts("# 16 frames, filtered, and more frames, against 1024 other frames");
    float *reference = bounces_shown(&truth, 1024);
    print_pictures(reference, 11, runs, frames, names);
    free(reference);
}

// Print what may be kept while the eye moves by 0.3 in a second: frame 63 against the same view of
// an eye at rest.
static void print_moving(void)
{
    enum { W = 160, H = 90, LAST = 63 };
    static const struct bounces_run runs[] = {{MOVING, "keeping=0", W, H, 0.0},
                                              {MOVING, "keeping=1", W, H, 0.0},
                                              {MOVING, "keeping=2", W, H, 0.0},
                                              {MOVING, "keeping=2 most=1024", W, H, 0.0},
                                              {MOVING, AT_REST, W, H, 0.3 * LAST / PASSES_RATE}};
    static const int frames[] = {LAST + 1, LAST + 1, LAST + 1, LAST + 1, 32};
    static const char *const names[] = {"nothing", "the pixel's", "the point's, at most 32",
                                        "the point's, all", "at rest, 32 frames"};
    const struct bounces_run truth = {MOVING, AT_REST "seed=9", W, H, 0.3 * LAST / PASSES_RATE};
    puts("# what is kept of the last frame while the eye moves, after 64 frames");
    float *reference = bounces_shown(&truth, 1024);
    print_pictures(reference, 5, runs, frames, names);
    free(reference);
}

int bounces_print_quiet(void)
{
    print_moving();
    print_filters();
    return 0;
}
