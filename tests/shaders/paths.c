// paths.c - the estimates of chapters 13 and 14 against paths of light: the numbers that their
// pages quote. The random numbers are the same on every machine; the noise of a mean is below 0.2
// %.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/paths.h"

static void assert_share(const struct paths_light *light, int channel, double share)
{
    double found = light->estimate[channel] / light->paths[channel] - 1.0;
    if (!(fabs(found - share) < 0.01))
        fail_msg("channel %d: %.3f instead of %.3f", channel, found, share);
}

TEST(the_ambient_light_of_chapter_13_is_compared_with_paths)
{
    struct paths_light light;
    paths_terrace(&light);
    assert_share(&light, 0, -0.018);
    assert_share(&light, 1, -0.006);
    assert_share(&light, 2, -0.012);
    assert_true(light.apart < 0.02);
}

// Many rays bring the sun's light to within 0.1 %, and the formulas of one march lose a fifth.
TEST(the_shares_of_chapter_13_are_compared_with_paths)
{
    struct paths_light light;
    for (int channel = 0; channel < 3; channel++) {
        paths_sun(3, &light);
        assert_share(&light, channel, 0.001);
        paths_sun(2, &light);
        assert_share(&light, channel, -0.198);
    }
}

TEST(the_series_of_chapter_14_is_compared_with_paths)
{
    struct paths_light taps, taps_dark, truth, truth_dark;
    paths_court(PATHS_TAPS, &taps, &taps_dark);
    paths_court(PATHS_TRUE_OPENNESS, &truth, &truth_dark);
    assert_share(&taps, 0, 0.057);
    assert_share(&taps, 1, 0.032);
    assert_share(&taps, 2, 0.016);
    assert_share(&truth, 0, 0.045);
    assert_share(&truth, 1, 0.013);
    assert_share(&truth, 2, -0.011);
    assert_true(truth.apart < 0.5 * taps.apart);
    // Under the arcade, the taps give twice the light, and the formula alone less than a third.
    assert_share(&taps_dark, 1, 1.035);
    assert_share(&truth_dark, 1, -0.713);
}

TESTS(gpu_setup, gpu_teardown)
