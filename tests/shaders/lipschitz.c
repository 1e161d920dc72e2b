// lipschitz.c - the distances of chapters whose solids are bent, carved or folded. Between two
// points, no distance changes by more than the distance between the points, so no step of a march
// is too long.
#include "lib/test.h"
#include "lib/chapter.h"

// A chapter, opposite corners of the box that contains the points, and a statement to run before
// the distance is evaluated.
struct scene {
    const char *stem, *low, *high, *before;
};

static const struct scene scenes[] = {
    {"09_sky_and_sunset", "-24.0, 0.0, -24.0", "24.0, 12.0, 24.0", ""},
    {"12_textures", "-1.85, 0.0, -0.62", "2.25, 1.6, 0.62", ""},
    {"14_occlusion", "-4.7, 0.0, -6.1", "4.7, 4.7, 1.4", ""},
    // The image in the water is shifted by `bend`, of at most 0.16 on each axis.
    {"18_sky_from_tables", "8.0, -14.0, -64.0", "50.0, 14.0, -32.0", "bend = 0.32 * r.yz - 0.16;"},
    {"20_clouds_and_weather", "-22.0, 0.0, -20.0", "-12.0, 7.0, -2.0", ""},
    // A march never needs the distance inside the cloth.
    {"24_bounces", "-0.4, 0.0, -1.5", "1.9, 1.3, -0.3",
     "if (min(sceneDistance(p), sceneDistance(p + way)) < 0.0) return vec3(0.0);"},
};

// The largest slope between pairs of points 0.02 to 0.5 apart. A float of up to 80 is off by at
// most 4e-6, so a slope over 0.02 is off by at most 4e-4.
static double steepest_slope(const struct scene *scene)
{
    char body[900];
    snprintf(body, sizeof body,
             "vec3 r = fract(vec3(dot(pixel, vec2(0.7549, 0.5698)), dot(pixel, vec2(0.8192, "
             "0.6710)), dot(pixel, vec2(0.3820, 0.8567))));"
             "vec3 low = vec3(%s), high = vec3(%s), p = mix(low, high, r);"
             "vec3 way = (0.02 + 0.48 * r.z * r.z) * normalize(fract(97.0 * r.zxy) - 0.4999);"
             "%s return vec3(0.5 * abs(sceneDistance(p + way) - sceneDistance(p)) / length(way));",
             scene->low, scene->high, scene->before);
    float *values = chapter_numbers(scene->stem, body);
    double steepest = 0.0;
    for (int i = 0; i < CHAPTER_WIDTH * CHAPTER_HEIGHT; i++)
        steepest = fmax(steepest, 2.0 * (double)values[4 * i]);
    free(values);
    return steepest;
}

TEST(test_no_distance_changes_faster_than_the_point_moves)
{
    for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++) {
        double steepest = steepest_slope(&scenes[i]);
        print_message("# %s: %d pairs of points, steepest slope %.4f\n", scenes[i].stem,
                      CHAPTER_WIDTH * CHAPTER_HEIGHT, steepest);
        assert_true(steepest > 0.8 && steepest < 1.0005);
    }
}

// When chapter 20 marches towards its coast, it clips each ray to two boxes. No part of the coast
// above the sea is outside these boxes.
TEST(test_the_boxes_contain_the_coast)
{
    float *values = chapter_numbers(
        "20_clouds_and_weather",
        "vec3 r = fract(vec3(dot(pixel, vec2(0.7549, 0.5698)), dot(pixel, vec2(0.8192, 0.6710)), "
        "dot(pixel, vec2(0.3820, 0.8567))));"
        "vec3 p = vec3(-24.0, 0.0, -22.0) + vec3(15.0, 8.0, 22.0) * r;"
        "vec3 t = abs(p - vec3(-15.5, 4.15, -6.4));"
        "bool rocks = p.x > -22.5 && p.x < -10.8 && p.y < 3.4 && p.z > -21.0 && p.z < -1.4;"
        "bool tower = max(t.x, t.z) < 0.76 && t.y < 3.15;"
        "return rocks || tower ? vec3(1.0) : vec3(0.5 + 0.1 * sceneDistance(p), 0.0, 0.0);");
    double least = 5.0;
    int count = 0;
    for (int i = 0; i < CHAPTER_WIDTH * CHAPTER_HEIGHT; i++)
        if (values[4 * i + 1] <= 0.0f) {
            least = fmin(least, 10.0 * ((double)values[4 * i] - 0.5));
            count++;
        }
    free(values);
    print_message("# outside the boxes: %d points, the nearest %.3f from the coast\n", count,
                  least);
    assert_true(count > 50000 && least > 0.0);
}

TESTS(gpu_setup, gpu_teardown)
