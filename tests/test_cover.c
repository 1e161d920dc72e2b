// test_cover.c - the fewest evaluations that show an interval to be empty: the greedy choice
// against every choice there is, and against closed forms.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "support_cover.h"

enum { POINTS = 12, FINE = 49, EVERY = 4, FUNCTIONS = 200, PARTS = 64 };

// A whole number from 0 to limit - 1, the same in every run.
static int next_of(uint32_t *seed, int limit)
{
    *seed = *seed * 1664525u + 1013904223u;
    return (int)((*seed >> 8) % (uint32_t)limit);
}

// ---- Every choice ----

// Do the chosen intervals cover the ray from 0 to the last point? Ends are whole numbers, so the
// middles between them tell.
static bool covers(const struct cover_sample *sample, int chosen)
{
    for (int k = 0; k + 1 < POINTS; k++) {
        bool covered = false;
        for (int i = 0; i < POINTS; i++)
            covered = covered || ((chosen >> i & 1) && fabs(k + 0.5 - i) < sample[i].d);
        if (!covered)
            return false;
    }
    return true;
}

static int fewest_of_all(const struct cover_sample *sample, bool hit)
{
    int fewest = POINTS + 1;
    for (int chosen = hit ? 1 << (POINTS - 1) : 0; chosen < 1 << POINTS; chosen++) {
        int size = 0;
        for (int i = 0; i < POINTS; i++)
            size += chosen >> i & 1;
        if (size < fewest && covers(sample, chosen))
            fewest = size;
    }
    return fewest;
}

// A distance in whole numbers at 0, 1, 2, ...: it changes by at most 1 from point to point, or at
// will.
static void random_function(struct cover_sample *sample, int count, bool lipschitz, uint32_t *seed)
{
    int d = next_of(seed, 3);
    for (int i = 0; i < count; i++) {
        sample[i] = (struct cover_sample){i, d};
        d = lipschitz ? abs(d + next_of(seed, 3) - 1) : next_of(seed, 4);
    }
}

static void check_all(bool lipschitz)
{
    uint32_t seed = 7;
    int covered = 0, several = 0;
    for (int i = 0; i < FUNCTIONS; i++) {
        struct cover_sample sample[POINTS];
        random_function(sample, POINTS, lipschitz, &seed);
        for (int hit = 0; hit < 2; hit++) {
            int fewest = fewest_of_all(sample, hit);
            struct cover_count greedy = cover_of(sample, POINTS, hit);
            if (fewest > POINTS) {
                assert_int_equal(greedy.most, COVER_NEVER);
                continue;
            }
            assert_int_equal(greedy.most, fewest);
            covered++;
            several += fewest > 2;
        }
    }
    print_message("# %d covered, %d of them by more than two\n", covered, several);
    assert_true(covered > FUNCTIONS / 4 && several > FUNCTIONS / 10);
}

static void test_greedy_is_the_best_choice(void **unused)
{
    (void)unused;
    check_all(true);
}

static void test_also_of_a_distance_that_jumps(void **unused)
{
    (void)unused;
    check_all(false);
}

// A function known at every fourth point: the bounds hold what all its points say.
static void test_bounds_hold_what_is_between_samples(void **unused)
{
    (void)unused;
    uint32_t seed = 11;
    int apart = 0;
    for (int i = 0; i < FUNCTIONS; i++) {
        struct cover_sample fine[FINE], coarse[FINE];
        random_function(fine, FINE, true, &seed);
        for (int k = 0; k < FINE; k += EVERY)
            coarse[k / EVERY] = fine[k];
        for (int hit = 0; hit < 2; hit++) {
            int fewest = cover_of(fine, FINE, hit).most;
            struct cover_count bounds = cover_of(coarse, (FINE - 1) / EVERY + 1, hit);
            assert_true(bounds.least <= fewest && fewest <= bounds.most);
            apart += bounds.least < bounds.most;
        }
    }
    assert_true(apart > FUNCTIONS / 10);
}

// ---- Closed forms ----

// A march with many samples between its steps.
struct dense {
    struct cover_sample *sample;
    int count;
};

static struct dense dense_of(int steps)
{
    struct dense dense = {malloc(((size_t)steps * PARTS + 1) * sizeof *dense.sample), 0};
    assert_non_null(dense.sample);
    return dense;
}

static void check_bounds(const char *what, struct dense dense, bool hit, int march, int least)
{
    struct cover_count count = cover_of(dense.sample, dense.count, hit);
    free(dense.sample);
    print_message("# %s: march %d, the least %d, from samples %d to %d\n", what, march, least,
                  count.least, count.most);
    assert_true(count.least <= least && least <= count.most && least <= march);
    assert_true(count.most - count.least <= 1 + march / 50);
}

static void check_plane(double slope)
{
    const double far = 20.0, threshold = 1e-4;
    bool hit;
    int march = cover_plane_march(1.0, slope, far, threshold, &hit);
    int least = cover_plane_least(1.0, slope, far, threshold);
    struct dense dense = dense_of(march);
    double t = 0.0;
    for (int i = 0; i < march - (hit ? 1 : 0); i++) {
        double d = 1.0 - slope * t;
        for (int k = 0; k < PARTS && t + k * d / PARTS < far; k++) {
            double at = t + k * d / PARTS;
            dense.sample[dense.count++] = (struct cover_sample){at, 1.0 - slope * at};
        }
        t += d;
    }
    t = hit ? t : far;
    dense.sample[dense.count++] = (struct cover_sample){t, 1.0 - slope * t};
    char what[64];
    snprintf(what, sizeof what, "plane, slope %g", slope);
    check_bounds(what, dense, hit, march, least);
    double ratio = cover_plane_ratio(slope);
    assert_true(hit == (slope > 1.0 / 20.0));
    assert_true(fabs(march - ratio * least) <= 1.0 + 2.0 * ratio);
}

static void test_plane(void **unused)
{
    (void)unused;
    const double slopes[] = {0.99, 0.9, 0.7,  0.5,  0.3,  0.1, 0.06,
                             0.04, 0.0, -0.1, -0.3, -0.6, -0.9};
    for (size_t i = 0; i < sizeof slopes / sizeof *slopes; i++)
        check_plane(slopes[i]);
}

// Slope 0: 2. Towards the plane less, down to 1; away from it more, without end.
static void test_ratio_of_a_plane(void **unused)
{
    (void)unused;
    assert_true(fabs(cover_plane_ratio(1e-6) - 2.0) < 1e-5);
    assert_true(fabs(cover_plane_ratio(-1e-6) - 2.0) < 1e-5);
    assert_true(fabs(cover_plane_ratio(0.5) - log(3.0) / log(2.0)) < 1e-12);
    assert_true(cover_plane_ratio(1.0 - 1e-12) < 1.03 && cover_plane_ratio(-1.0 + 1e-12) > 40.0);
    for (double slope = -0.99; slope < 0.985; slope += 0.01)
        assert_true(cover_plane_ratio(slope) > cover_plane_ratio(slope + 0.01));
}

static void check_ball(double gap, double reach)
{
    int march = cover_ball_march(gap, reach), steps = 0;
    struct dense dense = dense_of(march);
    for (double t = -reach; t < reach; steps++) {
        double d = hypot(t, 1.0 + gap) - 1.0;
        for (int k = 0; k < PARTS && t + k * d / PARTS < reach; k++) {
            double at = t + k * d / PARTS;
            dense.sample[dense.count++] = (struct cover_sample){at, hypot(at, 1.0 + gap) - 1.0};
        }
        t += d;
    }
    dense.sample[dense.count++] = (struct cover_sample){reach, hypot(reach, 1.0 + gap) - 1.0};
    char what[64];
    snprintf(what, sizeof what, "ball, gap %g, from %g before it", gap, reach);
    check_bounds(what, dense, false, march, cover_ball_least(gap, reach));
}

static void test_past_a_ball(void **unused)
{
    (void)unused;
    for (double gap = 1.0; gap > 1e-3; gap /= 4.0) {
        check_ball(gap, 3.0);
        check_ball(gap, 30.0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_greedy_is_the_best_choice),
        cmocka_unit_test(test_also_of_a_distance_that_jumps),
        cmocka_unit_test(test_bounds_hold_what_is_between_samples),
        cmocka_unit_test(test_plane),
        cmocka_unit_test(test_ratio_of_a_plane),
        cmocka_unit_test(test_past_a_ball),
    };
    return cmocka_run_group_tests_name("cover", tests, NULL, NULL);
}
