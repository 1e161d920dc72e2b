// gloss.c - the highlights of shaders/gloss.glsl compared with their sources' formulas in double
// precision, and the share of the light that each sends back, which is never more than 1.
#include "lib/test.h"
#include "lib/gloss.h"
#include "lib/gpu.h"

enum { COLUMNS = 1024, ROWS = 256 };

static const double cosines[] = {0.1, 0.3, 0.6, 0.95};
static const double roughnesses[] = {0.3, 0.5, 0.75, 1.0};

static float *values_of(int model, double cosine, double parameter)
{
    const float numbers[4] = {(float)cosine, (float)parameter, ROWS, 0.0f};
    return gpu_call("tests/shaders/gloss.frag", COLUMNS, ROWS, model, numbers);
}

static struct d3 light_of(int x, int y)
{
    double c = (y + 0.5) / ROWS, s = sqrt(1.0 - c * c),
           turn = 2.0 * MIRROR_PI * (x + 0.5) / COLUMNS;
    return d3(s * cos(turn), s * sin(turn), c);
}

// Compare the highlight for each direction of light with the source's formula. Then compare the
// light sent back, a plain sum of the GPU's values over the hemisphere, with the integral in double
// precision.
static void check(int number, gloss_model *model, double cosine, double roughness)
{
    double parameter = number == 0 ? roughness : gloss_exponent(roughness);
    double eye_cosine = (double)(float)cosine, sum = 0.0, worst = 0.0;
    parameter = (double)(float)parameter;
    struct d3 eye = gloss_eye(eye_cosine);
    float *values = values_of(number, cosine, parameter);
    for (int y = 0; y < ROWS; y++)
        for (int x = 0; x < COLUMNS; x++) {
            const float *v = values + 4 * (y * COLUMNS + x);
            struct d3 light = light_of(x, y);
            double truth = model(light, eye, parameter);
            worst = fmax(worst, fabs((double)v[0] - truth) / (0.01 + truth));
            sum += (double)v[0] * light.z * 2.0 * MIRROR_PI / (ROWS * (double)COLUMNS);
            assert_true(v[1] == 0.0f); // no highlight from a light behind the surface
        }
    free(values);
    double albedo = gloss_albedo(model, parameter, roughness, eye_cosine);
    print_message("# model %d, cosine %.2f, roughness %.2f: sends back %.4f, in double precision "
                  "%.4f; worst error %.2g\n",
                  number, cosine, roughness, sum, albedo, worst);
    // The first tolerance covers the rounding error of a cosine near 1, multiplied by the exponent;
    // the second covers the error of a sum over a grid.
    assert_true(worst < 1e-4);
    assert_true(fabs(sum - albedo) < 1e-3);
    assert_true(sum <= 1.0 + 1e-3 && albedo <= 1.0 + 1e-3);
}

TEST(test_highlights_and_their_energy_agree_with_double)
{
    for (size_t i = 0; i < sizeof cosines / sizeof cosines[0]; i++)
        for (size_t k = 0; k < sizeof roughnesses / sizeof roughnesses[0]; k++) {
            check(0, gloss_ggx, cosines[i], roughnesses[k]);
            check(1, gloss_blinn_phong, cosines[i], roughnesses[k]);
        }
}

// No light reaches an eye that is in the surface's plane or behind it.
TEST(test_an_eye_behind_the_surface_sees_no_highlight)
{
    static const double behind[] = {0.0, -0.01, -0.3, -1.0};
    for (size_t i = 0; i < sizeof behind / sizeof behind[0]; i++) {
        float *values = values_of(0, behind[i], 0.75);
        for (int k = 0; k < COLUMNS * ROWS; k++)
            assert_true(values[4 * k] == 0.0f && values[4 * k + 1] == 0.0f);
        free(values);
    }
}

// gloss_albedo, whose half vectors are distributed like the highlight, is compared with a plain sum
// over the hemisphere.
TEST(test_the_integral_is_the_sum)
{
    enum { SIDE = 1000 };
    for (double roughness = 0.2; roughness < 0.7; roughness += 0.1)
        for (double cosine = 0.1; cosine < 0.6; cosine += 0.2) {
            struct d3 eye = gloss_eye(cosine);
            double sum = 0.0, albedo = gloss_albedo(gloss_ggx, roughness, roughness, cosine);
            for (int i = 0; i < SIDE * SIDE; i++) {
                double c = (i % SIDE + 0.5) / SIDE, s = sqrt(1.0 - c * c);
                double turn = MIRROR_PI * (i / SIDE + 0.5) / SIDE;
                sum += gloss_ggx(d3(s * cos(turn), s * sin(turn), c), eye, roughness) * c;
            }
            sum *= 2.0 * MIRROR_PI / SIDE / SIDE;
            print_message("# roughness %.1f, cosine %.1f: integral %.5f, sum %.5f\n", roughness,
                          cosine, albedo, sum);
            assert_true(fabs(sum - albedo) < 1e-4);
        }
}

// On a grid of roughnesses and of cosines to the eye, no model sends back more light than arrives.
// The projected areas of the tiny mirrors that GGX assumes add up to 1.
TEST(test_no_model_creates_light)
{
    double most[2] = {0.0, 0.0};
    for (double roughness = 0.1; roughness < 1.01; roughness += 0.15)
        for (double cosine = 0.05; cosine < 1.01; cosine += 0.19) {
            double c = fmin(cosine, 1.0), r = fmin(roughness, 1.0);
            most[0] = fmax(most[0], gloss_albedo(gloss_ggx, r, r, c));
            most[1] = fmax(most[1], gloss_albedo(gloss_blinn_phong, gloss_exponent(r), r, c));
        }
    print_message("# largest share sent back: GGX %.5f, Blinn-Phong %.5f\n", most[0], most[1]);
    assert_true(most[0] <= 1.0 + 1e-3 && most[1] <= 1.0 + 1e-3);
    float *values = values_of(0, 0.6, 0.8);
    double area = 0.0;
    for (int y = 0; y < ROWS; y++)
        area += (double)values[4 * y * COLUMNS + 2] * (y + 0.5) / ROWS * 2.0 * MIRROR_PI / ROWS;
    free(values);
    assert_true(fabs(area - 1.0) < 1e-3);
}

// As docs/11_materials.md says, with the usual factor (n + 8) / (8 pi) a surface can send back more
// light than arrives. With the library's factor, it sends back exactly as much light as arrives
// if the light arrives along the normal.
TEST(test_the_usual_factor_creates_light)
{
    double usual = 0.0, at = 0.0;
    for (double n = 1.0; n < 60.0; n += 1.0) {
        double r = pow(2.0 / (n + 2.0), 0.25), albedo = gloss_albedo(gloss_usual, n, r, 1.0);
        if (albedo > usual) {
            usual = albedo;
            at = n;
        }
    }
    print_message("# (n + 8) / (8 pi) sends back up to %.4f, at n = %g\n", usual, at);
    assert_true(usual > 1.05 && usual < 1.09);
    assert_true(fabs(gloss_albedo(gloss_blinn_phong, 10.0, pow(2.0 / 12.0, 0.25), 1.0) - 1.0) <
                1e-3);
}

// In chapter 11, a ray that leaves the upper half of the silver ball meets the silver nowhere. The
// numbers are half the side of a pixel on the ball, in thousandths of a scene unit: of pictures 360
// and 1080 pixels high, and of one without limit.
TEST(test_the_silver_does_not_reflect_itself)
{
    static const int half_sides[] = {7, 2, 0};
    for (size_t i = 0; i < sizeof half_sides / sizeof half_sides[0]; i++) {
        float *values = gpu_call("tests/shaders/silver.frag", COLUMNS, ROWS, half_sides[i],
                                 (const float[4]){0.0f});
        int silver = 0, other = 0;
        for (int k = 0; k < COLUMNS * ROWS; k++) {
            silver += values[4 * k] != 0.0f;
            other += values[4 * k + 1] != 0.0f;
        }
        free(values);
        print_message("# half side %d: of %d rays, %d meet the silver and %d something else\n",
                      half_sides[i], COLUMNS * ROWS, silver, other);
        assert_true(silver == 0 && other > COLUMNS * ROWS / 8);
    }
}

TESTS(gpu_setup, gpu_teardown)
