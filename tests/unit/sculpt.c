// sculpt.c - tests shaders/textures/sculpt.c, which adds clay to a grid of distances or takes clay
// away. The results are compared with distances in double precision.
#include "lib/test.h"

#include "textures/elephant.h"
#include "memory.h"
#include "textures/paint.h"
#include "textures/sculpt.h"

enum { SIDE = ELEPHANT_SIDE, POINTS = SIDE * SIDE * SIDE, BYTES = SCULPT_BYTES * POINTS };

static const double cell = 2.0 / (SIDE - 1), BALL = 0.5;

static void point_of(int i, double p[3])
{
    p[0] = elephant_coordinate(i % SIDE);
    p[1] = elephant_coordinate(i / SIDE % SIDE);
    p[2] = elephant_coordinate(i / SIDE / SIDE);
}

static double length(const double p[3])
{
    return sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
}

static double stored(const unsigned char *grid, int i)
{
    return (2.0 * (256 * grid[4 * i] + grid[4 * i + 1]) / 65535.0 - 1.0) * ELEPHANT_RANGE;
}

// Make the grid of a ball around the centre. The caller frees the grid.
static unsigned char *ball(void)
{
    unsigned char *grid = memory_zeros(BYTES, 1);
    for (int i = 0; i < POINTS; i++) {
        double p[3];
        point_of(i, p);
        elephant_encode(length(p) - BALL, grid + 4 * i);
    }
    return grid;
}

// Two points on the ball, 0.28 apart, and the distance to a roll of clay between them.
static const double from[3] = {0.0, 0.48, 0.14}, to[3] = {0.0, 0.48, -0.14};

static double to_roll(const double p[3], double radius)
{
    double z = fmin(fmax(p[2], -0.14), 0.14);
    const double way[3] = {p[0], p[1] - 0.48, p[2] - z};
    return length(way) - radius;
}

// Carry out a stroke between the two points, in this number of pieces.
//   radius  of the roll of clay; negative to take clay away
static void work(unsigned char *grid, int pieces, double radius)
{
    unsigned char *before = memory_zeros(BYTES, 1);
    memcpy(before, grid, BYTES);
    for (int i = 0; i < pieces; i++) {
        const double a[3] = {0.0, 0.48, 0.14 - 0.28 * i / pieces};
        const double b[3] = {0.0, 0.48, 0.14 - 0.28 * (i + 1) / pieces};
        int slices[2];
        sculpt_piece(grid, before, a, b, radius, slices);
    }
    free(before);
}

// Check the distances outside the blend. If clay is added, the distance is the smaller of the
// distances to the ball and to the roll. If clay is taken away, the distance near the surface is
// the larger of the distance to the ball and the negated distance to the roll.
static void assert_near_truth(double radius)
{
    unsigned char *grid = ball();
    double worst = 0.0, beside = 0.0;
    work(grid, 1, radius);
    for (int i = 0; i < POINTS; i++) {
        double p[3];
        point_of(i, p);
        double clay = length(p) - BALL, roll = to_roll(p, fabs(radius));
        double truth = radius > 0.0 ? fmin(clay, roll) : fmax(clay, -roll);
        if (fabs(truth) > ELEPHANT_RANGE || fabs(fabs(clay) - fabs(roll)) < SCULPT_BLEND)
            continue;
        double error = fabs(stored(grid, i) - truth) / cell;
        if (radius > 0.0 && truth > 0.0)
            worst = fmax(worst, error);
        if (fabs(truth) < cell)
            beside = fmax(beside, error);
    }
    print_message("# roll of radius %g: the largest error is %.3f cells outside added clay, and "
                  "%.3f cells beside the surface\n",
                  radius, worst, beside);
    assert_true(worst < 1.0);
    assert_true(beside < 0.3);
    free(grid);
}

TEST(added_clay_has_its_distance)
{
    assert_near_truth(0.12);
}

TEST(clay_that_is_taken_away_leaves_a_groove)
{
    assert_near_truth(-0.12);
}

// Once the whole ball has been taken away, all distances are large, so nothing remains of its
// surface.
TEST(nothing_remains_of_a_surface_that_is_gone)
{
    unsigned char *grid = ball(), *before = ball();
    const double centre[3] = {0.0, 0.0, 0.0};
    double least = 1.0;
    int slices[2];
    sculpt_piece(grid, before, centre, centre, -0.6, slices);
    for (int i = 0; i < POINTS; i++)
        least = fmin(least, stored(grid, i));
    assert_true(least > 0.4);
    free(grid);
    free(before);
}

// The joints of many short pieces do not swell.
TEST(a_stroke_in_pieces_is_the_same_stroke)
{
    unsigned char *whole = ball(), *pieces = ball();
    double worst = 0.0;
    work(whole, 1, 0.12);
    work(pieces, 8, 0.12);
    for (int i = 0; i < POINTS; i++)
        if (fabs(stored(whole, i)) < cell)
            worst = fmax(worst, fabs(stored(whole, i) - stored(pieces, i)) / cell);
    print_message("# largest difference beside the surface: %.4f of a cell\n", worst);
    assert_true(worst < 0.01);
    free(whole);
    free(pieces);
}

// Points whose nearest surface is untouched keep their bytes, and no slices change except those
// reported.
TEST(points_far_from_a_stroke_stay)
{
    unsigned char *grid = ball(), *before = ball();
    int slices[2], changed = 0;
    sculpt_piece(grid, before, from, to, 0.12, slices);
    for (int i = 0; i < POINTS; i++) {
        double p[3];
        point_of(i, p);
        bool same = memcmp(grid + 4 * i, before + 4 * i, 4) == 0;
        bool far = to_roll(p, 0.12) >= fabs(stored(before, i)) + SCULPT_BLEND;
        int slice = i / SIDE / SIDE;
        assert_true(same || (!far && slice >= slices[0] && slice < slices[1]));
        changed += !same;
    }
    print_message("# changed points: %d of %d\n", changed, POINTS);
    assert_in_range(changed, POINTS / 100, POINTS / 3);
    free(grid);
    free(before);
}

// Strokes outside the grid, of which one has huge coordinates, change nothing.
TEST(a_stroke_outside_changes_nothing)
{
    unsigned char *grid = ball(), *before = ball();
    const double away[][3] = {{3.0, 0.0, 0.0}, {1e9, -1e9, 1e9}, {0.0, -2.0, 0.0}};
    for (int i = 0; i < 3; i++) {
        int slices[2];
        sculpt_piece(grid, before, away[i], away[i], 0.2, slices);
        assert_int_equal(slices[0], slices[1]);
    }
    assert_memory_equal(grid, before, BYTES);
    free(grid);
    free(before);
}

// A roll that leaves the grid is cut off, so that its surface stays inside the cube of the grid.
TEST(clay_stays_in_the_grid)
{
    unsigned char *grid = ball(), *before = ball();
    const double out[3] = {1.5, 0.0, 0.0};
    int slices[2];
    sculpt_piece(grid, before, from, out, 0.2, slices);
    for (int i = 0; i < POINTS; i++) {
        double p[3];
        point_of(i, p);
        if (fmax(fabs(p[0]), fmax(fabs(p[1]), fabs(p[2]))) > SCULPT_REACH + cell)
            assert_true(stored(grid, i) > 0.0);
    }
    free(grid);
    free(before);
}

// After some strokes, no step of a march crosses the surface. A ray towards the clay hits it, and a
// ray in the opposite direction does not.
TEST(steps_are_safe_after_strokes)
{
    unsigned char *grid = ball();
    int crossed = 0;
    work(grid, 3, 0.12);
    work(grid, 1, -0.07);
    work(grid, 2, 0.05);
    for (int n = 0; n < 200000; n++) {
        double p[3], q[3], aside[3], size = 0.0;
        for (int a = 0; a < 3; a++) {
            p[a] = 2.4 * paint_random(n, a, 1) - 1.2;
            aside[a] = paint_random(n, a, 2) - 0.5;
            size += aside[a] * aside[a];
        }
        double value = sculpt_value(grid, p);
        double step = fmax(0.577 * fabs(value), fabs(value) - 1.733 * cell);
        for (int a = 0; a < 3; a++)
            q[a] = p[a] + step * aside[a] / sqrt(size);
        crossed += sculpt_value(grid, q) * value < -1e-9;
    }
    assert_int_equal(crossed, 0);
    const double eye[3] = {0.1, 3.0, 0.0}, down[3] = {0.0, -1.0, 0.0}, up[3] = {0.0, 1.0, 0.0};
    double hit[3];
    assert_true(sculpt_march(grid, eye, down, hit));
    assert_true(fabs(sculpt_value(grid, hit)) < 2e-4);
    assert_false(sculpt_march(grid, eye, up, hit));
    free(grid);
}

TESTS(NULL, NULL)
