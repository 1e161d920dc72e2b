// sky.c - chapter 09's air, sun and city compared with double precision: with exact values, with
// geometry, and with brute force over the towers of nine by nine blocks.
#include "lib/test.h"
#include "lib/city.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

static float *sky(int function, int rows, float x, float y)
{
    return gpu_call("tests/shaders/sky.frag", 1024, rows, function, (const float[4]){x, y});
}

// The length of a ray from the ground through a shell of uniform density, in thicknesses of the
// shell, in double precision. It follows from the cosine rule in the triangle of the Earth's
// centre, the observer and the point where the ray leaves the shell.
static double shell_way(double s, double earth)
{
    double b = earth * fmax(s, 0.0);
    return sqrt(b * b + 2.0 * earth + 1.0) - b;
}

static double mass_at(double height)
{
    return shell_way(sin(height * MIRROR_PI / 180.0), 721.5);
}

TEST(test_air_mass_and_transmittance_agree_with_double)
{
    float *values = sky(0, 1, 0.0f, 0.0f);
    double worst = 0.0;
    for (int i = 0; i < 1024; i++) {
        const float *v = values + 4 * i;
        double mass = shell_way((double)v[0], 721.5);
        worst = fmax(worst, fabs((double)v[1] / mass - 1.0));
        assert_true(fabs((double)v[2] - exp(-0.04 * mass)) < 2e-6);
        assert_true(fabs((double)v[3] - exp(-0.25 * mass)) < 2e-6);
        assert_true(i == 0 || v[1] <= v[-3]);
    }
    assert_true(fabs((double)values[4 * 1023 + 1] - 1.0) < 1e-6);
    assert_true(fabs((double)values[4 * 512 + 1] - 38.0) < 1e-5);
    free(values);
    print_message("# air mass: worst relative error %.2g\n", worst);
    assert_true(worst < 1e-6);
}

// F. Kasten, A. T. Young, 'Revised optical air mass tables', Applied Optics 28 (1989): a fit,
// accurate to within 0.1 %, to the air mass of a model atmosphere that refracts the rays. The
// height is the apparent height of the sun.
static double kasten_young(double height)
{
    return 1.0 / (sin(height * MIRROR_PI / 180.0) + 0.50572 * pow(height + 6.07995, -1.6364));
}

TEST(test_air_mass_is_near_the_measured_one)
{
    double worst = 0.0, at = 0.0;
    for (double height = 0.0; height <= 90.0; height += 0.002) {
        double ratio = mass_at(height) / kasten_young(height);
        if (fabs(ratio - 1.0) > worst) {
            worst = fabs(ratio - 1.0);
            at = height;
        }
    }
    print_message(
        "# uniform shell compared with Kasten and Young: off by at most %.2f %%, at %.2f degrees\n",
        100.0 * worst, at);
    for (int h = 0; h <= 90; h += h < 30 ? 5 : 30)
        print_message("# height %2d: shell %.2f, Kasten and Young %.2f\n", h, mass_at(h),
                      kasten_young(h));
    assert_true(fabs(worst - 0.0502) < 5e-5 && fabs(at - 1.83) < 0.006);
}

// The integral of the sky's light assumes that a slanting path is the same multiple of the vertical
// path at every height. In the shell, a horizontal ray has passed half of its air when it has risen
// through a quarter of the shell.
TEST(test_flat_layers_and_the_shell_differ_along_a_level_ray)
{
    double risen = sqrt(pow(721.5 + 0.25, 2.0) - pow(721.5, 2.0)), assumed = 0.25 * mass_at(0.0);
    print_message(
        "# a level ray that has risen through a quarter of the air: %.1f air masses in the shell, "
        "%.1f according to the assumption\n",
        risen, assumed);
    assert_true(fabs(risen - 19.0) < 0.05 && fabs(assumed - 9.5) < 0.05);
}

// Hansen and Travis (1974), section 2.1: the optical depth of the air above sea level. The
// wavelength is in micrometres.
static double air_depth(double wavelength)
{
    double x = 1.0 / (wavelength * wavelength);
    return 0.008569 * x * x * (1.0 + 0.0113 * x + 0.00013 * x * x);
}

TEST(test_the_depths_are_near_the_corrected_fourth_power)
{
    double red = 0.1 * pow(550.0 / 680.0, 4.0), blue = 0.1 * pow(550.0 / 440.0, 4.0);
    double power = -log(air_depth(0.5501) / air_depth(0.5499)) / log(0.5501 / 0.5499);
    print_message(
        "# fourth power: %.3f 0.1 %.3f, blue : red %.2f; Hansen and Travis: %.3f %.3f %.3f, blue : "
        "red %.2f, power %.2f at 550 nm; the shader's blue : red is 6.25\n",
        red, blue, blue / red, air_depth(0.68), air_depth(0.55), air_depth(0.44),
        air_depth(0.44) / air_depth(0.68), power);
    assert_true(fabs(red - 0.043) < 5e-4 && fabs(blue - 0.244) < 5e-4);
    assert_true(fabs(blue / red - 5.70) < 0.005 && fabs(power - 4.08) < 0.005);
    const double code[3] = {0.04, 0.1, 0.25}, wave[3] = {0.68, 0.55, 0.44};
    float *values = sky(0, 1, 0.0f, 0.0f);
    const float *overhead = values + 4 * 1023;
    assert_true(fabs(-log((double)overhead[2]) - code[0]) < 1e-5);
    assert_true(fabs(-log((double)overhead[3]) - code[2]) < 1e-5);
    free(values);
    for (int i = 0; i < 3; i++)
        assert_true(fabs(code[i] / air_depth(wave[i]) - 1.0) < 0.035);
}

// The share of the sun's white light that remains, and the first model of the sky in
// docs/09_sky_and_sunset.md: (0.5, 0.7, 1) times the transmittance of the air beyond one air mass.
// At the heights of the sun in this test, the model has more red than blue only up to 10 degrees,
// and more red than green only up to 5 degrees.
TEST(test_the_light_of_a_low_sun_is_red)
{
    const double heights[] = {90.0, 46.4, 30.0, 10.0, 5.0, 2.0, 0.0};
    float *values = sky(0, 1, 0.0f, 0.0f);
    for (int i = 0; i < 7; i++) {
        const float *v = values + 4 * (512 + lround(511.0 * sin(heights[i] * MIRROR_PI / 180.0)));
        double mass = mass_at(heights[i]), red = exp(-0.04 * mass), green = exp(-0.1 * mass),
               blue = exp(-0.25 * mass);
        print_message(
            "# sun at %.1f degrees: air mass %.2f, remaining %.3f %.3f %.4f, red : blue %.1f\n",
            heights[i], mass, red, green, blue, red / blue);
        // The nearest of the GPU's samples is at most 0.065 degrees away.
        assert_true(fabs((double)v[2] / red - 1.0) < 0.01);
        assert_true(heights[i] < 1.0 || fabs((double)v[3] / blue - 1.0) < 0.05);
        double first[3] = {0.5 * red / exp(-0.04), 0.7 * green / exp(-0.1), blue / exp(-0.25)};
        print_message("#   first model of the sky %.2f %.2f %.2f\n", first[0], first[1], first[2]);
        assert_int_equal(first[0] > first[2], heights[i] <= 10.0);
        assert_int_equal(first[0] > first[1], heights[i] <= 5.0);
    }
    free(values);
}

// The integral in section 5 of docs/09_sky_and_sunset.md, computed with Simpson's rule.
static double scattered(double depth, double v, double s)
{
    enum { N = 2000 };
    double sum = 0.0;
    for (int i = 0; i <= N; i++) {
        double t = depth * i / N, weight = i == 0 || i == N ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
        sum += weight * v * exp(-t * s - (depth - t) * v);
    }
    return sum * depth / N / 3.0;
}

TEST(test_scattered_light_is_the_integral)
{
    const float haze[2] = {0.0f, 0.25f};
    for (int k = 0; k < 2; k++) {
        float *values = sky(1, 64, haze[k], 0.0f);
        double worst = 0.0;
        for (int i = 0; i < 1024 * 64; i += 7) {
            const float *v = values + 4 * i;
            double mass = (double)v[0], sun = (double)v[1], extra = (double)haze[k];
            double red = scattered(0.04 + extra, mass, sun);
            double blue = scattered(0.25 + extra, mass, sun);
            worst = fmax(worst, fabs((double)v[2] / red - 1.0));
            worst = fmax(worst, blue > 1e-3 ? fabs((double)v[3] / blue - 1.0) : 0.0);
        }
        free(values);
        print_message("# scattered light, haze %.2f: worst relative error %.4f\n", (double)haze[k],
                      worst);
        // Where the air masses differ by less than 0.02, the shader changes one of them by up to
        // 0.04, which changes the light by a share of up to depth / 50.
        assert_true(worst < (0.25 + (double)haze[k]) / 40.0);
    }
}

// The table of the sky in docs/09_sky_and_sunset.md: the light scattered at noon and at sunset,
// overhead and at the horizon. The blue of the zenith at sunset comes from the gain, not from the
// scattering.
TEST(test_the_four_skies_are_those_of_the_page)
{
    const double depth[3] = {0.04, 0.1, 0.25}, gain[3] = {1.4, 1.75, 3.1};
    const char *const name[4] = {"noon, zenith", "noon, horizon", "sunset, zenith",
                                 "sunset, horizon"};
    const double page[4][3] = {{0.038, 0.089, 0.187},
                               {0.756, 0.884, 0.742},
                               {0.020, 0.024, 0.021},
                               {0.332, 0.085, 0.0007}};
    for (int i = 0; i < 4; i++) {
        double light[3], s = mass_at(i < 2 ? 48.4 : 0.0), v = mass_at(i % 2 == 0 ? 90.0 : 0.0);
        for (int k = 0; k < 3; k++) {
            light[k] = scattered(depth[k], v, s);
            assert_true(fabs(light[k] - page[i][k]) < (light[k] < 0.01 ? 5e-5 : 5e-4));
        }
        print_message("# %s: scattered %.3f %.3f %.4f, times the gain %.3f %.3f %.3f\n", name[i],
                      light[0], light[1], light[2], gain[0] * light[0], gain[1] * light[1],
                      gain[2] * light[2]);
        if (i == 2)
            assert_true(light[2] < light[1] && gain[2] * light[2] > gain[1] * light[1] &&
                        gain[1] * light[1] > gain[0] * light[0]);
    }
}

// Compare the sun with spherical geometry: its angle to the celestial pole is 90 degrees minus the
// declination, it turns uniformly about the pole, and its height at noon is 90 degrees minus the
// difference between latitude and declination.
static void check_sun(float latitude, float declination)
{
    float *values = sky(2, 1, latitude, declination);
    double p = (double)latitude * MIRROR_PI / 180.0, d = (double)declination * MIRROR_PI / 180.0;
    struct d3 pole = d3(cos(p), sin(p), 0.0), rise = d3(0.0, 0.0, 1.0),
              meridian = d3(-sin(p), cos(p), 0.0);
    for (int i = 0; i < 1024; i++) {
        struct d3 sun = d3_of(values + 4 * i);
        double angle = ((double)values[4 * i + 3] - 12.0) * MIRROR_PI / 12.0;
        assert_true(fabs(d3_length(sun) - 1.0) < 2e-6);
        assert_true(fabs(d3_dot(sun, pole) - sin(d)) < 1e-6);
        // Near midnight, the root of 1 minus a number near 1 has few correct digits.
        double slack = 2e-6 + 4e-7 / fmax(cos(0.5 * angle), 6e-4);
        assert_true(fabs(d3_dot(sun, rise) + cos(d) * sin(angle)) < slack);
        assert_true(fabs(d3_dot(sun, meridian) - cos(d) * cos(angle)) < 2e-6);
    }
    double noon = degrees(asin((double)values[4 * 512 + 1]));
    assert_true(fabs(noon - (90.0 - fabs((double)(latitude - declination)))) < 0.1);
    free(values);
}

TEST(test_sun_runs_as_the_sphere_says)
{
    check_sun(43.6f, 2.0f);
    check_sun(43.6f, 23.44f);
    check_sun(43.6f, -23.44f);
    check_sun(0.0f, 0.0f);
    check_sun(-35.0f, 10.0f);
    check_sun(66.0f, 23.44f);
    const double season[] = {-23.44, 0.0, 2.0, 23.44};
    for (int i = 0; i < 4; i++) {
        double d = season[i] * MIRROR_PI / 180.0, p = 43.6 * MIRROR_PI / 180.0;
        double half = degrees(acos(-tan(p) * tan(d))) / 15.0;
        // At an almanac's sunset, the upper rim of the sun, raised by refraction, is at the
        // horizon.
        double low = sin(-0.833 * MIRROR_PI / 180.0) - sin(p) * sin(d);
        double later = degrees(acos(low / (cos(p) * cos(d)))) * 4.0 - 60.0 * half;
        print_message(
            "# declination %.2f: sunrise %.2f, sunset %.2f (in an almanac %.1f minutes later), "
            "noon height %.1f\n",
            season[i], 12.0 - half, 12.0 + half, later, 90.0 - 43.6 + season[i]);
        assert_true(later > 4.5 && later < 5.6);
        // At sunrise and sunset, the height is 0.
        assert_true(fabs(sin(p) * sin(d) + cos(p) * cos(d) * cos(half * MIRROR_PI / 12.0)) < 1e-12);
    }
}

// At the hour of the chapter's picture, the sun is low and nearly in line with an avenue that runs
// west.
TEST(test_the_sun_of_the_picture_is_low_in_the_west)
{
    float *values = sky(2, 1, 43.6f, 2.0f);
    const float *before = values + 4 * (int)(17.8 / 24.0 * 1024.0);
    double share = 17.8 / 24.0 * 1024.0 - floor(17.8 / 24.0 * 1024.0);
    struct d3 sun =
        d3_add(d3_times(1.0 - share, d3_of(before)), d3_times(share, d3_of(before + 4)));
    double height = degrees(asin(sun.y)), aside = degrees(atan2(sun.x, -sun.z));
    free(values);
    print_message("# at 17.8 h the sun is %.2f degrees high, %.2f degrees north of west\n", height,
                  aside);
    assert_true(fabs(height - 3.55) < 0.005 && fabs(aside + 0.62) < 0.005);
}

// The Earth's shadow is not there by day, nor towards the sun. Opposite the sun it covers the
// horizon, and its edge, where half of the air is shaded, is as high as the sun is low.
TEST(test_the_shadow_of_the_earth_rises_opposite_the_sun)
{
    for (int low = -10; low <= 10; low += 2) {
        float *values = sky(3, 32, (float)-low, 0.0f);
        for (int i = 0; i < 32 * 1024; i++) {
            double share = (double)values[4 * i], height = (double)values[4 * i + 1];
            double edge = low * MIRROR_PI / 180.0;
            assert_true(share >= 0.0 && share <= 1.0);
            if (low <= 0 || i < 16 * 1024)
                assert_true(share < (low <= 0 ? 1e-6 : 0.5));
            if (low >= 4 && i >= 31 * 1024 && height < 0.5 * edge)
                assert_true(share > 0.5);
            if (low >= 4 && i >= 31 * 1024 && height > 1.5 * edge)
                assert_true(share < 0.5);
            assert_true(i % 1024 == 0 || share <= (double)values[4 * (i - 1)] + 1e-6);
        }
        free(values);
    }
}

// Half an hour after sunset, seen from above the roofs, the sun's disc is below the horizon, behind
// the ground: where it would be, the picture is as bright as beside it.
TEST(test_the_ground_hides_the_sun)
{
    assert_true(
        gpu_load_text("#include \"main.glsl\"\n#define rayColour chapterColour\n"
                      "#include \"09_sky_and_sunset.frag\"\n#undef rayColour\n"
                      "vec3 rayColour(Ray ray)\n{\n"
                      "    vec3 sun = sunDirection(hour(), LATITUDE, DECLINATION);\n"
                      "    vec3 aside = normalize(sun + vec3(0.03 * float(iPixel.x), 0.0, 0.0));\n"
                      "    return chapterColour(Ray(vec3(2.3, 20.0, -1.5), aside));\n}\n"));
    gpu_set("timeOfDay", 18.3);
    struct renderer_inputs inputs = gpu_inputs(2, 1, 1);
    float *values = gpu_numbers(&inputs);
    for (int k = 0; k < 3; k++)
        assert_true(fabsf(values[k] - values[4 + k]) < 0.02f);
    free(values);
}

TEST(test_glow_and_disc_follow_their_formulas)
{
    float *values = sky(4, 1, 0.0f, 0.0f);
    for (int i = 0; i < 1024; i++) {
        const float *v = values + 4 * i;
        double c = cos((double)v[2]), x = 0.04 / (1.64 - 1.6 * c);
        assert_true(fabs((double)v[0] - pow(x, 1.5)) < 1e-5);
        double chord = sqrt(2.0 - 2.0 * c);
        assert_true(fabs((double)v[1] - (1.0 - mirror_smoothstep(0.45, 0.55, chord))) < 1e-5);
    }
    free(values);
}

// ---- The city ----

enum { WIDE = 1024, HIGH = 256 };

static float *city(double time)
{
    struct renderer_inputs inputs = {.width = WIDE, .height = HIGH, .time = time, .samples = 1};
    return gpu_numbers(&inputs);
}

TEST(test_city_is_never_nearer_than_its_distance_says)
{
    assert_true(gpu_load("tests/shaders/city.frag"));
    float *positions = city(0.5), *distances = city(1.5);
    int asked = 0, inside = 0, capped = 0;
    double closest = 1.0;
    for (int i = 0; i < WIDE * HIGH; i += 3, asked++) {
        struct d3 share = d3_sub(d3_times(2.0, d3_of(positions + 4 * i)), d3(1.0, 1.0, 1.0));
        struct d3 p = d3(24.0 * share.x, 8.0 + 8.0 * share.y, 24.0 * share.z);
        double f = 32.0 * ((double)distances[4 * i] - 0.5), truth = city_towers_brute(p, 4);
        double street = city_street(p);
        assert_true(f <= truth + 1e-5 && fabs(f - city_distance(p, NULL)) < 1e-5);
        if (fabs(truth) > 1e-4 && street > 1e-4)
            assert_true((f < 0.0) == (truth < 0.0));
        inside += truth < 0.0;
        capped += truth > f + 0.1 && street > f + 0.1;
        if (truth > 0.01 && street > truth)
            closest = fmin(closest, f / truth);
    }
    free(positions);
    free(distances);
    print_message("# city: %d points, %d in towers, %d where the cap or a corner matters; "
                  "at least %.3f of the true distance\n",
                  asked, inside, capped, closest);
    assert_true(inside > 1000 && capped > 1000);
}

TEST(test_trees_are_1_lipschitz)
{
    assert_true(gpu_load("tests/shaders/city.frag"));
    float *values = city(2.5);
    double largest = 0.0;
    for (int i = 0; i < WIDE * HIGH; i++) {
        const float *v = values + 4 * i;
        double change = 16.0 * fabs((double)v[0] - (double)v[1]), apart = (double)v[2];
        assert_true(change <= apart + 4e-6);
        if (apart > 0.02)
            largest = fmax(largest, change / apart);
    }
    free(values);
    print_message("# trees: largest slope %.4f\n", largest);
    assert_true(largest > 0.98);
}

static struct probe probe; // too large for the stack

// In the middle of the avenue, the distance is that of the cap: every step is as long as half the
// width of a street.
TEST(test_steps_down_the_avenue_are_half_a_street_wide)
{
    struct renderer_inputs inputs = {
        .width = 1, .height = 1, .samples = 1, .camera = {.position = {3.0f, 5.0f, 0.0f}}};
    assert_true(gpu_load("chapters/09_sky_and_sunset.frag"));
    // In a picture of one pixel, the ray's cone is wide, so the far end of the march is not checked
    // here.
    assert_true(renderer_probe(&gpu.renderer, &inputs, 0, 0, &probe));
    for (int i = 0; i < probe.steps; i++)
        assert_true(fabs((double)probe.step[i].distance - 1.35) < 1e-6);
    assert_int_equal((int)ceil(80.0 / 1.35), 60);
}

TEST(test_sky_is_a_light_at_every_hour)
{
    assert_true(gpu_load("tests/shaders/city.frag"));
    float *values = city(3.5);
    for (int i = 0; i < WIDE * HIGH; i++)
        for (int k = 0; k < 3; k++)
            assert_true(values[4 * i + k] == 1.0f);
    free(values);
}

TESTS(gpu_setup, gpu_teardown)
