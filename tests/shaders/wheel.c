// wheel.c - chapter 04's wheel, which folds space, compared with twelve solids without a fold.
#include "lib/test.h"
#include "lib/chapter.h"

// The distance to solid i of the wheel, a ball or a die, at an angle of 30 i degrees.
static double solid(struct d3 p, int i)
{
    double angle = 30.0 * i * MIRROR_PI / 180.0, c = cos(angle), s = sin(angle);
    struct d3 q = {c * p.x + s * p.z - 2.5, p.y - (i % 2 == 0 ? 0.3 : 0.28), c * p.z - s * p.x};
    if (i % 2 == 0)
        return mirror_sphere(q, 0.4);
    double faces = fmax(fabs(q.x), fmax(fabs(q.y), fabs(q.z))) - 0.33;
    return fmax(faces, mirror_sphere(q, 0.45));
}

// The points are half a unit above the stage, all over it. No distance exceeds 4 there, so no
// result is clamped.
TEST(test_folding_finds_the_nearest_of_twelve_solids)
{
    float *values = chapter_numbers(
        "04_hue_colour", "vec3 p = vec3(0.01 * (pixel.x - 320.0), 0.5, 0.018 * (pixel.y - 180.0));"
                         "return vec3(0.2 + 0.2 * wheelDistance(p));");
    double worst = 0.0;
    int count = 0, seen[12] = {0};
    for (int i = 0; i < CHAPTER_WIDTH * CHAPTER_HEIGHT; i += 7, count++) {
        struct d3 p = {0.01 * (i % CHAPTER_WIDTH - 320), 0.5, 0.018 * (i / CHAPTER_WIDTH - 180)};
        int nearest = 0;
        for (int k = 1; k < 12; k++)
            nearest = solid(p, k) < solid(p, nearest) ? k : nearest;
        seen[nearest]++;
        worst = fmax(worst, fabs(5.0 * (double)values[4 * i] - 1.0 - solid(p, nearest)));
    }
    free(values);
    print_message("# %d points: the folded wheel is off by at most %.1e\n", count, worst);
    assert_true(worst < 5e-6);
    for (int k = 0; k < 12; k++)
        assert_true(seen[k] > 500);
}

TESTS(gpu_setup, gpu_teardown)
