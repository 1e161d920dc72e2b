#include "lib/enlarge.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform.h"
#include "report.h"

enum { WIDTH = 640, HEIGHT = 360, FRAMES = 15 };

// The scenes have curved edges, shadows, thin objects, textures and mist.
const struct enlarge_scene enlarge_scenes[ENLARGE_SCENES] = {
    {"chapters/01_normal_colouring.frag", {{1.65f, 1.6f, 3.4f}, -26.0f, -23.5f}},
    {"chapters/03_shadows.frag", {{2.5f, 2.85f, 5.15f}, -29.0f, -24.0f}},
    {"chapters/06_sierpinski_symmetry.frag", {{-1.5f, 0.9f, 3.5f}, 22.0f, 2.0f}},
    {"chapters/12_textures.frag", {{-1.2f, 1.54f, 2.75f}, 19.0f, -16.0f}},
    {"chapters/15_the_picture.frag", {{-4.2f, 1.5f, -5.9f}, 145.0f, 3.0f}},
};

static struct image image_of(const float *numbers, int width, int height)
{
    struct image image;
    if (!image_create(&image, width, height))
        exit(1);
    image_store(&image, numbers, 0, height);
    return image;
}

static bool enlarge_into(struct target *to, enum enlarge_filter filter, const struct target *from,
                         int width, int height, struct enlarge *enlarge)
{
    const struct gl *gl = &gpu.context.gl;
    return target_bind(to, gl, width, height) &&
           enlarge_draw(enlarge, gl, filter, from, width, height);
}

float *enlarge_numbers_with(struct enlarge *enlarge, enum enlarge_filter filter,
                            const struct target *from, int width, int height)
{
    const struct gl *gl = &gpu.context.gl;
    struct target to;
    float *numbers = malloc(sizeof(float[4]) * (size_t)width * (size_t)height);
    target_open(&to, gl, GL_RGBA32F);
    if (numbers == NULL || !enlarge_into(&to, filter, from, width, height, enlarge)) {
        report("the picture cannot be enlarged to %dx%d", width, height);
        exit(1);
    }
    target_read(&to, gl, numbers);
    target_close(&to, gl);
    return numbers;
}

float *enlarge_numbers(enum enlarge_filter filter, const struct target *from, int width, int height)
{
    struct enlarge enlarge = {0};
    float *numbers = enlarge_numbers_with(&enlarge, filter, from, width, height);
    enlarge_close(&enlarge, &gpu.context.gl);
    return numbers;
}

static double rms_of(const struct image *a, const struct image *b)
{
    size_t count = 3 * (size_t)a->width * (size_t)a->height;
    double sum = 0.0;
    for (size_t i = 0; i < count; i++) {
        double off = (double)a->pixel[i] - (double)b->pixel[i];
        sum += off * off;
    }
    return sqrt(sum / (double)count);
}

void enlarge_measure(const struct enlarge_scene *scene, double divisor,
                     struct enlarge_error error[ENLARGE_FILTERS])
{
    struct renderer_inputs inputs = {
        .width = WIDTH, .height = HEIGHT, .camera = scene->camera, .time = 1.0, .samples = 1};
    gpu_open_shader(scene->shader);
    float *numbers = gpu_numbers(&inputs);
    struct image full = image_of(numbers, WIDTH, HEIGHT);
    free(numbers);
    inputs.width = (int)ceil(WIDTH / divisor);
    inputs.height = (int)ceil(HEIGHT / divisor);
    free(gpu_numbers(&inputs));
    for (int filter = 0; filter < ENLARGE_FILTERS; filter++) {
        numbers =
            enlarge_numbers((enum enlarge_filter)filter, &gpu.renderer.picture, WIDTH, HEIGHT);
        struct image large = image_of(numbers, WIDTH, HEIGHT);
        image_compare(&full, &large, &error[filter].difference);
        error[filter].rms = rms_of(&full, &large);
        image_free(&large);
        free(numbers);
    }
    image_free(&full);
}

// ---- What it costs ----

static double cpu_time(void)
{
    return platform_processor_seconds();
}

// Measure the processor time of tests/pictures/reference_scene.frag, which is the unit, and of each
// filter, alternating between them. Each time is the shortest of several frames, in seconds.
static bool time_filters(double *unit, double least[ENLARGE_FILTERS])
{
    const struct gl *gl = &gpu.context.gl;
    struct renderer_inputs inputs = gpu_inputs(WIDTH, HEIGHT, 1), small = gpu_inputs(320, 180, 1);
    struct enlarge enlarge = {0};
    struct target to;
    bool done = gpu_load("tests/pictures/reference_scene.frag");
    target_open(&to, gl, GL_RGBA32F);
    for (int i = 0; i < FRAMES && done; i++) {
        double begin = cpu_time();
        done = renderer_draw(&gpu.renderer, &inputs, 0, HEIGHT);
        gl->Finish();
        double seconds = cpu_time() - begin;
        *unit = i == 0 || seconds < *unit ? seconds : *unit;
        done = done && renderer_draw(&gpu.renderer, &small, 0, small.height);
        gl->Finish();
        for (int filter = 0; filter < ENLARGE_FILTERS && done; filter++) {
            begin = cpu_time();
            done = enlarge_into(&to, (enum enlarge_filter)filter, &gpu.renderer.picture, WIDTH,
                                HEIGHT, &enlarge);
            gl->Finish();
            seconds = cpu_time() - begin;
            if (i <= 1 || seconds < least[filter])
                least[filter] = seconds;
        }
    }
    target_close(&to, gl);
    enlarge_close(&enlarge, gl);
    return done;
}

int enlarge_print(void)
{
    static const double divisors[] = {1.5, 2.0, 3.0};
    struct enlarge_error error[ENLARGE_FILTERS];
    double unit = 0.0, least[ENLARGE_FILTERS] = {0};
    printf("# pictures of a lower resolution, enlarged to 640x360 and compared with full pictures: "
           "the share of pixels that differ by more than 2 of 255, the error of the means of 8x8 "
           "blocks and the root mean square error, where white is 255\n");
    printf("shader,divisor,filter,F2 %%,B8,rms\n");
    for (int scene = 0; scene < ENLARGE_SCENES; scene++)
        for (size_t i = 0; i < sizeof divisors / sizeof *divisors; i++) {
            enlarge_measure(&enlarge_scenes[scene], divisors[i], error);
            for (int filter = 0; filter < ENLARGE_FILTERS; filter++)
                printf("%s,%g,%s,%.2f,%.2f,%.2f\n", enlarge_scenes[scene].shader, divisors[i],
                       enlarge_name((enum enlarge_filter)filter),
                       100.0 * error[filter].difference.f2, error[filter].difference.b8,
                       error[filter].rms);
        }
    if (!time_filters(&unit, least))
        return 1;
    printf("# CPU time for enlarging 320x180 to 640x360; 1 unit is the time of "
           "tests/pictures/reference_scene.frag\n");
    printf("filter,units\n");
    for (int filter = 0; filter < ENLARGE_FILTERS; filter++)
        printf("%s,%.3f\n", enlarge_name((enum enlarge_filter)filter), least[filter] / unit);
    return 0;
}
