// many_parts.c - tests the claims of chapter 22 in double precision. Each method that skips
// parts is compared with the loop over all parts.
#include "lib/test.h"

#include "lib/part_march.h"
#include "textures/paint.h"

#define K REEF_BLEND

static double drawn(int i, uint32_t seed)
{
    return paint_random(i, 0, seed);
}

// The fold of several distances with part_union is at most the smallest distance, and greater than
// the smallest distance minus the width of the blend. The difference is the dip.
TEST(the_dip_is_less_than_the_blend)
{
    assert_true(fabs(part_union(0.0, 0.0, K) + K / 6.0) < 1e-12); // the dip of two equal distances
    double deepest = 0.0, value = 1e9;
    for (int i = 0; i < 1000000; i++) { // equal distances have the deepest dip
        value = part_union(value, 0.0, K);
        deepest = fmax(deepest, -value / K);
    }
    print_message("# the dip of a million equal distances is %.4f of the blend\n", deepest);
    assert_true(deepest > 0.99 && deepest < 1.0);
    for (int trial = 0; trial < 20000; trial++) {
        double least = 1e9;
        value = 1e9;
        for (int i = 0; i < 12; i++) {
            double d = 2.0 * K * drawn(12 * trial + i, 1U);
            least = fmin(least, d);
            value = part_union(value, d, K);
        }
        assert_true(value <= least && value > least - K);
    }
}

// The fold of the distances to parts depends on their order, so all methods keep that order.
TEST(the_fold_is_not_associative)
{
    double k = K, left = part_union(part_union(0.0, 0.5 * k, k), 0.5 * k, k);
    double right = part_union(0.0, part_union(0.5 * k, 0.5 * k, k), k);
    print_message("# the two groupings give distances of %.6f and %.6f blend widths\n", left / k,
                  right / k);
    assert_true(fabs(left - right) > 0.001 * k);
}

// Proof 1 of chapter 22: if a distance that exceeds the smallest by m k is left out, the value of
// the fold rises by at most e^(-3 (m - 1)) k.
TEST(distant_parts_may_be_left_out)
{
    double worst[2] = {0.0, 0.0};
    for (int m = 2; m <= 3; m++)
        for (int trial = 0; trial < 400000; trial++) {
            double all = 1e9, near = 1e9, last = m * K;
            int count = 2 + trial % 6;
            for (int i = 0; i < count; i++) {
                double d = i == count - 1 ? 0.0 : last - 1.2 * K * drawn(8 * trial + i, 2U);
                d = i == 0 ? last : fmax(d, 0.0);
                last = d;
                all = part_union(all, d, K);
                near = i == 0 ? near : part_union(near, d, K); // the first distance is left out
            }
            double loss = (near - all) / K;
            assert_true(loss >= -1e-12 && loss <= exp(-3.0 * (m - 1)));
            worst[m - 2] = fmax(worst[m - 2], loss);
        }
    print_message("# largest loss without a distance of 2 k: %.5f k; without one of 3 k: %.6f k\n",
                  worst[0], worst[1]);
    assert_true(worst[0] > 1e-5);
}

// The loss is larger for a ladder: a thousand distances of m k, which are left out, and then others
// that fall by k / 2 at a time.
TEST(a_ladder_of_parts_loses_more)
{
    static const double expected[2] = {0.0033, 0.00006};
    for (int m = 2; m <= 3; m++) {
        double all = 1e9, near = 1e9;
        for (int i = 0; i < 1000; i++)
            all = part_union(all, m * K, K);
        for (int i = 2 * m - 1; i >= 0; i--) {
            all = part_union(all, 0.5 * i * K, K);
            near = part_union(near, 0.5 * i * K, K);
        }
        double loss = (near - all) / K;
        print_message("# a ladder without distances of %d k: %.5f k\n", m, loss);
        assert_true(loss > 0.95 * expected[m - 2] && loss < exp(-3.0 * (m - 1)));
    }
}

// The rate in proof 1 of chapter 22: a distance that lowers the value of a fold by d k multiplies
// the difference between two folds by at most e^(-3 d).
TEST(a_difference_shrinks_as_the_value_falls)
{
    for (int i = 1; i <= 1000; i++) {
        double h = i / 1000.0, cube = h * h * h / 6.0;
        assert_true(1.0 - 0.5 * h * h <= exp(-3.0 * cube));
        assert_true(0.5 * h * h <= exp(-3.0 * (1.0 - h + cube)));
        assert_true(1.0 - h + cube <= 1.0 - 0.5 * h * h + 1e-12);
    }
}

static struct part_scene *scene;

static int build(void **state)
{
    (void)state;
    scene = part_scene_build(reef_build, 512, K);
    return scene != NULL ? 0 : -1;
}

static int clear(void **state)
{
    (void)state;
    part_scene_free(scene);
    return 0;
}

static void point(int i, double p[3])
{
    const struct part_grid *grid = &scene->grid;
    for (int c = 0; c < 3; c++)
        p[c] = grid->low[c] + grid->size * grid->cells[c] * paint_random(i, c, 3U);
}

// Near the surface, the list of a cell gives the value of all parts, up to the loss of proof 1.
// Outside the surface, the list's value is at least the value of all parts and, once it is capped
// at the margin, at most k greater. In an empty cell, the cell's bound, less the distance to the
// cell's centre, is a lower bound on the value of all parts.
TEST_WITH(the_lists_lose_nothing, build, clear)
{
    int near = 0, empty = 0;
    double worst = 0.0;
    for (int i = 0; i < 20000; i++) {
        double p[3], centre[3];
        point(i, p);
        const struct part_cell *cell = part_grid_cell(&scene->grid, p);
        double all = parts_distance(scene->part, NULL, scene->count, K, p);
        for (int c = 0; c < 3; c++) {
            double at = floor((p[c] - scene->grid.low[c]) / scene->grid.size);
            centre[c] = scene->grid.low[c] + (at + 0.5) * scene->grid.size;
        }
        if (cell->count == 0) {
            double dx = p[0] - centre[0], dy = p[1] - centre[1], dz = p[2] - centre[2];
            double apart = sqrt(dx * dx + dy * dy + dz * dz);
            assert_true(all >= fmax(cell->bound - apart, PART_MARGIN * K - K) - 1e-9);
            empty++;
            continue;
        }
        double few = parts_distance(scene->part, scene->grid.id + cell->first, cell->count, K, p);
        if (all > -K && all < K) {
            worst = fmax(worst, fabs(few - all) / K);
            near++;
        }
        if (all > 0.0)
            assert_true(few >= all - 1e-9 && fmin(few, PART_MARGIN * K) <= all + K);
    }
    print_message(
        "# %d points near the reef: the largest loss is %.6f k; %d points in empty cells\n", near,
        worst, empty);
    assert_true(near > 100 && empty > 5000 && worst < exp(-3.0));
}

// Without a bound, the tree gives the value of all parts. With a bound that is 0.1 too high, it
// skips more parts, and the value changes by at most e^(-3) k.
TEST_WITH(the_tree_loses_nothing, build, clear)
{
    long asked = 0, bounded = 0;
    for (int i = 0; i < 5000; i++) {
        double p[3];
        point(i, p);
        double all = parts_distance(scene->part, NULL, scene->count, K, p);
        assert_true(fabs(part_tree_distance(scene, p, 1e9, &asked) - all) < 1e-12);
        double hint = part_tree_distance(scene, p, all + 0.1, &bounded);
        assert_true(fabs(hint - all) <= exp(-3.0) * K);
    }
    print_message(
        "# of %d parts, the tree evaluates %.1f per point without a bound and %.1f with a bound\n",
        scene->count, (double)asked / 5000.0, (double)bounded / 5000.0);
    assert_true(bounded < asked && asked < 5000L * scene->count);
}

static double mean_asked(int count, enum part_means means, int *hits)
{
    struct part_scene *heap = part_scene_build(part_heap, count, part_heap_blend(count));
    assert_non_null(heap);
    double asked = part_heap_asked(heap, means, hits);
    part_scene_free(heap);
    return asked;
}

// With every method, the same number of rays hit the heap. With the grid, a heap of 128 times as
// many parts takes at most twice as many evaluations per ray.
TEST(the_grid_evaluates_few_parts)
{
    int hits[PARTS_MEANS], few, many;
    for (int means = 0; means < PARTS_MEANS; means++) {
        double asked = mean_asked(512, (enum part_means)means, &hits[means]);
        print_message("# 512 parts, method %d: %.1f evaluations per ray, %d hits\n", means, asked,
                      hits[means]);
        assert_true(hits[means] == hits[PARTS_FLAT] && hits[means] > 100);
    }
    double at_64 = mean_asked(64, PARTS_GRID, &few), at_8192 = mean_asked(8192, PARTS_GRID, &many);
    print_message("# with the grid, %.1f evaluations per ray for 64 parts, %.1f for 8192\n", at_64,
                  at_8192);
    assert_true(at_8192 <= 2.0 * at_64 && few > 100 && many > 100);
}

// Building the lists takes few evaluations of distances: with 8,192 parts, fewer than a thirtieth
// of the number of parts times the number of cells.
TEST(the_lists_are_built_from_few_distances)
{
    struct part_scene *reef = part_scene_build(reef_build, REEF_MOST, K);
    assert_non_null(reef);
    double cells = (double)reef->grid.cells[0] * reef->grid.cells[1] * reef->grid.cells[2];
    print_message(
        "# building the lists of %.0f cells takes %ld distance evaluations, %.1f per cell\n", cells,
        reef->grid.tests, (double)reef->grid.tests / cells);
    assert_true((double)reef->grid.tests < cells * REEF_MOST / 30.0);
    part_scene_free(reef);
}

TESTS(NULL, NULL)
