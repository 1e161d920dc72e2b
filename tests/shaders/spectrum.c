// spectrum.c - shaders/spectrum.glsl and prism.glsl: colours that sum to white, Cauchy's formula,
// the minimum deviation compared with rays traced through a prism, the plan of a ray that rises,
// and the rainbow.
#include "lib/test.h"
#include "lib/glass.h"
#include "lib/gpu.h"

#define SHADER "tests/shaders/glass.frag"

enum { COLOUR = 5, PRISM, ABSORBED, WAVES, BEAM = 10 };

static const double degree = MIRROR_PI / 180.0;

// ---- Colours ----

TEST(all_wavelengths_are_white)
{
    const float none[4] = {0.0f};
    float *values = gpu_call(SHADER, 512, 1, COLOUR, none);
    double mean[3] = {0.0, 0.0, 0.0}, worst = 0.0, truth[3];
    for (int i = 0; i < 512; i++) {
        glass_wave_colour((double)values[4 * i + 3], truth);
        for (int c = 0; c < 3; c++) {
            assert_true(values[4 * i + c] >= 0.0f);
            mean[c] += (double)values[4 * i + c] / 512.0;
            worst = fmax(worst, fabs((double)values[4 * i + c] - truth[c]));
        }
    }
    free(values);
    print_message("# mean %.5f %.5f %.5f; worst error %.3f\n", mean[0], mean[1], mean[2], worst);
    for (int c = 0; c < 3; c++)
        assert_true(fabs(mean[c] - 1.0) < 1e-4);
    assert_true(worst < 0.4); // the stated error of the fit
}

TEST(the_whole_spectrum_is_white_and_light_beyond_it_is_black)
{
    const float all[4] = {0.40f, 0.70f, 4.0f, 0.5f}, none[4] = {0.71f, 0.9f, 1.0f, 0.5f};
    float *values = gpu_call(SHADER, 4, 1, WAVES, all);
    for (int c = 0; c < 3; c++)
        assert_true(fabs((double)values[c] - 1.0) < 0.02);
    for (int k = 0; k < 4; k++) // the middles of four equal parts
        assert_true(fabs((double)values[4 * k + 3] - (0.4375 + 0.075 * k)) < 1e-6);
    free(values);
    values = gpu_call(SHADER, 1, 1, WAVES, none);
    assert_true(values[0] == 0.0f && values[1] == 0.0f && values[2] == 0.0f);
    assert_true(fabs((double)values[3] - 0.55) < 1e-6);
    free(values);
}

TEST(cauchy_wave_inverts_cauchy_index)
{
    const float none[4] = {0.0f};
    float *values = gpu_call(SHADER, 301, 1, ABSORBED, none);
    for (int i = 0; i < 301; i++)
        assert_true(fabs((double)values[4 * i + 3] - (0.4 + 0.001 * i)) < 2e-5);
    free(values);
}

// Sellmeier's formula for six numbers of a glass. Those of BK7 and SF10 are the maker's (Schott's
// catalogue).
static double sellmeier(const double number[6], double wavelength)
{
    double square = wavelength * wavelength, sum = 1.0;
    for (int k = 0; k < 3; k++)
        sum += number[k] * square / (square - number[3 + k]);
    return sqrt(sum);
}

// Cauchy's formula with two numbers for each glass. It is accurate between the lines F and C, at
// 0.4861 and 0.6563 micrometres; over all visible light, it is off by as much as docs/17_glass.md
// says.
TEST(cauchy_is_near_sellmeier)
{
    static const double crown[6] = {1.03961212,    0.231792344,  1.01046945,
                                    0.00600069867, 0.0200179144, 103.560653};
    static const double flint[6] = {1.61625977,   0.259229334,  1.07762317,
                                    0.0127534559, 0.0581983954, 116.60768};
    double worst[2][2] = {{0.0, 0.0}, {0.0, 0.0}};
    for (int i = 0; i <= 300; i++) {
        double wave = 0.40 + 0.001 * i;
        double off[2] = {fabs(glass_index(1.5046, 0.0042, wave) - sellmeier(crown, wave)),
                         fabs(glass_index(1.6894, 0.01341, wave) - sellmeier(flint, wave))};
        for (int k = 0; k < 2; k++) {
            worst[k][0] = fmax(worst[k][0], off[k]);
            worst[k][1] = wave > 0.4861 && wave < 0.6563 ? fmax(worst[k][1], off[k]) : worst[k][1];
        }
    }
    print_message(
        "# Cauchy's formula off by at most: BK7 %.5f, F to C %.5f; SF10 %.5f, F to C %.5f\n",
        worst[0][0], worst[0][1], worst[1][0], worst[1][1]);
    assert_true(worst[0][0] < 1.2e-4 && worst[0][1] < 5e-5);
    assert_true(worst[1][0] < 5.1e-3 && worst[1][0] > 5.0e-3 && worst[1][1] < 4e-4);
    // At the yellow line, at 0.5876 micrometres, the index of SF10 is 1.7283; with 1.7280 as the
    // number A, it would be 1.767.
    assert_true(fabs(sellmeier(flint, 0.5876) - 1.7283) < 1e-4);
    assert_true(fabs(glass_index(1.7280, 0.01342, 0.5876) - 1.767) < 5e-4);
}

// ---- The prism ----

// Trace a ray through two planes in space. Returns its deflection in radians, or a negative number
// if no ray leaves.
//   entering  angle to the first normal, on the side away from the edge
//   rise      angle out of the plane perpendicular to the edge
//   left      receives the direction in which the ray leaves
static double traced(double apex, double index, double entering, double rise, struct d3 *left)
{
    struct d3 first = d3(-cos(0.5 * apex), sin(0.5 * apex), 0.0);
    struct d3 second = d3(cos(0.5 * apex), sin(0.5 * apex), 0.0);
    struct d3 rising = d3(sin(0.5 * apex), cos(0.5 * apex), 0.0), inside;
    struct d3 plan = d3_sub(d3_times(sin(entering), rising), d3_times(cos(entering), first));
    struct d3 d = d3(plan.x * cos(rise), plan.y * cos(rise), sin(rise));
    if (!glass_refract(d, first, 1.0 / index, &inside) || d3_dot(inside, second) <= 0.0 ||
        !glass_refract(inside, d3_times(-1.0, second), index, left))
        return -1.0;
    return d3_angle(d, *left) * degree;
}

TEST(a_ray_through_a_prism_leaves_where_stated)
{
    const double apex = 60.0 * degree;
    const float numbers[4] = {(float)apex};
    float *values = gpu_call(SHADER, 256, 16, PRISM, numbers);
    int total = 0, through = 0;
    for (int i = 0; i < 256 * 16; i++) {
        double entering = -0.4 + 1.9 * (i % 256) / 255.0, index = 1.1 + 0.4 * (i / 256) / 15.0;
        struct d3 left = {0.0, 0.0, 0.0};
        bool leaves = traced(apex, index, entering, 0.0, &left) >= 0.0;
        double sine = (double)values[4 * i];
        if (fabs(sine - 1.0) < 1e-4)
            continue;
        assert_true(leaves == (sine < 1.0));
        total += !leaves;
        through += leaves;
        // prismIndex inverts prismLeaving.
        assert_true(fabs((double)values[4 * i + 1] - index) < 1e-4);
        struct d3 falling = d3(sin(0.5 * apex), -cos(0.5 * apex), 0.0);
        assert_true(!leaves || fabs(d3_dot(left, falling) - sine) < 1e-5);
    }
    free(values);
    assert_true(total > 500 && through > 1500);
}

// The minimum over many traced rays, for four prisms, one of them of the chapter's glass.
TEST(the_least_deviation_is_symmetric)
{
    static const double cases[][2] = {{60.0, 1.5}, {30.0, 1.5}, {60.0, 1.7283}, {45.0, 1.333}};
    for (int k = 0; k < 4; k++) {
        double apex = cases[k][0] * degree, index = cases[k][1], least = 10.0, at = 0.0;
        for (double a = 0.0; a < 90.0; a += 0.002) {
            struct d3 left = {0.0, 0.0, 0.0};
            double turn = traced(apex, index, a * degree, 0.0, &left);
            at = turn >= 0.0 && turn < least ? a : at;
            least = turn >= 0.0 && turn < least ? turn : least;
        }
        double formula = 2.0 * asin(index * sin(0.5 * apex)) - apex;
        print_message("# apex %g, index %g: least deviation %.4f at %.2f degrees (formula: %.4f)\n",
                      cases[k][0], index, least / degree, at, formula / degree);
        assert_true(fabs(least - formula) < 1e-8);
        assert_true(fabs(at - asin(index * sin(0.5 * apex)) / degree) < 0.05);
    }
    const float numbers[4] = {(float)(60.0 * degree)};
    float *values = gpu_call(SHADER, 1, 16, PRISM, numbers);
    for (int i = 0; i < 16; i++) {
        double index = 1.1 + 0.4 * i / 15.0;
        assert_true(fabs((double)values[4 * i + 2] - (2.0 * asin(0.5 * index) - 60.0 * degree)) <
                    1e-3);
    }
    free(values);
}

// The plan of a ray that rises obeys Snell's law with a modified index, and the ray leaves with the
// same rise.
TEST(the_plan_of_a_rising_ray_has_its_own_index)
{
    const double apex = 60.0 * degree, rise = 0.3;
    const float numbers[4] = {(float)apex, (float)rise};
    float *values = gpu_call(SHADER, 1, 16, PRISM, numbers);
    for (int i = 0; i < 16; i++) {
        double index = 1.1 + 0.4 * i / 15.0,
               plan = sqrt((index * index - rise * rise) / (1.0 - rise * rise));
        struct d3 flat = {0.0, 0.0, 0.0}, risen = {0.0, 0.0, 0.0};
        assert_true(fabs((double)values[4 * i + 3] - plan) < 1e-5);
        if (traced(apex, plan, 0.9, 0.0, &flat) < 0.0)
            continue;
        assert_true(traced(apex, index, 0.9, asin(rise), &risen) >= 0.0);
        assert_true(fabs(risen.z - rise) < 1e-12);
        assert_true(d3_angle(flat, d3(risen.x, risen.y, 0.0)) < 1e-6);
    }
    free(values);
}

// At a point behind the prism through which a traced ray of one wavelength passes, the beam
// contains this wavelength.
TEST(the_beam_has_the_colours_of_traced_rays)
{
    const double apex = 60.0 * degree, rise = 0.14, radius = 0.32, narrow = 0.001;
    double green = glass_index(1.6894, 0.01341, 0.55), worst = 0.0;
    double entering = asin(0.5 * sqrt((green * green - rise * rise) / (1.0 - rise * rise)));
    for (int i = 0; i <= 6; i++)
        for (int far = 1; far <= 3; far++) {
            double wave = 0.42 + 0.04 * i, index = glass_index(1.6894, 0.01341, wave);
            struct d3 left = {0.0, 0.0, 0.0}, first = d3(-cos(0.5 * apex), 0.5, 0.0),
                      second = d3(cos(0.5 * apex), 0.5, 0.0);
            assert_true(traced(apex, index, entering, -asin(rise), &left) >= 0.0);
            // Inside, the ray goes from the midpoint of the first side to the second.
            struct d3 plan, inside;
            plan = d3_sub(d3_times(sin(entering), d3(0.5, cos(0.5 * apex), 0.0)),
                          d3_times(cos(entering), first));
            struct d3 d = d3_add(d3_times(sqrt(1.0 - rise * rise), plan), d3(0.0, 0.0, -rise));
            assert_true(glass_refract(d, first, 1.0 / index, &inside));
            struct d3 start = d3_times(radius, first);
            double way = (radius - d3_dot(start, second)) / d3_dot(inside, second);
            struct d3 at = d3_add(d3_add(start, d3_times(way, inside)), d3_times(0.7 * far, left));
            const float numbers[4] = {(float)at.x, (float)at.y, (float)rise, (float)narrow};
            float *values = gpu_call(SHADER, 1, 1, BEAM, numbers);
            double a = fmin((double)values[1], (double)values[2]),
                   b = fmax((double)values[1], (double)values[2]);
            free(values);
            assert_true(a < wave && wave < b);
            worst = fmax(worst, fabs(0.5 * (a + b) - wave));
        }
    print_message("# colours: wavelength off by at most %.4f micrometres\n", worst);
    assert_true(worst < 0.0005);
}

// ---- The rainbow ----

// A ray is reflected once in a drop. Where its deflection is smallest, light is concentrated.
TEST(the_rainbow_is_at_42_degrees)
{
    double red = glass_index(1.3240, 0.00310, 0.65), violet = glass_index(1.3240, 0.00310, 0.41);
    double least[2] = {10.0, 10.0};
    const double index[2] = {red, violet};
    for (int k = 0; k < 2; k++) {
        for (double b = 0.0; b < 1.0; b += 1e-5)
            least[k] = fmin(least[k], glass_drop_turn(b, index[k], 1));
        double cosine = sqrt((index[k] * index[k] - 1.0) / 3.0),
               offset = sqrt(1.0 - cosine * cosine);
        assert_true(fabs(glass_drop_turn(offset, index[k], 1) - least[k]) < 1e-9);
    }
    double outer = 180.0 - least[0] / degree, inner = 180.0 - least[1] / degree;
    print_message("# red at %.2f, violet at %.2f degrees\n", outer, inner);
    assert_true(fabs(outer - 42.4) < 0.3 && fabs(inner - 40.6) < 0.3);
    // The rainbow of two reflections is outside the first, with its colours in reverse order.
    double second[2] = {10.0, 10.0};
    for (int k = 0; k < 2; k++)
        for (double b = 0.0; b < 1.0; b += 1e-5)
            second[k] = fmin(second[k], glass_drop_turn(b, index[k], 2) - MIRROR_PI);
    assert_true(fabs(second[0] / degree - 50.4) < 0.3 && second[1] > second[0]);
}

TESTS(gpu_setup, gpu_teardown)
