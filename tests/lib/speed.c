#include "lib/speed.h"

#include <stdio.h>
#include <string.h>

#include "picture/benchmark.h"
#include "platform.h"
#include "lib/gpu.h"

enum { FRAMES = 15, COLD_RUNS = 5 };

// A shader to measure: FILE, or FILE@X,Y,Z,PAN,TILT.
struct contender {
    char path[4096];
    struct renderer renderer;
    struct renderer_inputs inputs;
    double warm[FRAMES], cold[COLD_RUNS]; // seconds of process CPU time
};

static bool read_contender(struct contender *contender, const char *argument, int width, int height)
{
    struct camera *camera = &contender->inputs.camera;
    snprintf(contender->path, sizeof contender->path, "%s", argument);
    contender->inputs.width = width;
    contender->inputs.height = height;
    contender->inputs.samples = 1;
    contender->inputs.time = 1.0;
    char *at = strrchr(contender->path, '@');
    if (at == NULL)
        return true;
    *at = '\0';
    return sscanf(at + 1, "%f,%f,%f,%f,%f", &camera->position[0], &camera->position[1],
                  &camera->position[2], &camera->pan, &camera->tilt) == 5;
}

// The CPU time of all threads of the process, which excludes other programs on the machine.
static double cpu_seconds(void)
{
    return platform_processor_seconds();
}

static double frame_seconds(struct contender *contender, const struct gl *gl)
{
    double start = cpu_seconds();
    if (!renderer_draw(&contender->renderer, &contender->inputs, 0, contender->inputs.height))
        return -1.0;
    gl->Finish();
    return cpu_seconds() - start;
}

// Time compilation and the first frame in a new context.
static double cold_seconds(struct contender *contender, const char *root)
{
    struct context context = {0};
    double seconds = -1.0;
    if (context_open_offscreen(&context, CONTEXT_ANY) &&
        renderer_open(&contender->renderer, &context.gl, root)) {
        double start = cpu_seconds();
        if (gpu_load_file(&contender->renderer, contender->path) &&
            frame_seconds(contender, &context.gl) >= 0.0)
            seconds = cpu_seconds() - start;
    }
    renderer_close(&contender->renderer);
    context_close(&context);
    return seconds;
}

// Time frames of the two shaders in turn, so that anything that slows the machine slows both.
static bool measure_warm(struct contender pair[2])
{
    for (int k = 0; k < 2; k++)
        if (!renderer_open(&pair[k].renderer, &gpu.context.gl, gpu.root) ||
            !gpu_load_file(&pair[k].renderer, pair[k].path))
            return false;
    for (int i = -5; i < FRAMES; i++)
        for (int k = 0; k < 2; k++) {
            double seconds = frame_seconds(&pair[k], &gpu.context.gl);
            if (seconds < 0.0)
                return false;
            if (i >= 0)
                pair[k].warm[i] = seconds;
        }
    for (int k = 0; k < 2; k++)
        renderer_close(&pair[k].renderer);
    return true;
}

static bool measure_cold(struct contender pair[2], const char *root)
{
    for (int i = -1; i < COLD_RUNS; i++)
        for (int k = 0; k < 2; k++) {
            double seconds = cold_seconds(&pair[k], root);
            if (seconds < 0.0)
                return false;
            if (i >= 0)
                pair[k].cold[i] = seconds;
        }
    return true;
}

int speed_print(int argc, char **argv)
{
    static struct contender pair[2];
    int width = 640, height = 360;
    if (argc < 4 || (argc > 4 && sscanf(argv[4], "%dx%d", &width, &height) != 2) ||
        !read_contender(&pair[0], argv[2], width, height) ||
        !read_contender(&pair[1], argv[3], width, height)) {
        fputs("measure speed: expected two arguments FILE[@X,Y,Z,PAN,TILT], then WxH or nothing\n",
              stderr);
        return 2;
    }
    if (!measure_warm(pair) || !measure_cold(pair, gpu.root))
        return 1;
    printf("# process CPU time at %dx%d, with the time at 1 s: medians of %d frames and of %d cold "
           "starts\n",
           width, height, FRAMES, COLD_RUNS);
    printf("shader,frame_ms,cold_ms\n");
    double warm[2], cold[2];
    for (int k = 0; k < 2; k++) {
        warm[k] = benchmark_spread_of(pair[k].warm, FRAMES).median;
        cold[k] = benchmark_spread_of(pair[k].cold, COLD_RUNS).median;
        printf("%s,%.2f,%.1f\n", pair[k].path, 1000.0 * warm[k], 1000.0 * cold[k]);
    }
    printf("ratio,%.2f,%.2f\n", warm[1] / warm[0], cold[1] / cold[0]);
    return 0;
}
