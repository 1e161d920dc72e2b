// numeric.c - the library's functions on the GPU, compared with double precision and with
// brute-force methods that share no formula with them.
#include <float.h>

#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

#define DISTANCES "tests/shaders/distances.frag"
#define VALUES    "tests/shaders/values.frag"

enum { SPHERE, PLANE, BOX, FRAME, TWO_BALLS };

enum { ITEMS_WIDE = 256, SLOTS = 4, ROWS = 256, ITEMS = ITEMS_WIDE * ROWS };

// A function of the shader and its arguments: sizes in x, y and z; a radius, a height or a beam in
// w.
struct sizes {
    int function;
    float v[4];
};

static const struct sizes all_sizes[] = {
    {SPHERE, {0.0f, 0.0f, 0.0f, 0.75f}},     {SPHERE, {0.0f, 0.0f, 0.0f, 0.3f}},
    {PLANE, {0.0f, 1.0f, 0.0f, -0.5f}},      {PLANE, {0.48f, 0.6f, -0.64f, 0.3f}},
    {BOX, {0.75f, 0.5f, 1.25f, 0.0f}},       {BOX, {2.6f, 0.1f, 2.2f, 0.0f}},
    {FRAME, {0.75f, 0.5f, 1.25f, 0.125f}},   {FRAME, {0.8f, 0.8f, 0.8f, 0.08f}},
    {FRAME, {0.5f, 1.0f, 1.5f, 0.3f}},       {TWO_BALLS, {0.5f, 0.0f, 0.0f, 0.75f}},
    {TWO_BALLS, {0.25f, 0.0f, 0.0f, 0.75f}},
};

enum { SIZES = sizeof all_sizes / sizeof all_sizes[0] };

static double mirror(const struct sizes *sizes, struct d3 p)
{
    struct d3 v = d3_of(sizes->v), shift = d3(v.x, 0.0, 0.0);
    double w = (double)sizes->v[3];
    switch (sizes->function) {
    case SPHERE:
        return mirror_sphere(p, w);
    case PLANE:
        return mirror_plane(p, v, w);
    case BOX:
        return mirror_box(p, v);
    case FRAME:
        return mirror_box_frame(p, v, w);
    default:
        return fmin(mirror_sphere(d3_add(p, shift), w), mirror_sphere(d3_sub(p, shift), w));
    }
}

static double brute(const struct sizes *sizes, struct d3 p)
{
    struct d3 v = d3_of(sizes->v);
    double w = (double)sizes->v[3];
    switch (sizes->function) {
    case BOX:
        return brute_box(p, v);
    case FRAME:
        return brute_box_frame(p, v, w);
    case TWO_BALLS:
        return brute_two_balls(p, v.x, w);
    default:
        return mirror(sizes, p);
    }
}

// An upper bound on the rounding error of a distance. One or two subtractions, three squares, their
// sum and a root are each off by at most one rounding of a number no larger than |p| + |sizes|. Six
// roundings in total are generous; at most 2.5 were observed.
static double rounding(const struct sizes *sizes, struct d3 p)
{
    double size = d3_length(d3_of(sizes->v)) + fabs((double)sizes->v[3]);
    return 6.0 * MIRROR_FLOAT_ROUNDING * (d3_length(p) + size);
}

static struct d3 vector(const float *slot)
{
    return d3_of(slot);
}

static float *distances(const struct sizes *sizes)
{
    return gpu_call(DISTANCES, ITEMS_WIDE * SLOTS, ROWS, sizes->function, sizes->v);
}

TEST(test_distances_agree_with_double)
{
    for (int k = 0; k < SIZES; k++) {
        float *values = distances(&all_sizes[k]);
        double worst = 0.0;
        for (int i = 0; i < 2 * ITEMS; i++) {
            const float *slot = values + 4 * (i / 2 * SLOTS + i % 2);
            struct d3 p = vector(slot);
            double error = fabs((double)slot[3] - mirror(&all_sizes[k], p));
            worst = fmax(worst, error / rounding(&all_sizes[k], p));
        }
        free(values);
        print_message("# function %d, %d points: largest error %.2f times the bound for rounding\n",
                      all_sizes[k].function, 2 * ITEMS, worst);
        assert_true(worst <= 1.0);
    }
}

// The distances to the sphere, the plane and the box are exact everywhere. Those to the frame and
// to the union are exact outside; inside, their absolute value is at most the depth.
TEST(test_distances_are_exact_or_a_bound)
{
    for (int k = 0; k < SIZES; k++) {
        const struct sizes *sizes = &all_sizes[k];
        float *values = distances(sizes);
        int inside = 0, outside = 0, short_of = 0;
        for (int i = 0; i < ITEMS; i++) {
            const float *slot = values + 4 * (i * SLOTS);
            struct d3 p = vector(slot);
            double f = (double)slot[3], truth = brute(sizes, p), slack = rounding(sizes, p);
            inside += truth < 0.0;
            outside += truth > 0.0;
            if (truth < -slack && sizes->function >= FRAME) {
                assert_true(f <= slack && f >= truth - slack);
                short_of += f > truth + slack;
            } else {
                assert_true(fabs(f - truth) <= slack);
            }
        }
        free(values);
        print_message("# function %d: %d points outside, %d inside, only a bound at %d\n",
                      sizes->function, outside, inside, short_of);
        assert_true(inside > 100 && outside > 1000);
        assert_true(sizes->function < FRAME ? short_of == 0 : short_of > 10);
    }
}

TEST(test_distances_are_1_lipschitz)
{
    for (int k = 0; k < SIZES; k++) {
        float *values = distances(&all_sizes[k]);
        double largest = 0.0;
        for (int i = 0; i < ITEMS; i++) {
            const float *slot = values + 4 * (i * SLOTS);
            struct d3 p = vector(slot), q = vector(slot + 4);
            double apart = d3_length(d3_sub(p, q)), change = fabs((double)(slot[3] - slot[7]));
            double slack = rounding(&all_sizes[k], p) + rounding(&all_sizes[k], q);
            assert_true(change <= apart + slack);
            if (apart > 1000.0 * slack)
                largest = fmax(largest, change / apart);
        }
        free(values);
        print_message("# function %d: largest |f(p) - f(q)| / |p - q| is %.6f\n",
                      all_sizes[k].function, largest);
        assert_true(largest > 0.99 && largest <= 1.001);
    }
}

// The gradient has length 1 except where the nearest point jumps: at the centre, and on the medial
// surfaces. Central differences with a step of h are wrong within h of such a surface. Beside an
// edge, where the level surfaces have a radius of curvature of r, the differences are off by
// h^2 / (6 r^2).
TEST(test_gradients_have_length_1_almost_everywhere)
{
    for (int k = 0; k < SIZES; k++) {
        float *values = distances(&all_sizes[k]);
        int asked = 0, off = 0;
        for (int i = 0; i < ITEMS; i++) {
            const float *slot = values + 4 * (i * SLOTS);
            if (i % 8 >= 4) // these points are deliberately where the gradient jumps, or far away
                continue;
            asked++;
            off += fabs((double)slot[11] - 1.0) > 0.002;
        }
        free(values);
        print_message("# function %d: of %d gradients, %d have a length other than 1\n",
                      all_sizes[k].function, asked, off);
        assert_true(off < asked / 50);
    }
}

// ---- Light ----

static float *values_of(int function, int rows)
{
    return gpu_call(VALUES, 1024, rows, function, (const float[4]){0});
}

// pow is the only inexact function of the encoding, so an error of a hundredth of one of the
// screen's 255 steps is allowed.
TEST(test_encoding_agrees_with_double_and_rises)
{
    enum { COUNT = 1024 * 12 };
    float *values = values_of(0, 12);
    double worst = 0.0;
    for (int i = 0; i < COUNT; i++) {
        const float *v = values + 4 * i;
        worst = fmax(worst, fabs((double)v[1] - mirror_encode((double)v[0])));
        assert_true(v[1] >= 0.0f && v[1] <= 1.00001f && fabs((double)v[3] - 1.0) < 1e-5);
        assert_true(fabs((double)v[2] - mirror_encode(0.5)) < 1e-4);
        if (i % 1024 > 0 && i / 1024 == (i - 1) / 1024)
            assert_true(v[1] >= v[-3] - 1e-6f);
        if (v[0] > 0.0f && (double)v[0] <= 0.0031308)
            assert_true(fabs((double)v[1] - 12.92 * (double)v[0]) < 1e-8);
    }
    free(values);
    print_message("# encodeSRGB: worst error %.2g\n", worst);
    assert_true(worst < 0.001 / 255.0 * 10.0);
}

// How much brighter the mean of encoded lights is than the encoded mean.
static double mean_excess(const double *light, int count)
{
    double mean = 0.0, encoded = 0.0;
    for (int i = 0; i < count; i++) {
        mean += light[i] / count;
        encoded += mirror_encode(light[i]) / count;
    }
    return encoded - mirror_encode(mean);
}

// Chapter 02, proof 4: the mean of n encoded lights is brighter than the encoded mean by at most
// (1 - 1/n) times the step down between the two pieces of the curve. Two lights on either side of
// the step come close to this bound.
TEST(test_mean_of_encoded_lights_is_hardly_brighter)
{
    const double corner = 0.0031308;
    const double step = 12.92 * corner - (1.055 * pow(corner, 1.0 / 2.4) - 0.055);
    assert_true(step > 2.851e-8 && step < 2.853e-8);
    const double pair[2] = {corner, corner + 1e-11};
    assert_true(mean_excess(pair, 2) > 0.499 * step && mean_excess(pair, 2) < 1.43e-8);
    srand(4);
    double worst = 0.0;
    for (int i = 0; i < 200000; i++) {
        double light[8];
        int count = 2 + rand() % 7;
        for (int k = 0; k < count; k++) { // in half of the sets, 1e-15 to 1e-3 from the corner
            double u = rand() / (double)RAND_MAX, sign = rand() % 2 ? 1.0 : -1.0;
            light[k] = i % 2 ? u : corner + sign * pow(10.0, -3.0 - 12.0 * u);
        }
        double excess = mean_excess(light, count);
        assert_true(excess <= (1.0 - 1.0 / count) * step + 1e-15);
        worst = fmax(worst, excess);
    }
    print_message("# mean of encoded lights: brighter by at most %.3g\n", worst);
    assert_true(worst > 0.5 * step);
}

// The share of unpolarised light from the air that is reflected at a medium of this index of
// refraction: the mean over the two polarisations of the squared ratio of the amplitudes.
static double fresnel(double facing, double index)
{
    double inside = sqrt(1.0 - (1.0 - facing * facing) / (index * index));
    double across = (facing - index * inside) / (facing + index * inside);
    double along = (index * facing - inside) / (index * facing + inside);
    return 0.5 * (across * across + along * along);
}

TEST(test_schlick_is_near_fresnel)
{
    float *values = values_of(5, 1);
    double water = 0.0, glass = 0.0;
    for (int i = 0; i < 1024; i++) {
        const float *v = values + 4 * i;
        double facing = (double)v[0], power = pow(1.0 - facing, 5.0);
        assert_true(fabs((double)v[1] - (0.02 + 0.98 * power)) < 1e-6);
        assert_true(fabs((double)v[2] - (0.04 + 0.96 * power)) < 1e-6);
        water = fmax(water, fabs((double)v[1] - fresnel(facing, 1.333)));
        glass = fmax(glass, fabs((double)v[2] - fresnel(facing, 1.5)));
    }
    print_message(
        "# Schlick compared with Fresnel: off by at most %.4f for water, %.4f for glass\n", water,
        glass);
    assert_true(values[1] == 1.0f && values[4 * 1023 + 1] == 0.02f);
    assert_true(water > 0.05 && water < 0.060 && glass > 0.03 && glass < 0.036);
    free(values);
}

// For all pairs of intervals with ends from 0 to 4, including empty ones, compare the union with
// the first and the last point of a fine grid that lie in either interval.
TEST(test_interval_union_is_the_smallest)
{
    float *values = values_of(6, 1);
    for (int i = 0; i < 625; i++) {
        const float *v = values + 4 * i;
        int a[2] = {i % 5, i / 5 % 5}, b[2] = {i / 25 % 5, i / 125};
        double first = INFINITY, last = -INFINITY;
        for (double t = 0.0; t <= 4.0; t += 0.25)
            if ((a[0] < a[1] && a[0] <= t && t <= a[1]) ||
                (b[0] < b[1] && b[0] <= t && t <= b[1])) {
                first = fmin(first, t);
                last = fmax(last, t);
            }
        if (first < last)
            assert_true((double)v[0] == first && (double)v[1] == last);
        else
            assert_true(v[0] >= v[1]);
    }
    free(values);
}

// The share of a pixel that stripes cover: the sum of what it shares with each of them.
static double shared_with_stripes(double x, double filled, double width)
{
    double sum = 0.0;
    for (int k = -4; k <= 4; k++) {
        double left = fmax(x - 0.5 * width, k + 0.5 - 0.5 * filled);
        double right = fmin(x + 0.5 * width, k + 0.5 + 0.5 * filled);
        sum += fmax(right - left, 0.0);
    }
    return sum / width;
}

// Each row of the shader has a pixel of one width and stripes of one width; both add 0.001 to the
// width of the pixel. A pixel as wide as 60 of the narrowest stripes still gets the right share.
TEST(test_coverage_is_a_share)
{
    float *values = values_of(7, 16);
    double worst = 0.0;
    for (int i = 0; i < 1024 * 16; i++) {
        const float *v = values + 4 * i;
        double x = (double)v[0], wide = (double)v[1] + 0.001,
               filled = 0.025 + 0.25 * (i / 1024 % 4);
        assert_true(fabs((double)v[3] - mirror_clamp(x / wide + 0.5)) < 1e-3);
        if (i >= 1024)
            worst = fmax(worst, fabs((double)v[2] - shared_with_stripes(x, filled, wide)));
    }
    free(values);
    print_message("# stripes: the share of a pixel is off by at most %.7f\n", worst);
    assert_true(worst < 1e-5);
}

// ---- The ramp of the steps view ----

// The ramp has eight pieces, each linear in the encoded colours, so it cannot be perfectly even:
// between two of the nine given colours, the lightness is off by up to 0.0033 in a range of 0.78.
TEST(test_ramp_rises_evenly_for_every_eye)
{
    float *values = values_of(1, 1);
    double uneven = 0.0, before[3] = {-1.0, -1.0, -1.0};
    double low = mirror_lightness(d3_of(values), VISION_FULL);
    double high = mirror_lightness(d3_of(values + 4 * 1023), VISION_FULL);
    for (int i = 0; i < 1024; i++) {
        struct d3 colour = d3_of(values + 4 * i);
        double even = low + (high - low) * i / 1023.0;
        uneven = fmax(uneven, fabs(mirror_lightness(colour, VISION_FULL) - even));
        for (enum mirror_vision eye = VISION_FULL; eye <= VISION_DEUTAN; eye++) {
            double lightness = mirror_lightness(colour, eye);
            assert_true(lightness > before[eye]);
            before[eye] = lightness;
        }
    }
    free(values);
    print_message(
        "# ramp: lightness from %.3f to %.3f, uneven by at most %.4f; up to %.3f for protan, "
        "%.3f for deutan vision\n",
        low, high, uneven, before[VISION_PROTAN], before[VISION_DEUTAN]);
    assert_true(fabs(low - 0.17) < 0.005 && fabs(high - 0.95) < 0.005);
    assert_true(uneven < 0.005);
}

// ---- The camera ----

static void check_rays(const struct camera *camera, float focal_length)
{
    enum { WIDTH = 65, HEIGHT = 33 };
    gpu.renderer.focal_length = focal_length;
    struct renderer_inputs inputs = {
        .width = WIDTH, .height = HEIGHT, .time = 2.0, .camera = *camera, .samples = 1};
    float *values = gpu_numbers(&inputs);
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const float *v = values + 4 * (y * WIDTH + x);
            struct mirror_ray ray = mirror_screen_ray(camera, (double)focal_length,
                                                      mirror_screen_x(x + 0.5, WIDTH, HEIGHT),
                                                      mirror_screen_y(y + 0.5, HEIGHT));
            assert_true(d3_length(d3_sub(d3_of(v), ray.direction)) < 6e-7);
            assert_true(v[3] == camera->position[0]);
        }
    struct camera_basis basis = camera_basis_of(camera);
    struct d3 centre = d3_of(values + 4 * (HEIGHT / 2 * WIDTH + WIDTH / 2));
    struct d3 corner = d3_of(values + 4 * (HEIGHT * WIDTH - 1));
    assert_true(d3_length(d3_sub(centre, d3_of(basis.forward))) < 3e-7);
    double x = 64.0 / 33.0, y = 32.0 / 33.0;
    double angle = atan(hypot(x, y) / (double)focal_length) * 180.0 / MIRROR_PI;
    assert_true(fabs(d3_angle(corner, centre) - angle) < 1e-4);
    assert_true(d3_dot(corner, d3_of(basis.right)) > 0.0 && d3_dot(corner, d3_of(basis.up)) > 0.0);
    free(values);
}

TEST(test_rays_leave_the_camera_as_its_basis_says)
{
    assert_true(gpu_load(VALUES));
    const struct camera cameras[] = {{.position = {0.0f, 0.0f, 0.0f}},
                                     {{1.5f, 2.75f, 5.3f}, -17.0f, -22.5f},
                                     {{-3.0f, 1.0f, 2.0f}, 123.0f, 89.0f},
                                     {{7.0f, -1.0f, -2.0f}, -179.0f, -60.0f}};
    for (int i = 0; i < 4; i++) {
        check_rays(&cameras[i], 1.0f);
        check_rays(&cameras[i], 2.0f);
        check_rays(&cameras[i], 0.3f);
    }
    gpu.renderer.focal_length = 1.0f;
}

TESTS(gpu_setup, gpu_teardown)
