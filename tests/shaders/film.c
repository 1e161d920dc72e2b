// film.c - tests of shaders/film.glsl: the vignette compared with the light behind a small opening
// by brute force, the fixed points and slopes of the curves, the hue, the mean of a dithered
// colour, and the punch of chapter 15.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

#define SHADER  "tests/shaders/film.frag"
#define CHAPTER "15_the_picture"

enum { VIGNETTE, CONTRAST, CURVE, HUE, DITHER };

// The light, up to a constant factor, that a uniformly bright wall sends through a round opening of
// radius r to a point of the film, at a distance f behind the opening. Each element of the opening
// contributes the product of the cosines at both ends of the line from the element to the point,
// divided by the square of the length of this line.
static double through_opening(double x, double y, double f, double r)
{
    double sum = 0.0;
    for (int i = 0; i < 64; i++)
        for (int j = 0; j < 64; j++) {
            double a = (2.0 * i + 1.0) / 64.0 - 1.0, b = (2.0 * j + 1.0) / 64.0 - 1.0;
            if (a * a + b * b > 1.0)
                continue;
            struct d3 way = d3(x - r * a, y - r * b, f);
            double square = d3_dot(way, way), cosine = f / sqrt(square);
            sum += cosine * cosine / square;
        }
    return sum;
}

TEST(the_light_falls_off_as_the_fourth_power_of_the_cosine)
{
    for (float focal = 0.5f; focal < 5.0f; focal *= 2.0f) {
        const float numbers[4] = {focal};
        double f = (double)focal, r = 1e-3 * f, middle = through_opening(0.0, 0.0, f, r),
               worst = 0.0;
        float *values = gpu_call(SHADER, 41, 21, VIGNETTE, numbers);
        for (int i = 0; i < 41 * 21; i += 7) {
            const float *v = values + 4 * i;
            double right = through_opening((double)v[0], (double)v[1], f, r) / middle;
            worst = fmax(worst, fabs((double)v[2] / right - 1.0));
        }
        free(values);
        print_message("# focal length %g: worst relative error %.2g\n", f, worst);
        assert_true(worst < 1e-5);
    }
}

TEST(contrast_is_steepest_in_the_middle)
{
    for (float amount = 0.0f; amount <= 1.0f; amount += 0.25f) {
        const float numbers[4] = {amount};
        float *values = gpu_call(SHADER, 385, 1, CONTRAST, numbers);
        const float *v = values + 4 * 64; // v = 0
        assert_true(v[1] == 0.0f && v[4 * 256 + 1] == 1.0f && values[1] == 0.0f);
        assert_true(fabs((double)v[4 * 128 + 1] - 0.5) < 1e-6);
        double middle = 128.0 * ((double)v[4 * 129 + 1] - (double)v[4 * 127 + 1]);
        double end = 256.0 * ((double)v[5] - (double)v[1]);
        assert_true(fabs(middle - (1.0 + 0.5 * (double)amount)) < 1e-4);
        assert_true(fabs(end - (1.0 - (double)amount)) < 0.012);
        for (int i = 1; i < 385; i++)
            assert_true(values[4 * i + 1] >= values[4 * i - 3]);
        for (int i = 0; i < 385; i++) // the shader also returns a light of 0.3, exposed by v stops
            assert_true(fabs((double)values[4 * i + 2] - 0.3 * exp2((double)values[4 * i])) < 1e-6);
        free(values);
    }
}

TEST(the_film_keeps_grey_and_reaches_white)
{
    static const double gammas[] = {1.0, 1.25, 2.0, 3.0}, whites[] = {1.5, 8.0, 64.0};
    for (int i = 0; i < 12; i++) {
        double gamma = gammas[i % 4], white = whites[i / 4];
        const float numbers[4] = {(float)gamma, (float)white};
        float *values = gpu_call(SHADER, 400, 1, CURVE, numbers);
        double slope = 0.0, steepest = 0.0, grey = log2(0.18);
        for (int j = 0; j < 400; j++) {
            const float *v = values + 4 * j;
            double x = (double)v[0];
            assert_true(fabs((double)v[2] - 0.18) < 1e-5 && (double)v[3] < 1e-4);
            assert_true(x < white || fabs((double)v[1] - 1.0) < 1e-5);
            if (j == 0)
                continue;
            assert_true(v[1] >= v[-3]);
            double rise = 16.0 * (log2((double)v[1]) - log2((double)v[-3]));
            if (log2(x) > grey && log2(x) - 1.0 / 16.0 <= grey)
                slope = rise;
            steepest = fmax(steepest, rise);
        }
        double right = gamma * 0.82 / (1.0 - pow(0.18 / white, gamma));
        free(values);
        print_message("# gamma %g, white %g: slope at grey %.3f\n", gamma, white, slope);
        assert_true(fabs(slope / right - 1.0) < 0.02 && steepest < gamma * 1.01 + 0.01);
    }
}

// Applied to the largest channel, the curve keeps the ratios of the channels; applied to each
// channel, it brings them closer together.
TEST(the_largest_channel_keeps_the_hue)
{
    const float numbers[4] = {1.25f, 8.0f};
    float *values = gpu_call(SHADER, 36, 2, HUE, numbers);
    for (int i = 0; i < 36; i++) {
        const float *one = values + 4 * i, *each = values + 4 * (36 + i);
        assert_true(fabs((double)one[1] / (double)one[0] - 0.4) < 1e-5);
        assert_true(fabs((double)one[2] / (double)one[0] - 0.05) < 1e-5);
        assert_true(fabs((double)one[0] / (double)each[0] - 1.0) < 1e-5);
        assert_true(each[3] < 1.0f || (double)each[1] / (double)each[0] > 0.45);
        for (int k = 0; k < 3; k++)
            assert_true(one[k] <= 1.0f + 1e-6f || one[3] > 8.0f);
    }
    free(values);
}

TEST(a_dither_has_each_step_once)
{
    const float none[4] = {0.0f};
    float *values = gpu_call(SHADER, 32, 24, DITHER, none);
    for (int block = 0; block < 12; block++) {
        int seen[64] = {0};
        double sum = 0.0;
        for (int i = 0; i < 64; i++) {
            int x = 8 * (block % 4) + i % 8, y = 8 * (block / 4) + i / 8;
            double step = (double)values[4 * (32 * y + x)];
            int k = (int)floor(64.0 * (step + 0.5));
            assert_true(k >= 0 && k < 64 && seen[k]++ == 0);
            sum += step;
        }
        assert_true(fabs(sum) < 1e-6);
    }
    // For every colour, the mean of 8 x 8 rounded pixels is within 1/128 of a step of the colour.
    double worst = 0.0, undithered = 0.0;
    for (int n = 0; n < 1000; n++) {
        double colour = 20.0 + n / 333.0, mean = 0.0;
        for (int i = 0; i < 64; i++)
            mean += floor(colour + (double)values[4 * (32 * (i / 8) + i % 8)] + 0.5) / 64.0;
        worst = fmax(worst, fabs(mean - colour));
        undithered = fmax(undithered, fabs(floor(colour + 0.5) - colour));
    }
    free(values);
    print_message("# mean of 8 x 8 pixels: off by at most %.4f steps; without dither %.3f\n", worst,
                  undithered);
    assert_true(worst <= 1.0 / 128.0 + 1e-6 && undithered > 0.49);
}

// The colours of chapter 15's picture with one parameter set and without dithering, before they are
// rounded. The caller frees them.
static float *picture_with(const char *setting)
{
    struct renderer_inputs inputs = {.width = 80, .height = 45, .samples = 1};
    inputs.camera = gpu_open_chapter(CHAPTER);
    assert_true(parameters_assign(&gpu.renderer.parameters, "dither=false"));
    assert_true(parameters_assign(&gpu.renderer.parameters, setting));
    return gpu_numbers(&inputs);
}

// With punch = 1, a smoothstep is applied to the encoded values, not to the light.
TEST(punch_is_a_contrast_of_encoded_values)
{
    float *plain = picture_with("punch=0"), *punched = picture_with("punch=1");
    for (int i = 0; i < 80 * 45; i++)
        for (int k = 0; k < 3; k++) {
            double v = (double)plain[4 * i + k], right = v * v * (3.0 - 2.0 * v);
            assert_true(fabs((double)punched[4 * i + k] - right) < 1e-5);
        }
    free(plain);
    free(punched);
}

TESTS(gpu_setup, gpu_teardown)
