// clouds.c - shaders/clouds.glsl compared with double precision: the layer over a round Earth,
// positions in the panorama, the light of clouds, an overcast sky, the weather and the rain. The
// panoramas themselves are tested at their seam.
#include "lib/test.h"
#include "picture/image.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

#define SHADER "tests/shaders/clouds.frag"

enum { HIT, UV, DIRECTION, OVERCAST, WEATHER, MORE, OVER, LIGHT, MIDDLE, SUN, RAIN };
enum { WIDE = 128, HIGH = 64 };

static const double earth = 6371.0;

// ---- The layer ----

// The distance, in km, to the point at which a ray reaches an altitude, found by bisection.
static double hit_by_halving(double height, double climb, double altitude)
{
    double low = 0.0, high = 20000.0;
    // The ray gains height only beyond its lowest point.
    if (climb < 0.0)
        low = -(earth + height) * climb;
    for (int i = 0; i < 200; i++) {
        double t = 0.5 * (low + high), x = t * sqrt(1.0 - climb * climb);
        double up = earth + height + t * climb;
        // This is hypot(x, up) - earth without its rounding error: x^2 + (up^2 - earth^2) divided
        // by hypot(x, up) + earth.
        double over = (x * x + (up - earth) * (up + earth)) / (hypot(x, up) + earth);
        *(over < altitude ? &low : &high) = t;
    }
    return 0.5 * (low + high);
}

// layerHit uses the stable form of the root, which is accurate to a few roundings of a float, 6e-8
// each. The textbook form loses digits overhead, and the lower the layer is, the more it loses.
TEST(test_layer_is_where_the_ray_meets_it)
{
    static const float layers[][4] = {
        {0.0f, 1.2f}, {0.0f, 8.0f}, {0.1f, 0.6f}, {2.0f, 12.0f}, {0.0f, 0.01f}};
    for (int k = 0; k < 5; k++) {
        float *values = gpu_call(SHADER, 256, 1, HIT, layers[k]);
        double worst = 0.0, plain = 0.0;
        for (int i = 0; i < 256; i++) {
            const float *v = values + 4 * i;
            double right = hit_by_halving((double)layers[k][0], (double)v[0], (double)layers[k][1]);
            worst = fmax(worst, fabs((double)v[1] / right - 1.0));
            plain = fmax(plain, fabs((double)v[2] / right - 1.0));
        }
        free(values);
        print_message(
            "# layer at %.2f km, eye at %.2f km: worst relative error %.2g, with the textbook "
            "root %.2g\n",
            (double)layers[k][1], (double)layers[k][0], worst, plain);
        assert_true(worst < 1e-6);
        assert_true(plain > 30.0 * worst);
    }
}

// Straight up, the distance to the layer is the difference of heights; horizontally from the
// ground, it is the square root of 2 R a + a^2. The test prints numbers for
// docs/20_clouds_and_weather.md, for a layer at a height of 1.2 km.
TEST(test_layer_distances_are_exact_overhead_and_at_the_horizon)
{
    static const double degrees[] = {0.5, 1.0, 2.0, 5.0, 30.0};
    for (int i = 0; i < 5; i++) {
        double y = sin(degrees[i] * MIRROR_PI / 180.0), round = hit_by_halving(0.0, y, 1.2);
        print_message("# %4.1f degrees: %6.1f km over a flat Earth, %5.1f km over a round Earth\n",
                      degrees[i], 1.2 / y, round);
        assert_true(round < 1.2 / y);
    }
    assert_true(fabs(hit_by_halving(0.0, 1.0, 1.2) - 1.2) < 1e-9);
    assert_true(fabs(hit_by_halving(0.0, 0.0, 1.2) - sqrt(2.0 * earth * 1.2 + 1.44)) < 1e-6);
}

// seenFromMiddle turns the direction from an eye beside the origin to a point of the layer into the
// direction from the origin to that point.
TEST(test_the_centre_sees_the_same_point)
{
    const float eye[4] = {0.8f, 0.1f, -0.5f, 1.2f};
    float *directions = gpu_call(SHADER, WIDE, HIGH, DIRECTION, eye);
    float *seen = gpu_call(SHADER, WIDE, HIGH, MIDDLE, eye);
    for (int i = 0; i < WIDE * HIGH; i++) {
        struct d3 d = d3_unit(d3_of(directions + 4 * i)), from = d3_of(eye);
        double t = hit_by_halving(from.y, d.y, (double)eye[3]);
        struct d3 right = d3_unit(d3_add(from, d3_times(t, d)));
        assert_true(d3_length(d3_sub(right, d3_of(seen + 4 * i))) < 2e-6);
    }
    free(directions);
    free(seen);
}

// Clouds see the sun after it has set on the ground: at an altitude of a, the ray that grazes the
// Earth makes an angle of acos(R / (R + a)) with the horizontal. The approximation sqrt(2 a / R)
// has a relative error of 5/12 a / R. The shader adds this angle to the sine of the sun's height h
// instead of to h, which adds a relative error of h^2 / 2.
TEST(test_clouds_see_the_sun_longer)
{
    for (float a = 0.5f; a < 13.0f; a *= 2.0f) {
        const float altitude[4] = {a};
        float *values = gpu_call(SHADER, 513, 1, SUN, altitude);
        double dip = acos(earth / (earth + (double)a));
        for (int i = 0; i < 513; i++) {
            double h = asin((double)values[4 * i]), got = (double)values[4 * i + 1];
            assert_true(got <= 1.0);
            if (fabs(h) < 0.2)
                assert_true(fabs(got - sin(h + dip)) < 0.025 * dip + 0.6 * dip * dip);
        }
        free(values);
    }
}

// ---- The panorama ----

static double turn_apart(double a, double b)
{
    double d = a - b;
    return fabs(d - floor(d + 0.5));
}

TEST(test_panorama_positions_are_angles)
{
    const float width[4] = {0.002f};
    float *directions = gpu_call(SHADER, WIDE, HIGH, DIRECTION, width);
    float *positions = gpu_call(SHADER, WIDE, HIGH, UV, width);
    double worst = 0.0, reach = 0.0;
    for (int i = 0; i < WIDE * HIGH; i++) {
        struct d3 d = d3_unit(d3_of(directions + 4 * i));
        const float *v = positions + 4 * i;
        double level = hypot(d.x, d.z), height = atan2(d.y, level), w = (double)width[0];
        worst = fmax(worst, turn_apart((double)v[0], atan2(d.z, d.x) / (2.0 * MIRROR_PI)));
        worst = fmax(worst, fabs((double)v[1] - sqrt(2.0 * height / MIRROR_PI)));
        // The expected footprint is computed, in u, from the slope along the horizon and, in v,
        // from the difference over half a pixel to each side.
        double u = w / level / (2.0 * MIRROR_PI);
        double up = sqrt(2.0 * (height + 0.5 * w) / MIRROR_PI) -
                    sqrt(2.0 * fmax(height - 0.5 * w, 0.0) / MIRROR_PI);
        reach = fmax(reach, fabs((double)v[2] / u - 1.0));
        reach = fmax(reach, fabs((double)v[3] / up - 1.0));
        assert_true(v[0] >= -0.50001f && v[0] <= 0.50001f && v[1] >= 0.0f && v[1] <= 1.00001f);
    }
    free(directions);
    free(positions);
    print_message(
        "# panorama: positions off by at most %.2g, footprints by at most %.2g of their size\n",
        worst, reach);
    assert_true(worst < 2e-6 && reach < 2e-3);
}

// The largest difference in any channel between two columns.
static int column_step(const struct image_bytes *image, int left, int right)
{
    int largest = 0;
    for (int y = 0; y < image->height; y++)
        for (int c = 0; c < 3; c++) {
            int a = image->value[3 * (y * image->width + left) + c];
            int b = image->value[3 * (y * image->width + right) + c];
            largest = abs(a - b) > largest ? abs(a - b) : largest;
        }
    return largest;
}

// The first and the last column of a panorama differ no more than neighbouring columns near the
// seam.
TEST(test_panoramas_have_no_seam)
{
    static const char *const names[] = {"fair", "storm"};
    for (int k = 0; k < 2; k++) {
        char path[4200], why[IMAGE_WHY];
        struct image_bytes image = {0};
        snprintf(path, sizeof path, "%s/shaders/textures/clouds_%s.png", gpu.root, names[k]);
        assert_true(image_read_bytes(&image, path, 3, 1 << 22, why));
        int seam = column_step(&image, image.width - 1, 0), beside = 0;
        for (int x = 1; x <= 8; x++) {
            int left = column_step(&image, x - 1, x);
            int right = column_step(&image, image.width - 1 - x, image.width - x);
            beside = left > beside ? left : beside;
            beside = right > beside ? right : beside;
        }
        print_message("# clouds_%s: columns differ by %d / 255 across the seam, by at most %d / "
                      "255 beside it\n",
                      names[k], seam, beside);
        assert_true(seam <= beside && seam > 0);
        free(image.value);
    }
}

// ---- Clouds ----

TEST(test_clouds_over_clouds_follow_the_formula)
{
    const float none[4] = {0.0f};
    float *values = gpu_call(SHADER, WIDE, HIGH, OVER, none);
    for (int i = 0; i < 4 * WIDE * HIGH; i++)
        assert_true(fabsf(values[i]) < 1e-6f);
    free(values);
}

// At every hour and in every direction, a cloud sends at least a quarter of the skylight from the
// share that it covers. The grey of the article's clouds at night, 0.95 + 1.8 sin(height of the
// sun), is negative when the sun is more than 31.9 degrees below the horizon.
TEST(test_clouds_are_never_darker_than_black)
{
    for (int hour = 0; hour < 24; hour++) {
        const float numbers[4] = {(float)hour};
        float *values = gpu_call(SHADER, WIDE, HIGH, LIGHT, numbers);
        for (int i = 0; i < WIDE * HIGH; i++) {
            const float *v = values + 4 * i;
            for (int c = 0; c < 3; c++) {
                assert_true(v[c] >= 0.0025f * v[3] * 0.99f);
                // The light is at most four times the sunlight of 0.3, plus the skylight.
                assert_true(v[c] <= 1.3f);
            }
        }
        free(values);
    }
    assert_true(0.95 + 1.8 * sin(-31.9 * MIRROR_PI / 180.0) < 0.0);
    assert_true(0.95 + 1.8 * sin(-31.8 * MIRROR_PI / 180.0) > 0.0);
}

// ---- Weather ----

// An overcast sky is three times as bright overhead as at the horizon. Its light, summed over the
// hemisphere and weighted with the cosine of the angle to the zenith, is pi times the white that
// the shader is given. The sum uses the midpoint rule in y = sin h, where the solid angle is
// 2 pi dy.
TEST(test_overcast_sky_keeps_its_light)
{
    const float white[4] = {0.7f, 1.0f, 2.0f};
    float *values = gpu_call(SHADER, 256, 1, OVERCAST, white);
    for (int c = 0; c < 3; c++) {
        double sum = 0.0;
        for (int i = 0; i < 256; i++)
            sum += 2.0 * MIRROR_PI / 256.0 * (double)values[4 * i + 3] * (double)values[4 * i + c];
        assert_true(fabs(sum / (MIRROR_PI * (double)white[c]) - 1.0) < 1e-5);
        // The values are linear in y; y = 0 and y = 1 are half a step beyond the first and the last
        // value.
        double first = (double)values[c], last = (double)values[4 * 255 + c];
        double step = (last - first) / 255.0;
        assert_true(fabs((last + 0.5 * step) / (first - 0.5 * step) - 3.0) < 1e-4);
    }
    free(values);
}

TEST(test_weather_runs_from_fair_to_bad)
{
    const float none[4] = {0.0f};
    float *shares = gpu_call(SHADER, 501, 1, WEATHER, none);
    float *more = gpu_call(SHADER, 501, 1, MORE, none);
    const float *bad = shares, *fair = shares + 4 * 500;
    assert_true(bad[0] == 0.0f && bad[1] == 1.0f && bad[2] == 1.0f && bad[3] < 0.02f);
    assert_true(fair[0] == 1.0f && fair[1] == 0.0f && fair[2] == 0.0f && fair[3] == 1.0f);
    assert_true(more[1] == 1.0f && more[4 * 500 + 1] == 0.0f);
    assert_true(more[0] > 4.0f * more[4 * 500]);
    // The sun's disc is 46,000 times as bright as a white wall perpendicular to its rays, and yet
    // it is invisible in the worst weather.
    assert_true(more[2] < 1e-6f && more[4 * 500 + 2] == 1.0f);
    for (int i = 0; i <= 500; i += 50) {
        const float *v = shares + 4 * i, *w = more + 4 * i;
        print_message("# weather %.2f: fair %.2f, storm %.2f, overcast %.2f, sun %.3f, haze %.3f, "
                      "rain %.2f\n",
                      0.5 + i / 1000.0, (double)v[0], (double)v[1], (double)v[2], (double)v[3],
                      (double)w[0], (double)w[1]);
    }
    for (int i = 1; i <= 500; i++) {
        const float *v = shares + 4 * i, *before = v - 4;
        assert_true(v[0] >= before[0] && v[1] <= before[1] && v[2] <= before[2]);
        assert_true(v[3] >= before[3] && more[4 * i] <= more[4 * i - 4]);
        assert_true(more[4 * i + 1] <= more[4 * i - 3]);
        assert_true(more[4 * i + 2] >= more[4 * i - 2] && more[4 * i + 2] <= v[3]);
        assert_true(v[0] + v[1] >= 0.99f); // the sky always has clouds
    }
    free(shares);
    free(more);
}

// Streaks of rain fill a small share of the picture, and they move.
TEST(test_rain_falls)
{
    const float first[4] = {0.0f, 90.0f}, later[4] = {0.1f, 90.0f};
    float *a = gpu_call(SHADER, 160, 90, RAIN, first), *b = gpu_call(SHADER, 160, 90, RAIN, later);
    double sum = 0.0, moved = 0.0;
    for (int i = 0; i < 160 * 90; i++) {
        assert_true(a[4 * i] >= 0.0f && a[4 * i] <= 1.0f);
        sum += (double)a[4 * i] / (160 * 90);
        moved += fabs((double)(a[4 * i] - b[4 * i])) / (160 * 90);
    }
    free(a);
    free(b);
    print_message("# rain: mean %.3f, mean change in 0.1 s %.3f\n", sum, moved);
    assert_true(sum > 0.005 && sum < 0.1 && moved > 0.5 * sum);
}

// A picture with few pixels contains as much rain as one with many, because a streak that is
// widened to a pixel becomes fainter in proportion. The mean is taken over eight moments, and may
// differ by a thousandth or two because the edge of the picture cuts off some of the rain.
TEST(test_rain_keeps_its_light)
{
    static const int rows[] = {72, 108, 180, 360, 720};
    double mean[5] = {0.0};
    for (int i = 0; i < 5; i++) {
        int width = rows[i] * 16 / 9;
        for (int moment = 0; moment < 8; moment++) {
            const float when[4] = {0.37f * (float)moment, (float)rows[i]};
            float *v = gpu_call(SHADER, width, rows[i], RAIN, when);
            for (int j = 0; j < width * rows[i]; j++)
                mean[i] += (double)v[4 * j] / (8.0 * width * rows[i]);
            free(v);
        }
        print_message("# rain, %d rows: mean %.5f\n", rows[i], mean[i]);
        assert_true(fabs(mean[i] / mean[0] - 1.0) < 0.002);
    }
}

TESTS(gpu_setup, gpu_teardown)
