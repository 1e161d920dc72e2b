// bound.c - how close a march comes to the smallest sufficient number of evaluations. The smallest
// number that shaders/cover.glsl finds is compared with closed forms, and with bounds from the
// chapters' scenes in double precision.
#include "lib/test.h"
#include "lib/bound.h"

// ---- Closed forms ----

// The values are chosen so that rounding cannot change any number of evaluations.
TEST(test_counts_for_a_plane_follow_the_formula)
{
    const double slopes[] = {0.97, 0.8, 0.6, 0.45, 0.3, 0.2, 0.12, 0.08, -0.05, -0.2, -0.5, -0.85};
    for (size_t i = 0; i < sizeof slopes / sizeof *slopes; i++) {
        const double far = 14.3, threshold = 0.003;
        bool hit;
        int answer[2], march = cover_plane_march(1.0, slopes[i], far, threshold, &hit);
        int least = cover_plane_least(1.0, slopes[i], far, threshold);
        bound_ask(slopes[i], 0.0, far, threshold, answer);
        print_message("# slope %g, %s: the march takes %d evaluations (formula %d), the fewest are "
                      "%d (formula %d)\n",
                      slopes[i], hit ? "hit" : "miss", answer[0], march, answer[1], least);
        assert_int_equal(answer[0], march);
        assert_int_equal(answer[1], least);
        double ratio = cover_plane_ratio(slopes[i]); // the limit of march / least as both grow
        assert_true(fabs(answer[0] - ratio * answer[1]) <= 1.0 + 2.0 * ratio);
    }
}

TEST(test_counts_past_a_ball_follow_the_formula)
{
    for (double gap = 1.7; gap > 0.002; gap /= 2.3) {
        int answer[2], march = cover_ball_march(gap, 4.2), least = cover_ball_least(gap, 4.2);
        bound_ask(0.0, gap, 8.4, 0.0001, answer);
        print_message("# gap %.4f: the march takes %d evaluations (formula %d), the fewest are %d "
                      "(formula %d)\n",
                      gap, answer[0], march, answer[1], least);
        assert_int_equal(answer[0], march);
        assert_int_equal(answer[1], least);
    }
}

// ---- The chapters ----

static struct bound_sums total(const struct bound_sums sums[2])
{
    struct bound_sums all = sums[1];
    all.rays += sums[0].rays;
    all.march += sums[0].march;
    all.least += sums[0].least;
    all.most += sums[0].most;
    all.shader += sums[0].shader;
    all.astray += sums[0].astray;
    all.below += sums[0].below;
    all.given_up += sums[0].given_up;
    all.differ += sums[0].differ;
    all.lipschitz = fmax(all.lipschitz, sums[0].lipschitz);
    all.smallest = fmin(all.smallest, sums[0].smallest);
    return all;
}

// Check a chapter with every second ray that --benchmark samples.
static void check_chapter(int chapter)
{
    struct bound_sums sums[2], all;
    bound_measure(&bound_cases[chapter], 2, sums);
    all = total(sums);
    double ratio = (double)all.march / all.least;
    print_message("# %s: %d rays take %d evaluations; the fewest are %d to %d; the shader finds %d "
                  "(outside the bounds for %d rays); ratio %.3f, at least %.3f for every ray; "
                  "slope at most %.6f; %d rays ran out of steps\n",
                  bound_cases[chapter].stem, all.rays, all.march, all.least, all.most, all.shader,
                  all.astray, ratio, all.smallest, all.lipschitz, all.given_up);
    // The bounds are proved only for a 1-Lipschitz distance.
    assert_true(all.lipschitz < 1.0 + 1e-6);
    assert_int_equal(all.given_up, 0);
    assert_int_equal(all.differ, 0);
    // No march takes fewer evaluations than the lower bound, and the samples determine the smallest
    // number of evaluations to within two per cent.
    assert_int_equal(all.below, 0);
    assert_true(all.smallest >= 1.0);
    assert_true(all.most - all.least <= 0.02 * all.least);
    // The shader's number is the one that --benchmark prints.
    assert_true(all.shader >= all.least && all.shader <= all.most);
    assert_true(all.astray <= all.rays / 100);
    // No theorem bounds the ratio from above; in these chapters it stays below 2.2.
    assert_true(ratio > 1.0 && ratio < 2.2);
    assert_true(all.rays > 70);
}

TEST(test_marches_of_chapter_03_are_near_the_bound)
{
    check_chapter(0);
}

TEST(test_marches_of_chapter_06_are_near_the_bound)
{
    check_chapter(1);
}

TEST(test_marches_of_chapter_09_are_near_the_bound)
{
    check_chapter(2);
}

TESTS(gpu_setup, gpu_teardown)
