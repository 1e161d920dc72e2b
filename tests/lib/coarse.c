#include "lib/coarse.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static void set_all(const char *name, const double *values, int count)
{
    struct parameter *parameter = parameters_find(&gpu.renderer.parameters, name);
    assert_non_null(parameter);
    for (int i = 0; i < count; i++)
        parameter->value[i] = values[i];
}

void coarse_set_scene(const struct coarse_scene *scene)
{
    char name[16];
    for (int i = 0; i < COARSE_BALLS; i++) {
        const struct d3 *ball = &scene->ball[i];
        snprintf(name, sizeof name, "ball%d", i);
        set_all(name, (const double[]){ball->x, ball->y, ball->z, scene->radius[i]}, 4);
    }
    const struct d3 *wire = scene->wire;
    set_all("wireFrom", (const double[]){wire[0].x, wire[0].y, wire[0].z}, 3);
    set_all("wireTo", (const double[]){wire[1].x, wire[1].y, wire[1].z}, 3);
    gpu_set("wireRadius", scene->wire_radius);
    gpu_set("threshold", scene->threshold);
    gpu_set("growth", scene->growth);
    gpu_set("factor", scene->factor);
    gpu_set("orthographic", scene->orthographic);
    gpu_set("framing", scene->framing);
    gpu_set("focalLength", scene->focal_length);
}

// ---- In double ----

static double wire_distance(const struct coarse_scene *scene, struct d3 p)
{
    struct d3 along = d3_sub(scene->wire[1], scene->wire[0]);
    struct d3 from = d3_sub(p, scene->wire[0]);
    double share = fmin(fmax(d3_dot(from, along) / d3_dot(along, along), 0.0), 1.0);
    return d3_length(d3_sub(from, d3_times(share, along))) - scene->wire_radius;
}

double coarse_distance(const struct coarse_scene *scene, struct d3 p)
{
    double least = wire_distance(scene, p);
    for (int i = 0; i < COARSE_BALLS; i++)
        least = fmin(least, d3_length(d3_sub(p, scene->ball[i])) - scene->radius[i]);
    return scene->factor * least;
}

double coarse_margin(const struct coarse_scene *scene, const struct renderer_inputs *inputs,
                     double t)
{
    return scene->threshold + scene->growth * t / (inputs->height * scene->focal_length);
}

struct mirror_ray coarse_ray(const struct coarse_scene *scene, const struct renderer_inputs *inputs,
                             double x, double y)
{
    struct camera_basis basis = camera_basis_of(&inputs->camera);
    double u = scene->orthographic;
    struct d3 forward = d3_of(basis.forward);
    struct d3 across =
        d3_add(d3_times(mirror_screen_x(x, inputs->width, inputs->height), d3_of(basis.right)),
               d3_times(mirror_screen_y(y, inputs->height), d3_of(basis.up)));
    return (struct mirror_ray){
        d3_add(d3_of(inputs->camera.position),
               d3_times(u * scene->framing / scene->focal_length, across)),
        d3_unit(d3_add(d3_times(1.0 - u, across), d3_times(scene->focal_length, forward)))};
}

double coarse_slack(struct mirror_ray ray, double t)
{
    return 16.0 * MIRROR_FLOAT_ROUNDING * (d3_length(ray.origin) + t + 1.0);
}

// ---- A picture ----

int coarse_blocks(int pixels)
{
    return (pixels + 7) / 8;
}

float *coarse_table(const struct renderer_inputs *inputs)
{
    size_t count = (size_t)coarse_blocks(inputs->width) * (size_t)coarse_blocks(inputs->height);
    float *table = malloc(4 * sizeof *table * count), *picture = gpu_numbers(inputs);
    assert_non_null(table);
    assert_int_equal(gpu.renderer.coarse.width, coarse_blocks(inputs->width));
    assert_int_equal(gpu.renderer.coarse.height, coarse_blocks(inputs->height));
    target_read(&gpu.renderer.coarse, gpu.renderer.gl, table);
    free(picture);
    return table;
}

// ---- A wire ----

struct coarse_scene coarse_wire(double growth, double lean)
{
    double pixel = 2.0 * 7.0 / (COARSE_HIGH * 2.0); // at a distance of 7, with focal length 2
    return (struct coarse_scene){
        .ball = {{-1.2, 0.9, 3.0}, {0.9, -0.7, 2.0}, {0.3, 0.2, -4.0}, {1.7, 0.9, 0.5}},
        .radius = {0.4, 0.35, 2.0, 0.3},
        .wire = {{-9.0, -9.0 * lean, 0.0}, {9.0, 9.0 * lean, 0.0}},
        .wire_radius = coarse_float(0.25 * pixel),
        .threshold = coarse_float(0.001),
        .growth = growth,
        .factor = 1.0,
        .framing = 7.0,
        .focal_length = 2.0};
}
