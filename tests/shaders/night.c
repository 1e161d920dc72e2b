// night.c - tests of shaders/night.glsl in double precision. The light of the stars is compared
// with a sum over all stars, the phases of the moon with counts of points, and dusk with published
// values. The light of a star must stay the same while the sky turns, and the stars must be
// uniformly distributed.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/mirror.h"
#include "lib/stars.h"

#define SHADER "tests/shaders/night.frag"

// ---- Stars ----

// The graphics card evaluates four cells, and this test sums over all stars: no star may be cut off
// at the border of a cell.
TEST(test_four_cells_are_enough)
{
    // The width of a pixel, and how far from the pole the points reach; the last case is around the
    // pole.
    const float asked[][2] = {{0.0031f, 2.0f}, {0.002f, 2.0f}, {0.0056f, 2.0f}, {0.0031f, 6e-4f}};
    for (int k = 0; k < 4; k++) {
        float *values = gpu_call(SHADER, 1024, 64, 0, (const float[4]){asked[k][0], asked[k][1]});
        double worst = 0.0, peak = 0.0;
        int met = 0;
        for (int i = 0; i < 65536; i++) {
            struct d3 direction = d3_unit(d3_of(values + 4 * i));
            double truth = 1e9 * stars_light(direction, (double)asked[k][0]);
            worst = fmax(worst, fabs((double)values[4 * i + 3] - truth) / fmax(truth, 20.0));
            peak = fmax(peak, truth);
            met += truth > 0.0;
        }
        free(values);
        print_message("# width %.4f: %d of 65536 points see a star, light off by at most %.2g\n",
                      (double)asked[k][0], met, worst);
        assert_true(met > 5000 && peak > 40.0 && worst < 0.03);
    }
}

// The light that a picture receives from a patch of sky: the sum over the pixels of light times
// solid angle, weighted by a smooth window that turns with the stars.
static double patch_light(const float look[4], struct d3 middle, double reach)
{
    float *values = gpu_call(SHADER, 128, 128, 1, look);
    double sum = 0.0;
    for (int i = 0; i < 128 * 128; i++) {
        double x = (i % 128 - 63.5) * (double)look[0], y = (i / 128 - 63.5) * (double)look[0];
        double solid = (double)(look[0] * look[0]) / pow(1.0 + x * x + y * y, 1.5);
        struct d3 apart = d3_sub(d3_of(values + 4 * i), middle);
        double inside = 1.0 - d3_dot(apart, apart) / (reach * reach);
        sum += inside > 0.0 ? inside * inside * solid * 1e-9 * (double)values[4 * i + 3] : 0.0;
    }
    free(values);
    return sum;
}

// The smallest and the largest ratio of the light of a patch to its true value, in a hundred
// frames.
//   look  as for patchDirection in night.frag; each frame turns the sky by step radians
//   ends  receives the two ratios
static void light_of_frames(float look[4], double step, struct d3 middle, double reach,
                            double truth, double ends[2])
{
    ends[0] = 1e9;
    ends[1] = 0.0;
    for (int frame = 0; frame < 100; frame++) {
        look[3] = (float)step * (float)frame;
        double ratio = patch_light(look, middle, reach) / truth;
        ends[0] = fmin(ends[0], ratio);
        ends[1] = fmax(ends[1], ratio);
    }
}

static int brighter(const void *a, const void *b)
{
    double x = ((const struct star *)a)->light, y = ((const struct star *)b)->light;
    return (x < y) - (x > y);
}

TEST(test_a_star_keeps_its_light_while_the_sky_turns)
{
    static struct star star[STAR_COUNT];
    for (int i = 0; i < STAR_COUNT; i++)
        star[i] = stars_all()[i];
    qsort(star, STAR_COUNT, sizeof *star, brighter);
    for (int k = 0; k < 4; k++) { // the four brightest stars; the window is nearly flat around each
        struct d3 p = star[k].direction;
        double ends[2];
        float look[4] = {0.0028f, (float)p.z, (float)atan2(p.y, p.x)};
        light_of_frames(look, 0.000611, p, 0.03, star[k].light, ends);
        print_message("# star %d: ratio of light seen to light sent from %.4f to %.4f\n", k,
                      ends[0], ends[1]);
        assert_true(ends[0] > 0.96 && ends[1] < 1.03 && ends[1] < 1.02 * ends[0]);
    }
}

TEST(test_a_patch_keeps_its_light_while_the_sky_turns)
{
    const struct star *star = stars_all();
    static const double positions[3][2] = {{0.2, 1.0}, {-0.003, 4.0}, {0.9995, 2.0}}; // z, turn
    for (int k = 0; k < 3; k++) {
        double flat = sqrt(1.0 - positions[k][0] * positions[k][0]), truth = 0.0;
        struct d3 p = d3(flat * cos(positions[k][1]), flat * sin(positions[k][1]), positions[k][0]);
        for (int i = 0; i < STAR_COUNT; i++) {
            struct d3 apart = d3_sub(star[i].direction, p);
            double inside = 1.0 - d3_dot(apart, apart) / (0.13 * 0.13);
            truth += inside > 0.0 ? inside * inside * star[i].light : 0.0;
        }
        double ends[2];
        float look[4] = {0.0028f, (float)positions[k][0], (float)positions[k][1]};
        light_of_frames(look, 0.0003, p, 0.13, truth, ends);
        print_message("# patch at z = %.4f: ratio of light seen to light sent from %.4f to %.4f\n",
                      positions[k][0], ends[0], ends[1]);
        assert_true(ends[0] > 0.98 && ends[1] < 1.02 && ends[1] < 1.02 * ends[0]);
    }
}

// The octants of the sphere are rotated so that none of their borders coincides with the border of
// a cell.
TEST(test_every_octant_has_its_eighth)
{
    const struct star *star = stars_all();
    double sigma = sqrt(STAR_COUNT * 0.125 * 0.875), worst = 0.0;
    for (int k = 0; k < 20; k++) {
        struct d3 x = d3_unit(d3(cos(k), sin(2.0 * k), cos(3.0 * k + 1.0)));
        struct d3 y = d3_unit(d3_cross(x, d3(0.3, 0.2, 0.9))), z = d3_cross(x, y);
        int count[8] = {0};
        for (int i = 0; i < STAR_COUNT; i++) {
            struct d3 p = star[i].direction;
            count[(d3_dot(p, x) > 0.0) + 2 * (d3_dot(p, y) > 0.0) + 4 * (d3_dot(p, z) > 0.0)]++;
        }
        for (int i = 0; i < 8; i++)
            worst = fmax(worst, fabs(count[i] - STAR_COUNT / 8.0));
    }
    print_message("# octants: 4096 stars each, off by at most %.0f; 3 sigma %.0f\n", worst,
                  3.0 * sigma);
    assert_true(worst < 3.0 * sigma);
}

// The article's stars are the cubes of a grid of side 1 / 400 that the sphere meets. They are
// counted in caps with a radius of 12 degrees around an axis, the direction to the midpoint of an
// edge, and the direction to a corner.
TEST(test_cubes_crowd_towards_the_diagonal)
{
    const int side = 400;
    const struct d3 towards[3] = {d3(1.0, 0.0, 0.0), d3_unit(d3(1.0, 1.0, 0.0)),
                                  d3_unit(d3(1.0, 1.0, 1.0))};
    double cap = cos(radians(12.0)), area = 2.0 * MIRROR_PI * (1.0 - cap) * side * side;
    long count[3] = {0, 0, 0};
    for (int i = -20; i < side + 1; i++)
        for (int j = -side; j < side + 1; j++) {
            double near_x = i > 0 ? i : i < -1 ? i + 1 : 0, far_x = fmax(abs(i), abs(i + 1));
            double near_y = j > 0 ? j : j < -1 ? j + 1 : 0, far_y = fmax(abs(j), abs(j + 1));
            double near = near_x * near_x + near_y * near_y, far = far_x * far_x + far_y * far_y;
            for (int k = -side; k < side + 1; k++) {
                double near_z = k > 0 ? k : k < -1 ? k + 1 : 0, far_z = fmax(abs(k), abs(k + 1));
                double square = (double)side * side;
                if (near + near_z * near_z > square || far + far_z * far_z < square)
                    continue;
                struct d3 p = d3_unit(d3(i + 0.5, j + 0.5, k + 0.5));
                for (int c = 0; c < 3; c++)
                    count[c] += d3_dot(p, towards[c]) > cap;
            }
        }
    static const char *const around[] = {"an axis", "the middle of an edge", "a corner"};
    // The formula is the mean of |x| + |y| + |z| over each cap, here a sum over 400 x 400 points.
    for (int c = 0; c < 3; c++) {
        double sum = 0.0, weight = 0.0;
        struct d3 across = d3_unit(d3_cross(towards[c], d3(0.3, 0.5, 0.8)));
        struct d3 up = d3_cross(towards[c], across);
        for (int a = 0; a < 400; a++)
            for (int b = 0; b < 400; b++) {
                double z = 1.0 - (1.0 - cap) * (a + 0.5) / 400.0, flat = sqrt(1.0 - z * z);
                double t = 2.0 * MIRROR_PI * (b + 0.5) / 400.0;
                struct d3 p =
                    d3_add(d3_times(z, towards[c]),
                           d3_add(d3_times(flat * cos(t), across), d3_times(flat * sin(t), up)));
                sum += fabs(p.x) + fabs(p.y) + fabs(p.z);
                weight += 1.0;
            }
        print_message("# cubes per square of their side, around %s: %.3f (formula: %.3f)\n",
                      around[c], (double)count[c] / area, sum / weight);
        assert_true(fabs((double)count[c] / area / (sum / weight) - 1.0) < 0.01);
    }
    assert_true((double)count[2] / (double)count[0] > 1.40);
}

TEST(test_counts_follow_their_law)
{
    const struct star *star = stars_all();
    int count[10] = {0};
    for (int i = 0; i < STAR_COUNT; i++) {
        double magnitude = -2.5 * log10(star[i].light * 4000.0 / 2.54e-6);
        for (int m = 0; m < 10; m++)
            count[m] += magnitude < m - 1.0;
    }
    for (int m = 2; m < 9; m++) {
        double law = STAR_COUNT * pow(10.0, 0.51 * (m - 1.0 - 7.607));
        print_message("# stars brighter than magnitude %d: %d (law: %.0f)\n", m - 1, count[m], law);
        assert_true(fabs(count[m] - law) < 3.5 * sqrt(law));
    }
}

// The colours from Wien's law, relative to green, are compared with those from Planck's law at
// three temperatures that span the range of the stars' temperatures.
TEST(test_colours_are_nearly_those_of_a_black_body)
{
    for (int k = 0; k < 3; k++) {
        const double t = k == 0 ? 3300.0 : k == 1 ? 5800.0 : 14000.0, wave[3] = {0.68, 0.55, 0.44};
        double planck[3], white[3];
        for (int c = 0; c < 3; c++) {
            planck[c] = 1.0 / (exp(14388.0 / (wave[c] * t)) - 1.0);
            white[c] = 1.0 / (exp(14388.0 / (wave[c] * 6500.0)) - 1.0);
        }
        double heat = 1.0 / t - 1.0 / 6500.0;
        double red = planck[0] / planck[1] * white[1] / white[0];
        double blue = planck[2] / planck[1] * white[1] / white[2];
        print_message("# %5.0f K: red %.2f, Planck %.2f; blue %.2f, Planck %.2f\n", t,
                      exp(5001.0 * heat), red, exp(-6540.0 * heat), blue);
        assert_true(fabs(exp(5001.0 * heat) / red - 1.0) < 0.15);
        assert_true(fabs(exp(-6540.0 * heat) / blue - 1.0) < 0.15);
    }
}

// ---- The sky's turning ----

TEST(test_the_sky_turns_in_a_sidereal_day)
{
    double latitude = radians(43.6);
    struct d3 meridian = d3(-sin(latitude), cos(latitude), 0.0),
              pole = d3(cos(latitude), sin(latitude), 0.0);
    struct d3 west = d3(0.0, 0.0, -1.0), d = d3(0.36, 0.48, 0.8);
    float *values = gpu_call(SHADER, 1024, 1, 3, (const float[4]){43.6f});
    for (int i = 0; i < 1024; i++) {
        double angle = 2.0 * MIRROR_PI * ((double)values[4 * i + 3] - 12.0) / 23.9344696; // h
        struct d3 x = d3_add(d3_times(cos(angle), meridian), d3_times(sin(angle), west));
        struct d3 y = d3_sub(d3_times(sin(angle), meridian), d3_times(cos(angle), west));
        struct d3 truth = d3(d3_dot(x, d), d3_dot(y, d), d3_dot(pole, d));
        assert_true(d3_length(d3_sub(d3_of(values + 4 * i), truth)) < 2e-6);
    }
    free(values);
    double late = 24.0 * 60.0 - 23.9344696 * 60.0;
    print_message("# a star returns %.2f minutes earlier each day\n", late);
    assert_true(fabs(late - 3.93) < 0.005);
}

// The direction to the moon from its right ascension and hour angle, as in an almanac.
static struct d3 moon_at(double hour, double latitude, double declination, double age)
{
    double e = radians(23.4393), sun = asin(sin(radians(declination)) / sin(e));
    double l = sun + 2.0 * MIRROR_PI * age / 29.530589;
    double high = asin(sin(e) * sin(l)), right = atan2(cos(e) * sin(l), cos(l));
    double angle = radians(15.0 * (hour - 12.0)) + atan2(cos(e) * sin(sun), cos(sun)) - right;
    double p = radians(latitude);
    return d3(cos(p) * sin(high) - sin(p) * cos(high) * cos(angle),
              sin(p) * sin(high) + cos(p) * cos(high) * cos(angle), -cos(high) * sin(angle));
}

TEST(test_the_moon_runs_along_the_ecliptic)
{
    static const float when[4][3] = {
        {19.35f, 43.6f, 2.0f}, {3.0f, -33.0f, -20.0f}, {12.0f, 70.0f, 23.4f}, {30.0f, 0.0f, 11.0f}};
    for (int k = 0; k < 4; k++) {
        double worst = 0.0;
        float *values =
            gpu_call(SHADER, 1024, 1, 4, (const float[4]){when[k][0], when[k][1], when[k][2]});
        for (int i = 0; i < 1024; i++) {
            struct d3 truth = moon_at((double)when[k][0], (double)when[k][1], (double)when[k][2],
                                      (double)values[4 * i + 3]);
            worst = fmax(worst, d3_length(d3_sub(d3_of(values + 4 * i), truth)));
        }
        free(values);
        print_message("# moon, case %d: off by at most %.2g\n", k, worst);
        assert_true(worst < 5e-4);
    }
}

// ---- Phases ----

TEST(test_the_lit_share_is_that_of_the_cosine)
{
    double worst = 0.0;
    for (int age = 0; age < 30; age++) {
        float *values =
            gpu_call(SHADER, 1024, 1024, 7, (const float[4]){19.35f, 43.6f, 2.0f, (float)age});
        double disc = 0.0, lit = 0.0;
        for (int i = 0; i < 1024 * 1024; i++) {
            disc += (double)values[4 * i];
            lit += (double)values[4 * i + 1];
        }
        double angle = 2.0 * MIRROR_PI * age / 29.530589, truth = 0.5 - 0.5 * cos(angle);
        worst = fmax(worst, fmax(fabs(lit / disc - truth), fabs((double)values[2] - truth)));
        if (age % 5 == 0 || age == 3)
            print_message("# age %2d days: %.4f of the disc is lit, (1 + cos g) / 2 = %.4f for the "
                          "phase angle g\n",
                          age, lit / disc, truth);
        free(values);
    }
    print_message("# lit share: off by at most %.1g\n", worst);
    assert_true(worst < 1e-3);
}

// In the picture itself, the lit pixels of moonFace are those that are brighter than earthshine can
// be.
TEST(test_the_face_is_lit_on_the_side_of_the_sun)
{
    static const char text[] = GPU_COURSE
        "#include \"night.glsl\"\n"
        "uniform sampler2D moon; // \"moon.png\" linear clamp: the face\n"
        "vec3 rayColour(Ray ray) {\n"
        "    float a = 6.2831853 * iTime / 29.530589;\n"
        "    vec2 point = ray.origin.xy;\n"
        "    vec3 light = moonFace(moon, point, 0.002, vec3(sin(a), 0.0, -cos(a)), 0.0);\n"
        "    return dot(point, point) < 1.0 ? vec3(1.0, light.g > 5.2e-4, 0.0) : vec3(0.0);\n"
        "}\n";
    for (int age = 4; age < 27; age += 3) {
        assert_true(gpu_load_text(text));
        struct renderer_inputs inputs = gpu_inputs(1024, 1024, 1);
        inputs.time = (float)age;
        float *values = gpu_numbers(&inputs);
        double disc = 0.0, lit = 0.0;
        for (int i = 0; i < 1024 * 1024; i++) {
            disc += (double)values[4 * i];
            lit += (double)values[4 * i + 1];
        }
        free(values);
        double truth = 0.5 - 0.5 * cos(2.0 * MIRROR_PI * age / 29.530589);
        print_message("# age %2d days: %.4f of the face is lit, expected %.4f\n", age, lit / disc,
                      truth);
        assert_true(disc > 8e5 && fabs(lit / disc - truth) < 1e-3);
    }
}

// moonlight is the light that moonFace sends from a uniform ball with an albedo of 0.12 and the
// size of the true disc. This function gives its change with the phase, except for the factor
// exp(-0.94 phase).
static double ball_light(double phase)
{
    double sum = 0.0;
    const int n = 1200;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
            double x = (i + 0.5) * 2.0 / n - 1.0, y = (j + 0.5) * 2.0 / n - 1.0;
            double z = 1.0 - x * x - y * y;
            if (z <= 0.0)
                continue;
            z = sqrt(z);
            double m = x * sin(phase) + z * cos(phase);
            sum += m > 0.0 ? 2.0 * m / (m + z) * 4.0 / ((double)n * n) : 0.0;
        }
    return sum / MIRROR_PI; // 1 at full moon
}

TEST(test_moonlight_is_the_light_of_the_face)
{
    float *values = gpu_call(SHADER, 1024, 1, 6, (const float[4]){0.0f});
    for (int i = 100; i < 1024; i += 77) {
        double phase = acos((double)values[4 * i]);
        double truth = 25.0 * exp(-0.94 * phase) * ball_light(phase);
        assert_true(fabs((double)values[4 * i + 2] - truth) < 0.002 * truth + 0.002);
    }
    // The brightness of the whole moon according to C. W. Allen, section 66: V = -12.73 + 1.49 g +
    // 0.043 g^4.
    double worst = 0.0;
    for (int i = 0; i <= 150; i += 10) {
        double g = radians(i), allen = pow(10.0, -0.4 * (1.49 * g + 0.043 * pow(g, 4.0)));
        double ours = exp(-0.94 * g) * ball_light(g);
        worst = fmax(worst, fabs(ours / allen - 1.0));
        if (i % 30 == 0)
            print_message("# phase %3d degrees: %.4f of the full moon's light, Allen %.4f\n", i,
                          ours, allen);
    }
    print_message("# off by at most %.0f %%; a half moon gives %.1f %% of the full moon's light\n",
                  100.0 * worst, 100.0 * exp(-0.94 * radians(90.0)) * ball_light(radians(90.0)));
    assert_true(worst < 0.12);
    // To convert to lux, multiply by pi and by 4000 cd/m2, the unit of light.
    double lux = 2.5e-5 * MIRROR_PI * 4000.0, allen = 2.54e-6 * pow(10.0, 0.4 * 12.73);
    print_message("# full moon: %.3f lx above the air, %.3f lx from Allen's magnitude\n", lux,
                  allen);
    assert_true(fabs(lux / allen - 1.0) < 0.03);
    free(values);
}

// ---- Dusk ----

TEST(test_dusk_is_as_bright_as_measured)
{
    float *values = gpu_call(SHADER, 1024, 1, 5, (const float[4]){0.0f});
    double before = 0.0;
    for (int i = 0; i < 1024; i++) {
        double depth = -degrees(asin((double)values[4 * i])), d = depth - 5.0;
        double light = 1e-6 * (double)values[4 * i + 1];
        if (d >= 0.0 && d <= 10.0) { // Patat and others, table 1, V; magnitude 0 is 108,000 cd/m2
            double patat = 1.08e5 / 4000.0 * pow(10.0, -0.4 * (11.84 + 1.518 * d - 0.057 * d * d));
            assert_true(fabs(light / patat - 1.0) < 1e-3);
        }
        assert_true(light >= before * (1.0 - 1e-5)); // the light never decreases as the sun rises
        before = light;
        double magnitude = -2.5 * log10(light / 27.0);
        double seen = 7.93 - 5.0 * log10(1.0 + pow(10.0, 4.316 - magnitude / 5.0));
        assert_true(fabs((double)values[4 * i + 2] - seen) < 2e-4);
    }
    free(values);
    // Print the table of docs/19_moon_and_stars.md.
    values = gpu_call(SHADER, 19, 1, 5, (const float[4]){1.0f});
    for (int depth = 0; depth <= 18; depth += 3) {
        const float *v = values + 4 * depth;
        print_message("# sun %2d degrees down: %.3g cd/m2, faintest star %.1f\n", depth,
                      4e-3 * (double)v[1], (double)v[2]);
    }
    free(values);
}

TESTS(gpu_setup, gpu_teardown)
