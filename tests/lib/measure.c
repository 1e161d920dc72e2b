#include "lib/measure.h"

#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- The normal's step ----

static float ball_at_ten(const float p[3])
{
    float z = p[2] - 10.0f;
    return sqrtf(p[0] * p[0] + p[1] * p[1] + z * z) - 1.0f;
}

// Compare central and forward differences at one point with the direction from the centre, and keep
// the largest errors.
static void compare_differences(const float p[3], float h, struct normal_error *worst)
{
    float central[3], forward[3];
    for (int axis = 0; axis < 3; axis++) {
        float after[3] = {p[0], p[1], p[2]}, before[3] = {p[0], p[1], p[2]};
        after[axis] += h;
        before[axis] -= h;
        central[axis] = ball_at_ten(after) - ball_at_ten(before);
        forward[axis] = ball_at_ten(after) - ball_at_ten(p);
    }
    struct d3 normal = d3_sub(d3_of(p), d3(0.0, 0.0, 10.0));
    worst->central = fmax(worst->central, d3_angle(d3_of(central), normal));
    worst->forward = fmax(worst->forward, d3_angle(d3_of(forward), normal));
}

struct normal_error measure_normal(double h)
{
    const double degrees = 180.0 / MIRROR_PI;
    const int points = 20000;
    struct normal_error worst = {0};
    for (int i = 0; i < points; i++) {
        // A spiral that covers the ball evenly.
        double z = 1.0 - (2.0 * i + 1.0) / points, around = 2.399963229728653 * i;
        double r = sqrt(1.0 - z * z);
        const float p[3] = {(float)(r * cos(around)), (float)(r * sin(around)), (float)(10.0 + z)};
        compare_differences(p, (float)h, &worst);
    }
    // Let N be the normal at a point of the ball. The third derivative of the distance along axis i
    // is -3 N_i (1 - N_i^2), and the second is 1 - N_i^2. Only the components of these vectors
    // perpendicular to N count: their lengths are at most 3 x 0.2805 and sqrt(2).
    worst.central_truncation = 0.2805 * h * h / 2.0 * degrees;
    worst.forward_truncation = sqrt(2.0) * h / 2.0 * degrees;
    // In each of the two distances, z is rounded by up to 2^-21, and the length is rounded three
    // times by up to 2^-24.
    worst.rounding = (8.0 + 2.0 * sqrt(3.0)) * MIRROR_FLOAT_ROUNDING / h * degrees;
    return worst;
}

// ---- The number of steps ----

static const struct mirror_part plane_part = {
    "plane", MIRROR_PLANE, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.0};
static const struct mirror_part ball_part = {
    "ball", MIRROR_SPHERE, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 1.0};
static const struct mirror_scene plane_scene = {&plane_part, 1, NULL};
static const struct mirror_scene ball_scene = {&ball_part, 1, NULL};

int measure_plane_moves(double angle, double threshold)
{
    double radians = angle * MIRROR_PI / 180.0;
    struct mirror_ray ray = {{0.0, 1.0, 0.0}, {cos(radians), -sin(radians), 0.0}};
    return mirror_march(&plane_scene, ray, 0.0, 1e9, threshold, 100000000).steps - 1;
}

int measure_plane_formula(double angle, double threshold)
{
    double sine = sin(angle * MIRROR_PI / 180.0);
    return sine >= 1.0 ? 1 : (int)ceil(log(threshold) / log1p(-sine));
}

double measure_plane_limit(int evaluations, double threshold)
{
    return asin(1.0 - pow(threshold, 1.0 / (evaluations - 1))) * 180.0 / MIRROR_PI;
}

int measure_ball_moves(double delta, double threshold)
{
    struct mirror_ray ray = {{-3.0, 1.0 + delta, 0.0}, {1.0, 0.0, 0.0}};
    struct mirror_march march = mirror_march(&ball_scene, ray, 0.0, 6.0, threshold, 100000000);
    return march.end == MIRROR_HIT ? march.steps - 1 : march.steps;
}

double measure_rate(double cosine)
{
    double aside = sqrt(1.0 - cosine * cosine), hit = 3.0 - cosine, t = 0.0, ratio = 0.0;
    struct mirror_ray ray = {{-3.0, aside, 0.0}, {1.0, 0.0, 0.0}};
    // Near the limit of double precision, the ratio would consist of rounding errors.
    while (hit - t > 1e-7) {
        double next = t + mirror_distance(&ball_scene, mirror_at(ray, t), NULL);
        ratio = (hit - next) / (hit - t);
        t = next;
    }
    return ratio;
}

double measure_foot(double radius, double threshold)
{
    const int rays = 20000;
    double worst = 0.0;
    for (int i = 0; i < rays; i++) {
        // Half of the rays are close to the silhouette.
        double inside = i % 2 == 0 ? (i + 0.5) / rays : threshold * (i + 0.5) / rays;
        double aside = radius * (1.0 - inside), x = -5.0, distance;
        while ((distance = hypot(x, aside) - radius) >= threshold)
            x += distance;
        double meets = -sqrt(radius * radius - aside * aside);
        worst = fmax(worst, fabs(atan2(aside, -x) - atan2(aside, -meets)));
    }
    return worst * 180.0 / MIRROR_PI;
}

// ---- What the threshold adds ----

enum { WIDTH = 640, HEIGHT = 360 };

double measure_outline(double threshold)
{
    struct renderer_inputs inputs = {
        .width = WIDTH, .height = HEIGHT, .samples = 1, .camera = {.position = {0.0f, 0.0f, 5.0f}}};
    gpu_open_shader("tests/shaders/silhouette.frag");
    gpu_set("hitThreshold", threshold);
    float *values = gpu_numbers(&inputs);
    int white = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        white += values[4 * i] > 0.5f;
    free(values);
    return sqrt(white / MIRROR_PI);
}

double measure_outline_theory(double threshold)
{
    double radius = 1.0 + threshold;
    return MIRROR_FOCAL_LENGTH * HEIGHT / 2.0 * radius / sqrt(25.0 - radius * radius);
}

// ---- Acne ----

// Look at every third pixel. Count the lit pixels of the stage whose surroundings are also lit, and
// those of them whose red channel in the picture is less than 0.7 of the expected value.
static void count_acne(const struct camera *camera, const float *values, int *lit, int *dark)
{
    static const double offset[3] = {-3.0, 3.0, 0.0}; // pixels; the sample at 0 is kept
    struct mirror_eye eye = {.camera = *camera};
    for (int i = 0; i < WIDTH * HEIGHT; i += 3) {
        bool whole = true;
        struct mirror_sample sample = {0};
        for (int k = 0; k < 3 && whole; k++) {
            eye.x = mirror_screen_x(i % WIDTH + 0.5 + offset[k], WIDTH, HEIGHT);
            eye.y = mirror_screen_y(i / WIDTH + 0.5 + offset[k], HEIGHT);
            sample = mirror_stage(&eye);
            whole = strcmp(sample.what, "stage") == 0 && sample.faces && !sample.shadowed;
        }
        *lit += whole;
        *dark += whole && (double)values[4 * i] < 0.7 * sample.colour.x;
    }
}

double measure_acne(double offset)
{
    struct renderer_inputs inputs = {.width = WIDTH, .height = HEIGHT, .samples = 1};
    inputs.camera = gpu_open_chapter("03_shadows");
    gpu_set("shadowOffset", offset);
    float *values = gpu_numbers(&inputs);
    int lit = 0, dark = 0;
    count_acne(&inputs.camera, values, &lit, &dark);
    free(values);
    return (double)dark / lit;
}

// Draw tests/shaders/shadows.frag. The caller frees the numbers.
static float *shadow_shares(const struct camera *camera, int formula)
{
    struct renderer_inputs inputs = {.width = 160, .height = 90, .samples = 1, .camera = *camera};
    gpu_set("formula", formula);
    return gpu_numbers(&inputs);
}

// Average the errors over the pixels that do not see all of the sun. These pixels are the same for
// every formula.
//   quick  a picture whose red channel is the share that one formula gives
//   truth  a picture whose blue channel is the true share
static void add_up(const float *quick, const float *truth, struct shadow_error *error)
{
    int pixels = 0;
    *error = (struct shadow_error){0.0, 0.0, 0.0};
    for (int i = 0; i < 160 * 90; i++) {
        double off = (double)quick[4 * i] - (double)truth[4 * i + 2];
        if (truth[4 * i + 2] > 0.999f)
            continue;
        error->mean += off;
        error->mean_size += fabs(off);
        error->worst = fmax(error->worst, fabs(off));
        pixels++;
    }
    error->mean /= fmax(pixels, 1.0);
    error->mean_size /= fmax(pixels, 1.0);
}

void measure_shadow_scene(struct shadow_error error[5])
{
    struct camera camera = gpu_camera("13_soft_shadows");
    gpu_open_shader("tests/shaders/shadows.frag");
    float *truth = shadow_shares(&camera, 0);
    for (int formula = 0; formula < 5; formula++) {
        float *quick = shadow_shares(&camera, formula);
        add_up(quick, truth, &error[formula]);
        free(quick);
    }
    free(truth);
}
