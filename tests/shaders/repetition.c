// repetition.c - repeated solids on the GPU, compared with brute force over all copies in double
// precision.
#include "lib/test.h"
#include "lib/cell.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

#define SHADER "tests/shaders/repetition.frag"

enum { WIDE = 256, ROWS = 64, ITEMS = WIDE * ROWS };

// The functions that Time selects in the shader.
enum {
    SYMMETRIC,
    LIMITED,
    MIRRORED,
    PLANK_OWN,
    PLANK_BOTH,
    PLANK_LIMITED,
    PLANK_GHOSTS,
    OFFSET_OWN,
    OFFSET_BOTH,
    TOWERS,
    TOWERS_CAPPED,
    ROW,
    ROW_LIMITED,
    LONELY
};

// ---- One copy ----

static double symmetric(struct d3 q)
{
    return fmin(brute_box(q, d3(0.9, 0.3, 0.5)), d3_length(q) - 0.7);
}

static double plank(struct d3 q)
{
    const double c = cos(MIRROR_PI / 6.0), s = 0.5;
    return brute_box(d3(c * q.x - s * q.z, q.y, s * q.x + c * q.z), d3(1.2, 1.0, 0.2));
}

static double offset_ball(struct d3 q)
{
    return d3_length(d3_sub(q, d3(1.5, 0.0, 0.0))) - 0.4;
}

static double tower(struct d3 q, int x, int z)
{
    double tall = 0.25 + 5.75 * cell_hash(x, 0, z);
    return brute_box(d3(q.x, q.y - tall, q.z), d3(0.8, tall, 0.8));
}

// The distance from q to the copy in the cell x, z. q is relative to the centre of this cell.
static double copy(int function, struct d3 q, int x, int z)
{
    if (function <= LIMITED)
        return symmetric(q);
    if (function == MIRRORED)
        return plank(d3(x % 2 == 0 ? q.x : -q.x, q.y, q.z));
    if (function <= PLANK_GHOSTS)
        return plank(q);
    return function <= OFFSET_BOTH ? offset_ball(q) : tower(q, x, z);
}

// ---- All copies ----

struct field {
    int function;
    float v[4]; // period, number of axes, first and last cell
};

static int nearest_cell(const struct field *field, int axis, double x)
{
    return (double)field->v[1] > axis ? (int)lround(x / (double)field->v[0]) : 0;
}

// The first and the last cell to try along an axis: the cells near x, or all cells if their number
// is limited.
static void cells_tried(const struct field *field, int axis, double x, int range[2])
{
    int reach = (double)field->v[1] > axis ? (field->function < TOWERS ? 2 : 7) : 0;
    int middle = nearest_cell(field, axis, x);
    range[0] = middle - reach;
    range[1] = middle + reach;
    if (field->v[3] > field->v[2] && reach > 0) {
        range[0] = (int)field->v[2];
        range[1] = (int)field->v[3];
    }
}

// The distance to the nearest of all copies. Axes are repeated in the order x, z, y.
static double brute(const struct field *field, struct d3 p)
{
    int xs[2], ys[2], zs[2];
    double period = (double)field->v[0], nearest = 1e9;
    cells_tried(field, 0, p.x, xs);
    cells_tried(field, 1, p.z, zs);
    cells_tried(field, 2, p.y, ys);
    for (int x = xs[0]; x <= xs[1]; x++)
        for (int y = ys[0]; y <= ys[1]; y++)
            for (int z = zs[0]; z <= zs[1]; z++)
                nearest =
                    fmin(nearest, copy(field->function,
                                       d3_sub(p, d3(period * x, period * y, period * z)), x, z));
    return nearest;
}

static float *ask(const struct field *field)
{
    return gpu_call(SHADER, WIDE, ROWS, field->function, field->v);
}

// How far the GPU's distance is above and below the true one, over all points outside the copies.
struct found {
    double over, under; // largest differences, >= 0
    int outside;        // points outside all copies
};

static struct found compare(const struct field *field)
{
    struct found found = {0.0, 0.0, 0};
    float *values = ask(field);
    for (int i = 0; i < ITEMS; i++) {
        double truth = brute(field, d3_of(values + 4 * i));
        if (truth < 0.0)
            continue;
        double error = (double)values[4 * i + 3] - truth;
        found.over = fmax(found.over, error);
        found.under = fmax(found.under, -error);
        found.outside++;
    }
    free(values);
    assert_true(found.outside > ITEMS / 2);
    return found;
}

static const double rounding = 6e-6; // a few roundings, 6e-8 each, of coordinates up to 20

static void check_exact(const char *what, const struct field *field)
{
    struct found found = compare(field);
    print_message("# %s: %d points outside, off by at most %.1e\n", what, found.outside,
                  fmax(found.over, found.under));
    assert_true(found.over < rounding && found.under < rounding);
}

static void check_bound(const char *what, const struct field *field)
{
    struct found found = compare(field);
    print_message("# %s: at most %.1e too large, up to %.2f too small\n", what, found.over,
                  found.under);
    assert_true(found.over < rounding && found.under > 0.1);
}

// The largest overestimate must be within 3 per cent of the expected one.
static void check_over(const char *what, const struct field *field, double expected)
{
    struct found found = compare(field);
    print_message("# %s: overestimates by up to %.3f\n", what, found.over);
    assert_true(fabs(found.over / expected - 1.0) < 0.03);
}

TEST(test_symmetric_copies_are_exact_outside)
{
    check_exact("one axis", &(struct field){SYMMETRIC, {2.5f, 1.0f, 0.0f, 0.0f}});
    check_exact("two axes", &(struct field){SYMMETRIC, {2.5f, 2.0f, 0.0f, 0.0f}});
    check_exact("three axes", &(struct field){SYMMETRIC, {2.5f, 3.0f, 0.0f, 0.0f}});
    check_exact("cells -2 to 1", &(struct field){LIMITED, {2.5f, 2.0f, -2.0f, 1.0f}});
}

TEST(test_mirrored_copies_need_no_correction)
{
    check_exact("mirrored planks", &(struct field){MIRRORED, {2.5f, 1.0f, 0.0f, 0.0f}});
}

TEST(test_one_copy_overestimates)
{
    check_over("ball 1.5 aside", &(struct field){OFFSET_OWN, {4.0f, 1.0f, 0.0f, 0.0f}}, 3.0);
    check_over("plank", &(struct field){PLANK_OWN, {2.5f, 1.0f, 0.0f, 0.0f}}, 0.94);
}

TEST(test_the_nearer_neighbour_corrects_identical_copies)
{
    check_exact("ball, both", &(struct field){OFFSET_BOTH, {4.0f, 1.0f, 0.0f, 0.0f}});
    check_exact("plank, both", &(struct field){PLANK_BOTH, {2.5f, 1.0f, 0.0f, 0.0f}});
    check_exact("plank, -2 to 1", &(struct field){PLANK_LIMITED, {2.5f, 1.0f, -2.0f, 1.0f}});
    struct found ghosts = compare(&(struct field){PLANK_GHOSTS, {2.5f, 1.0f, -2.0f, 1.0f}});
    print_message("# neighbours that do not exist: a distance too small by up to %.2f\n",
                  ghosts.under);
    assert_true(ghosts.under > 1.0 && ghosts.over < rounding);
}

TEST(test_copies_that_vary_need_the_wall)
{
    // Towers 1.6 wide fill cells 1.6 wide, so another tower may be as near as the wall.
    check_bound("towers, capped", &(struct field){TOWERS_CAPPED, {1.6f, 2.0f, 0.0f, 0.0f}});
    check_bound("towers -2 to 1", &(struct field){ROW_LIMITED, {1.6f, 1.0f, -2.0f, 1.0f}});
    check_bound("own tower and cellOthers", &(struct field){LONELY, {2.0f, 2.0f, 0.0f, 0.0f}});
    struct found four = compare(&(struct field){TOWERS, {2.0f, 2.0f, 0.0f, 0.0f}});
    struct found three = compare(&(struct field){ROW, {2.0f, 1.0f, 0.0f, 0.0f}});
    print_message("# without a cap, the distance to four towers of a field is too large by up to "
                  "%.2f, to three towers of a row by up to %.2f\n",
                  four.over, three.over);
    assert_true(four.over > 1.0 && three.over > 1.0);
}

// ---- Is the capped distance continuous? ----

// A lower bound of the distance to the tower of a cell: `share` times the distance.
static double tower_in(struct d3 p, double period, int x, int z, double share)
{
    return share * tower(d3_sub(p, d3(period * x, 0.0, period * z)), x, z);
}

// The smaller of cellOthers and the bound for the cell's own tower. Cells are 2 wide, and a tower
// reaches 0.8 from the centre of its cell.
static double own_and_others(struct d3 p, double share)
{
    int x = (int)floor(p.x / 2.0 + 0.5), z = (int)floor(p.z / 2.0 + 0.5);
    double cap = 2.0 - fmax(fabs(p.x - 2.0 * x), fabs(p.z - 2.0 * z)) - 0.8;
    return fmin(tower_in(p, 2.0, x, z, share), cap);
}

// The smallest of the bounds for four towers: that of p's cell and those of the three cells nearest
// to p. The towers fill cells 1.6 wide. cellWall is left out.
static double block_alone(struct d3 p, double share)
{
    int x = (int)floor(p.x / 1.6 + 0.5), z = (int)floor(p.z / 1.6 + 0.5);
    int side_x = p.x < 1.6 * x ? -1 : 1, side_z = p.z < 1.6 * z ? -1 : 1;
    double nearest = INFINITY;
    for (int i = 0; i < 4; i++) {
        int k = x + i % 2 * side_x, l = z + i / 2 * side_z;
        nearest = fmin(nearest, tower_in(p, 1.6, k, l, share));
    }
    return nearest;
}

// The smaller of block_alone and cellWall.
static double block_and_wall(struct d3 p, double share)
{
    double x = fabs(p.x - 1.6 * floor(p.x / 1.6 + 0.5)),
           z = fabs(p.z - 1.6 * floor(p.z / 1.6 + 0.5));
    return fmin(block_alone(p, share), 0.8 + fmin(x, z));
}

static double chance(void)
{
    static uint32_t state = 12345u;
    state = state * 1664525u + 1013904223u;
    return (double)(state >> 8) / 16777216.0;
}

// The largest change of a distance per unit of length, between random points and points beside
// them. Most of the points are near the walls or centres of cells, where other copies begin to be
// evaluated.
static double steepest(double (*distance)(struct d3 p, double share), double period, double share)
{
    double slope = 0.0;
    for (int i = 0; i < 300000; i++) {
        struct d3 p = d3(9.0 * chance() - 4.5, 14.0 * chance(), 9.0 * chance() - 4.5);
        if (i % 3 > 0)
            p.x = 0.5 * period * floor(6.0 * chance() - 3.0) + 1e-3 * (chance() - 0.5);
        if (i % 3 > 1)
            p.z = 0.5 * period * floor(6.0 * chance() - 3.0) + 1e-3 * (chance() - 0.5);
        double way = pow(10.0, -4.0 * chance());
        struct d3 q =
            d3_add(p, d3(way * (chance() - 0.5), way * (chance() - 0.5), way * (chance() - 0.5)));
        double apart = d3_length(d3_sub(p, q));
        if (apart > 1e-6)
            slope = fmax(slope, fabs(distance(p, share) - distance(q, share)) / apart);
    }
    return slope;
}

// Check that the GPU computes the formula whose slope is tested.
static void check_formula(const struct field *field, double (*distance)(struct d3 p, double share))
{
    float *values = ask(field);
    for (int i = 0; i < ITEMS; i++)
        assert_true(fabs((double)values[4 * i + 3] - distance(d3_of(values + 4 * i), 1.0)) <
                    rounding);
    free(values);
}

// With the full distances, the distance to a copy that is evaluated only on one side of a wall is
// at least as large as the cap there, so the result does not jump. With half of each distance, the
// result is also a bound, but it jumps.
TEST(test_the_cap_makes_the_distance_continuous)
{
    check_formula(&(struct field){LONELY, {2.0f, 2.0f, 0.0f, 0.0f}}, own_and_others);
    check_formula(&(struct field){TOWERS_CAPPED, {1.6f, 2.0f, 0.0f, 0.0f}}, block_and_wall);
    double own = steepest(own_and_others, 2.0, 1.0), block = steepest(block_and_wall, 1.6, 1.0);
    double weak = fmin(steepest(own_and_others, 2.0, 0.5), steepest(block_and_wall, 1.6, 0.5));
    print_message("# largest slope: own copy and cap %.6f, block and wall %.6f; with half of each "
                  "distance, where the result jumps, at least %.0f\n",
                  own, block, weak);
    assert_true(own > 0.99 && own < 1.0 + 1e-8 && block > 0.99 && block < 1.0 + 1e-8);
    assert_true(weak > 10.0);
}

// The distance to the nearest of all towers around a point.
static double all_towers(struct d3 p, double share)
{
    int x = (int)floor(p.x / 1.6 + 0.5), z = (int)floor(p.z / 1.6 + 0.5);
    double nearest = INFINITY;
    for (int i = x - 5; i <= x + 5; i++)
        for (int k = z - 5; k <= z + 5; k++)
            nearest = fmin(nearest, tower_in(p, 1.6, i, k, share));
    return nearest;
}

// The distance along a ray from above the towers to the first tower, at most 30.
static double marched(double (*distance)(struct d3 p, double share), double share, struct d3 from,
                      struct d3 direction)
{
    double t = 0.0, f = 1.0;
    for (int steps = 0; steps < 3000 && t < 30.0 && f > 1e-4; steps++) {
        f = distance(d3_add(from, d3_times(t, direction)), share);
        t += f > 1e-4 ? fmin(f, 6.0) : 0.0;
    }
    return fmin(t, 30.0);
}

// A bound that jumps is also safe: a march with half of each distance and the cap passes through no
// tower. Without the cap, even a march with the full distances passes through some.
TEST(test_a_march_with_a_bound_that_jumps_is_safe)
{
    int jumping = 0, uncapped = 0, hits = 0;
    for (int i = 0; i < 1500; i++) {
        struct d3 from = d3(20.0 * chance(), 12.5, 20.0 * chance());
        struct d3 way = d3(chance() - 0.5, -0.6 * chance(), chance() - 0.5);
        way = d3_times(1.0 / d3_length(way), way);
        double truth = marched(all_towers, 1.0, from, way);
        hits += truth < 30.0;
        // With half the distances, the march may stop 2e-4 in front of a tower, and even earlier if
        // the ray grazes the tower.
        jumping += marched(block_and_wall, 0.5, from, way) > truth + 0.01;
        uncapped += marched(block_alone, 1.0, from, way) > truth + 0.01;
    }
    print_message(
        "# 1500 rays, %d hits: %d pass through a tower with half the distances and the cap, "
        "%d with the full distances and no cap\n",
        hits, jumping, uncapped);
    assert_true(hits > 500 && jumping == 0 && uncapped > 100);
}

TESTS(gpu_setup, gpu_teardown)
