// swept.c - the distances to solids that shaders/solids.glsl makes by extruding or revolving a
// plane figure, on the GPU, compared with the distance to the nearest point of the surface. The
// surface comes only from the description of the solid.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/solid.h"

// ---- Extrusions ----

static bool in_ring(const struct solid *solid, struct d3 p)
{
    return fabs(hypot(p.x, p.z) - (double)solid->number[0]) < (double)solid->number[1] &&
           fabs(p.y) < (double)solid->number[2];
}

// The figure has a hole. The distance to it is exact outside and inside, and so is the distance to
// the solid.
TEST(test_extruded_ring_is_exact)
{
    struct solid solid = {.name = "ring", .function = EXTRUDED_RING, .number = {0.8f, 0.3f, 0.5f}};
    solid.inside = in_ring;
    solid.exact_outside = solid.exact_inside = true;
    double h = (double)solid.number[2];
    double x[2] = {(double)solid.number[0] - (double)solid.number[1],
                   (double)solid.number[0] + (double)solid.number[1]};
    for (int k = 0; k < 2; k++) {
        solid_add_turned(&solid, x[k], -h, x[k], h);
        solid_add_turned(&solid, x[0], k ? h : -h, x[1], k ? h : -h);
    }
    solid_check(&solid);
}

static bool in_elbow(const struct solid *solid, struct d3 p)
{
    bool foot = p.x > -0.3 && p.x < 0.9 && p.z > -0.3 && p.z < 0.0;
    bool stem = p.x > -0.3 && p.x < 0.0 && p.z > -0.3 && p.z < 0.9;
    return (foot || stem) && fabs(p.y) < (double)solid->number[0];
}

// The distance to a union of two rectangles is exact outside and a lower bound of the depth inside,
// and so is the distance to the solid.
TEST(test_extruded_elbow_is_exact_outside)
{
    struct solid solid = {.name = "elbow", .function = EXTRUDED_ELBOW, .number = {0.75f}};
    solid.inside = in_elbow;
    solid.exact_outside = true;
    const double corner[6][2] = {{-0.3, -0.3}, {0.9, -0.3}, {0.9, 0.0},
                                 {0.0, 0.0},   {0.0, 0.9},  {-0.3, 0.9}};
    double h = (double)solid.number[0];
    for (int k = 0; k < 6; k++) {
        const double *a = corner[k], *b = corner[(k + 1) % 6];
        solid_add_flat(&solid, d3(a[0], -h, a[1]), d3(b[0] - a[0], 0.0, b[1] - a[1]),
                       d3(0.0, 2.0 * h, 0.0));
    }
    for (int k = 0; k < 2; k++) {
        struct d3 origin = d3(-0.3, k ? h : -h, -0.3);
        solid_add_flat(&solid, origin, d3(1.2, 0.0, 0.0), d3(0.0, 0.0, 0.3));
        solid_add_flat(&solid, origin, d3(0.3, 0.0, 0.0), d3(0.0, 0.0, 1.2));
    }
    struct tally tally = solid_check(&solid);
    assert_true(tally.least[0] < 0.8 && tally.least[1] > 0.999);
}

// If the figure of an extrusion rotates or shrinks with height, the slope may exceed 1, but not the
// bound that docs/10_distance_in_the_plane.md proves. The figure's farthest point from the axis is
// a corner.
TEST(test_twisted_extrusions_keep_the_bound)
{
    const float numbers[][2] = {{0.0f, 0.0f}, {0.0f, 0.3f}, {1.5f, 0.0f}, {3.0f, 0.3f}};
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++) {
        float *values = solid_call(
            &(struct solid){.function = TWISTED, .number = {numbers[k][0], numbers[k][1]}});
        double reach = sqrt(0.5), twist = (double)numbers[k][0], taper = (double)numbers[k][1];
        double bound = sqrt(1.0 + reach * reach * (twist * twist + taper * taper)), most = 0.0;
        for (int i = 0; i < SOLID_ITEMS; i++) {
            const float *slot = values + (size_t)4 * SOLID_SLOTS * (size_t)i;
            struct d3 p = d3_of(slot), q = d3_of(slot + 4);
            double apart = d3_length(d3_sub(p, q));
            if (apart > 1000.0 * solid_slack(p))
                most = fmax(most, fabs((double)slot[3] - (double)slot[7]) / apart);
        }
        free(values);
        print_message("# twist %.1f, taper %.1f: steepest slope %.4f, bound %.4f\n", twist, taper,
                      most, bound);
        assert_true(most <= bound * 1.002 && most > 0.6 * bound);
    }
}

// ---- Revolutions ----

static bool in_turned_disc(const struct solid *solid, struct d3 p)
{
    return hypot(hypot(p.x, p.z) - (double)solid->number[0], p.y) < 1.0;
}

static struct tally check_disc(float centre, bool exact_outside, bool exact_inside)
{
    struct solid solid = {.name = "turned disc", .function = TURNED_DISC, .number = {centre}};
    solid.inside = in_turned_disc;
    solid.exact_outside = exact_outside;
    solid.exact_inside = exact_inside;
    solid_add_turned_circle(&solid, (double)centre, 1.0);
    print_message("# centre %.1f:\n", (double)centre);
    return solid_check(&solid);
}

// A disc of radius 1 with its centre at x = c. If the disc does not cross the axis, the distance to
// the solid is exact. If the disc crosses the axis and its larger part is at x > 0, the distance is
// exact outside; inside, the rim of the part at x < 0 also counts, and the depth is too small. If
// its smaller part is at x > 0, the distance is exact inside and too small outside. If the disc is
// symmetric, the solid is a ball.
TEST(test_turned_discs_are_exact_where_stated)
{
    struct tally apple, lemon;
    check_disc(1.5f, true, true);
    check_disc(1.0f, true, true);
    apple = check_disc(0.8f, true, false);
    check_disc(0.0f, true, true);
    lemon = check_disc(-0.8f, false, true);
    assert_true(apple.least[0] < 0.4 && apple.least[1] > 0.999);
    assert_true(lemon.least[1] < 0.75 && lemon.least[0] > 0.999);
}

static bool in_turned_rectangle(const struct solid *solid, struct d3 p)
{
    double c = cos((double)solid->number[2]), s = sin((double)solid->number[2]);
    double x = hypot(p.x, p.z) - (double)solid->number[3];
    return fabs(c * x + s * p.y) < (double)solid->number[0] &&
           fabs(c * p.y - s * x) < (double)solid->number[1];
}

// A slanting rectangle that does not touch the axis makes a solid to which the distance is exact
// everywhere.
TEST(test_turned_rectangle_is_exact)
{
    struct solid solid = {.name = "turned rectangle",
                          .function = TURNED_RECTANGLE,
                          .number = {0.4f, 0.2f, 0.6f, 0.8f}};
    solid.inside = in_turned_rectangle;
    solid.exact_outside = solid.exact_inside = true;
    double c = cos((double)solid.number[2]), s = sin((double)solid.number[2]), corner[4][2];
    for (int k = 0; k < 4; k++) {
        double a = (k == 0 || k == 3 ? 1.0 : -1.0) * (double)solid.number[0];
        double b = (k < 2 ? 1.0 : -1.0) * (double)solid.number[1];
        corner[k][0] = (double)solid.number[3] + c * a - s * b;
        corner[k][1] = s * a + c * b;
    }
    for (int k = 0; k < 4; k++)
        solid_add_turned(&solid, corner[k][0], corner[k][1], corner[(k + 1) % 4][0],
                         corner[(k + 1) % 4][1]);
    solid_check(&solid);
}

// A stroke that ends on the axis reaches across the axis by half its width. The part beyond the
// axis has its mirror image in the stroke, so the distance is exact outside.
TEST(test_turned_bowl_is_exact_outside)
{
    struct solid solid = {.name = "bowl", .function = TURNED_BOWL, .number = {0.08f}};
    solid.inside = solid_never;
    solid.thickness = (double)solid.number[0];
    solid.exact_outside = true;
    const double point[4][2] = {{0.0, -0.7}, {0.4, -0.7}, {0.9, 0.1}, {0.6, 0.7}};
    for (int k = 0; k < 3; k++)
        solid_add_turned(&solid, point[k][0], point[k][1], point[k + 1][0], point[k + 1][1]);
    solid_check(&solid);
}

static bool in_filled(const struct solid *solid, struct d3 p)
{
    return hypot(p.x, p.z) < 2.0 * (double)solid->number[0] && fabs(p.y) < (double)solid->number[1];
}

// A rectangle with a side on the axis makes a cylinder. Inside the cylinder, that side also counts,
// although no ray can see it: on the axis, the depth is 0.
TEST(test_a_side_on_the_axis_counts_inside)
{
    struct solid solid = {.name = "half a rectangle",
                          .function = TURNED_RECTANGLE,
                          .number = {0.4f, 0.6f, 0.0f, 0.4f}};
    solid.inside = in_filled;
    solid.exact_outside = true;
    solid_add_turned(&solid, 0.0, -(double)0.6f, 2.0 * (double)0.4f, -(double)0.6f);
    solid_add_turned(&solid, 2.0 * (double)0.4f, -(double)0.6f, 2.0 * (double)0.4f, (double)0.6f);
    solid_add_turned(&solid, 2.0 * (double)0.4f, (double)0.6f, 0.0, (double)0.6f);
    struct tally tally = solid_check(&solid);
    assert_true(tally.least[0] < 1e-6);
}

// The values of docs/10_distance_in_the_plane.md at points of the axis, for discs of radius 1.
TEST(test_parts_that_are_not_drawn_count)
{
    const struct {
        float centre, y;
        double asked; // the expected value, to six decimals
    } rows[] = {
        {-0.8f, 1.0f, 0.280625}, // the tip of the lemon is 0.4 away
        {0.8f, 0.0f, -0.2},      // the dimple of the apple is 0.6 away
        {-1.5f, 0.0f, 0.5},      // nothing is drawn
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        float *values = solid_call(
            &(struct solid){.function = TURNED_DISC, .number = {rows[k].centre, 0.0f, rows[k].y}});
        double asked = (double)values[3];
        free(values);
        print_message("# centre %.1f, at height %.1f: %.6f\n", (double)rows[k].centre,
                      (double)rows[k].y, asked);
        assert_true(fabs(asked - rows[k].asked) < 1e-6);
    }
}

TESTS(gpu_setup, gpu_teardown)
