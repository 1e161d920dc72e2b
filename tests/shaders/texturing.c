// texturing.c - tests shaders/texture.glsl: the weights add up to 1; a footprint is the ellipse in
// which a ray with a circular cross-section meets a surface; a bumped normal is the normal of a
// raised surface; and the gradient of a picture's heights is computed from the differences between
// texels.
#include "lib/test.h"
#include "picture/image.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

#define SHADER "tests/shaders/texture.frag"

enum { NORMAL, DIRECTION, GRADIENT, WEIGHTS, TWO, ACROSS, ALONG, BUMPED, SLOTS };
enum { WIDE = 128, ROWS = 64, ITEMS = WIDE * ROWS };

// The vector in a slot of an item.
static struct d3 of(const float *values, int item, int slot)
{
    return d3_of(values + 4 * (item * SLOTS + slot));
}

static float *ask(float sharpness)
{
    return gpu_call(SHADER, WIDE * SLOTS, ROWS, 0, (const float[4]){sharpness});
}

static double least_of(struct d3 v)
{
    return fmin(v.x, fmin(v.y, v.z));
}

TEST(test_weights_add_up_to_1)
{
    static const float sharpnesses[] = {1.0f, 2.0f, 6.0f, 20.0f};
    for (int k = 0; k < 4; k++) {
        float *values = ask(sharpnesses[k]);
        double worst = 0.0, largest_third = 0.0, s = (double)sharpnesses[k];
        for (int i = 0; i < ITEMS; i++) {
            struct d3 n = of(values, i, NORMAL), w = of(values, i, WEIGHTS),
                      two = of(values, i, TWO);
            struct d3 power = d3(pow(fabs(n.x), s), pow(fabs(n.y), s), pow(fabs(n.z), s));
            struct d3 truth = d3_times(1.0 / (power.x + power.y + power.z), power);
            double low = least_of(truth);
            struct d3 less = d3_sub(truth, d3(low, low, low));
            worst = fmax(worst, d3_length(d3_sub(w, truth)));
            assert_true(fabs(w.x + w.y + w.z - 1.0) < 1e-6);
            assert_true(least_of(two) == 0.0 && fabs(two.x + two.y + two.z - 1.0) < 1e-6);
            if (low < 0.3)
                worst =
                    fmax(worst,
                         d3_length(d3_sub(two, d3_times(1.0 / (less.x + less.y + less.z), less))));
            largest_third = fmax(largest_third, low);
        }
        free(values);
        print_message(
            "# sharpness %g: weights off by at most %.1g; the third weight is at most %.3f\n", s,
            worst, largest_third);
        assert_true(worst < 2e-5 && largest_third > 0.28 && largest_third <= 1.0 / 3.0 + 1e-6);
    }
}

// The point where a ray meets the plane of the surface, if the ray is moved by `aside` from the
// pixel's central ray.
static struct d3 meets_plane(struct d3 aside, struct d3 direction, struct d3 normal)
{
    return d3_sub(aside, d3_times(d3_dot(aside, normal) / d3_dot(direction, normal), direction));
}

// The rim of a round ray meets the plane in an ellipse whose axes are those of the footprint.
TEST(test_a_footprint_is_the_ellipse_of_a_ray)
{
    float *values = ask(1.0f);
    double worst = 0.0;
    int seen = 0, flat = 0;
    for (int i = 0; i < ITEMS; i++) {
        struct d3 n = of(values, i, NORMAL), d = of(values, i, DIRECTION);
        struct d3 across = of(values, i, ACROSS), along = of(values, i, ALONG);
        double sine = fabs(d3_dot(n, d));
        assert_true(fabs(d3_dot(across, n)) < 1e-8 && fabs(d3_dot(along, n)) < 2e-7);
        // Seen perpendicularly, the footprint is round; at a grazing angle, its length is limited
        // to 16 times the width.
        assert_true(fabs(d3_length(across) - 0.01) < 1e-8);
        assert_true(sine < 0.999999 || fabs(d3_length(along) - 0.01) < 2e-8);
        if (sine < 0.0624) {
            flat++;
            assert_true(fabs(d3_length(along) - 0.16) < 1e-6);
        }
        if (sine < 0.07 || sine > 0.999)
            continue;
        seen++;
        struct d3 a = d3_unit(d3_cross(d, n)), b = d3_cross(a, d);
        struct d3 rim[2] = {meets_plane(d3_times(0.01, a), d, n),
                            meets_plane(d3_times(0.01, b), d, n)};
        double sign = d3_dot(rim[1], along) < 0.0 ? -1.0 : 1.0;
        worst = fmax(worst, d3_length(d3_sub(across, rim[0])));
        worst = fmax(worst, d3_length(d3_sub(along, d3_times(sign, rim[1]))));
    }
    free(values);
    print_message("# %d footprints of rays 0.01 wide: off by at most %.1g\n", seen, worst);
    assert_true(seen > ITEMS / 2 && flat > 100 && worst < 1e-6);
}

// The expected normal is that of a plane with the normal n that is raised along n by
// dot(gradient, p); the test computes it from two tangents.
TEST(test_a_bump_is_a_raised_surface)
{
    float *values = ask(1.0f);
    double worst = 0.0;
    for (int i = 0; i < ITEMS; i++) {
        struct d3 n = of(values, i, NORMAL), g = of(values, i, GRADIENT);
        struct d3 helper = fabs(n.x) < 0.7 ? d3(1.0, 0.0, 0.0) : d3(0.0, 1.0, 0.0);
        struct d3 u = d3_unit(d3_cross(n, helper)), v = d3_cross(n, u);
        struct d3 raised_u = d3_add(u, d3_times(d3_dot(g, u), n)),
                  raised_v = d3_add(v, d3_times(d3_dot(g, v), n));
        worst = fmax(
            worst, d3_length(d3_sub(of(values, i, BUMPED), d3_unit(d3_cross(raised_u, raised_v)))));
    }
    free(values);
    print_message("# bumps: off by at most %.1g\n", worst);
    assert_true(worst < 2e-6);
}

// ---- Heights ----

enum { POINTS = 64, SIDE = 512 };

// The height in a picture at a texel, with wrap-around; 0,0 is at the bottom left.
static double height_of(const struct image_bytes *image, int x, int y)
{
    x %= SIDE, y %= SIDE;
    return image->value[3 * (SIDE * (SIDE - 1 - y) + x)] / 255.0;
}

// At the centre of a texel, the height is the texel's value. The gradient in space comes from the
// differences to the texels `reach` away, along the two axes that span the picture.
static void check_heights(const struct image_bytes *image, int axis, int reach)
{
    const float numbers[4] = {(float)reach};
    float *heights = gpu_call("tests/shaders/heights.frag", POINTS, POINTS, axis, numbers);
    float *slopes = gpu_call("tests/shaders/heights.frag", POINTS, POINTS, axis + 3, numbers);
    double worst = 0.0, most = 0.0;
    for (int i = 0; i < POINTS * POINTS; i++) {
        int x = i % POINTS, y = i / POINTS, u = (167 * x + 59 * y) % SIDE,
            v = (101 * x + 211 * y) % SIDE;
        double h = height_of(image, u, v), per = (double)SIDE / reach;
        double along_u = (height_of(image, u + reach, v) - h) * per;
        double along_v = (height_of(image, u, v + reach) - h) * per;
        struct d3 truth = axis == 0   ? d3(0.0, along_v, along_u)
                          : axis == 1 ? d3(along_u, 0.0, along_v)
                                      : d3(along_u, along_v, 0.0);
        struct d3 shown = d3_of(slopes + 4 * i);
        struct d3 slope = d3_times(4096.0, d3_sub(shown, d3(0.5, 0.5, 0.5)));
        worst = fmax(worst, fabs((double)heights[4 * i] - h));
        worst = fmax(worst, d3_length(d3_sub(slope, truth)) / per);
        most = fmax(most, d3_length(truth));
    }
    free(heights);
    free(slopes);
    print_message("# axis %d, reach %d: off by at most %.1g of a height; slopes up to %.0f\n", axis,
                  reach, worst, most);
    assert_true(worst < 1e-5 && most > 5.0);
}

TEST(test_heights_and_gradients_are_those_of_the_texels)
{
    struct image_bytes image;
    char path[8192], why[IMAGE_WHY];
    snprintf(path, sizeof path, "%s/shaders/textures/cloth_height.png", gpu.root);
    assert_true(image_read_bytes(&image, path, 3, SIDE * SIDE, why));
    for (int axis = 0; axis < 3; axis++)
        for (int reach = 1; reach <= 4; reach *= 4)
            check_heights(&image, axis, reach);
    free(image.value);
}

TESTS(gpu_setup, gpu_teardown)
