// test_solids.c - shaders/solids.glsl as the GPU computes it, in double precision against the
// nearest point of the surface itself: of its flat faces, and of the pieces of curves that are
// turned. What the surface is comes from its description alone; no formula of the shader is used
// again.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include <cmocka.h>

#include "support_gpu.h"
#include "support_mirror.h"

#define SHADER "tests/shaders/solids.frag"

enum {
    CYLINDER,
    HEX_PRISM,
    CAPPED_CONE,
    CAPSULE,
    EXTRUDED_RING,
    EXTRUDED_ELBOW,
    TURNED_DISC,
    TURNED_RECTANGLE,
    TURNED_BOWL,
    TURNED_CIRCLE,
    TORUS,
    TWISTED
};
enum { WIDE = 256, SLOTS = 2, ROWS = 8, ITEMS = WIDE * ROWS, GRID = 24, MOST = 16 };

// ---- Surfaces ----

// A piece of a surface: a parallelogram origin + u side + v other, u and v in [0, 1]; or, where
// turned, a segment or an arc of the half-plane x >= 0, turned about the y axis: u along it, v once
// around.
struct patch {
    bool turned, arc;
    struct d3 origin, side, other; // of a parallelogram
    double from[2], to[2];         // of a segment: its ends
    double centre[2], radius;      // of an arc, from angle from[0] to angle to[0]
    struct d3 grid[GRID][GRID];    // points of it
};

static struct d3 patch_at(const struct patch *patch, double u, double v)
{
    if (!patch->turned)
        return d3_add(patch->origin, d3_add(d3_times(u, patch->side), d3_times(v, patch->other)));
    double x = patch->from[0] + u * (patch->to[0] - patch->from[0]);
    double y = patch->from[1] + u * (patch->to[1] - patch->from[1]);
    if (patch->arc) {
        double angle = x;
        x = patch->centre[0] + patch->radius * cos(angle);
        y = patch->centre[1] + patch->radius * sin(angle);
    }
    double turn = 2.0 * MIRROR_PI * v;
    return d3(x * cos(turn), y, x * sin(turn));
}

// The squared distance from p to a piece: the nearest point of a grid (none on the axis), then
// steps that halve, towards whatever is nearer. What remains is less than the last step.
static double patch_distance(const struct patch *patch, struct d3 p)
{
    double best = HUGE_VAL, u = 0.0, v = 0.0;
    for (int i = 0; i < GRID; i++)
        for (int j = 0; j < GRID; j++) {
            struct d3 to = d3_sub(patch->grid[i][j], p);
            double square = d3_dot(to, to);
            if (square < best) {
                best = square;
                u = (i + 0.5) / GRID;
                v = (j + 0.5) / GRID;
            }
        }
    for (double step = 0.5 / GRID; step > 1e-7;) {
        bool moved = false;
        for (int way = 0; way < 4; way++) {
            double a = mirror_clamp(u + (way == 0 ? step : way == 1 ? -step : 0.0));
            double b = v + (way == 2 ? step : way == 3 ? -step : 0.0);
            b = patch->turned ? b : mirror_clamp(b);
            struct d3 to = d3_sub(patch_at(patch, a, b), p);
            double square = d3_dot(to, to);
            if (square <
                best * (1.0 - 1e-12)) { // on the axis every v is the same, but for rounding
                best = square;
                u = a;
                v = b;
                moved = true;
            }
        }
        step *= moved ? 1.0 : 0.5;
    }
    return best;
}

// A solid: its surface, and what lies inside.
struct solid {
    const char *name;
    int function;
    float number[4];
    double thickness; // of a stroke around the surface, which is then a sheet
    bool (*inside)(const struct solid *solid, struct d3 p);
    bool exact_outside, exact_inside;
    int count;
    struct patch patch[MOST];
};

static struct patch *add(struct solid *solid)
{
    assert_true(solid->count < MOST);
    return &solid->patch[solid->count++];
}

static void add_flat(struct solid *solid, struct d3 origin, struct d3 side, struct d3 other)
{
    *add(solid) = (struct patch){.origin = origin, .side = side, .other = other};
}

static void add_turned(struct solid *solid, double x0, double y0, double x1, double y1)
{
    *add(solid) = (struct patch){.turned = true, .from = {x0, y0}, .to = {x1, y1}};
}

// The part with x >= 0 of a circle around (x, 0).
static void add_turned_circle(struct solid *solid, double x, double radius)
{
    double end = x >= radius ? MIRROR_PI : acos(-x / radius);
    *add(solid) = (struct patch){.turned = true,
                                 .arc = true,
                                 .centre = {x, 0.0},
                                 .radius = radius,
                                 .from = {-end, 0.0},
                                 .to = {end, 0.0}};
}

static void fill_grids(struct solid *solid)
{
    for (int k = 0; k < solid->count; k++)
        for (int i = 0; i < GRID; i++)
            for (int j = 0; j < GRID; j++)
                solid->patch[k].grid[i][j] =
                    patch_at(&solid->patch[k], (i + 0.5) / GRID, (j + 0.5) / GRID);
}

static double truth(const struct solid *solid, struct d3 p)
{
    double square = HUGE_VAL;
    for (int k = 0; k < solid->count; k++)
        square = fmin(square, patch_distance(&solid->patch[k], p));
    if (solid->thickness > 0.0)
        return sqrt(square) - solid->thickness;
    return solid->inside(solid, p) ? -sqrt(square) : sqrt(square);
}

// ---- The distances against it ----

static float *call(const struct solid *solid)
{
    return gpu_call(SHADER, WIDE * SLOTS, ROWS, solid->function, solid->number);
}

// A few roundings of numbers no larger than the point and the solid, and what the search leaves.
static double slack_at(struct d3 p)
{
    return 8.0 * MIRROR_FLOAT_ROUNDING * (d3_length(p) + 2.0) + 1e-8;
}

struct tally {
    int inside, outside;
    double worst;    // |f - truth| where exact, in units of the slack
    double least[2]; // f / truth: inside, outside
    double steepest; // |f(p) - f(q)| / |p - q|
};

static void check_point(const struct solid *solid, const float *slot, struct tally *tally)
{
    struct d3 p = d3_of(slot), q = d3_of(slot + 4);
    double f = (double)slot[3], d = truth(solid, p), slack = slack_at(p);
    bool outside = d > 0.0, exact = outside ? solid->exact_outside : solid->exact_inside;
    if (exact)
        tally->worst = fmax(tally->worst, fabs(f - d) / slack);
    // A lower bound on either side, of the right sign.
    assert_true(outside ? f >= -slack && f <= d + slack : f <= slack && f >= d - slack);
    if (fabs(d) > 0.01)
        tally->least[outside] = fmin(tally->least[outside], f / d);
    tally->inside += !outside;
    tally->outside += outside;
    double apart = d3_length(d3_sub(p, q)), change = fabs(f - (double)slot[7]);
    assert_true(change <= apart + slack + slack_at(q));
    if (apart > 0.01)
        tally->steepest = fmax(tally->steepest, change / apart);
}

static struct tally check_solid(struct solid *solid)
{
    struct tally tally = {.least = {HUGE_VAL, HUGE_VAL}};
    fill_grids(solid);
    float *values = call(solid);
    for (int i = 0; i < ITEMS; i++)
        check_point(solid, values + (size_t)4 * SLOTS * (size_t)i, &tally);
    free(values);
    print_message("# %s: %d outside, f/d from %.4f; %d inside, from %.4f; worst error %.2f of the "
                  "rounding; steepest %.4f\n",
                  solid->name, tally.outside, tally.least[1], tally.inside, tally.least[0],
                  tally.worst, tally.steepest);
    assert_true(tally.inside > 20 && tally.outside > 500 && tally.worst <= 1.0);
    assert_true(tally.steepest > 0.98);
    return tally;
}

// ---- Solids ----

static bool in_cone(const struct solid *solid, struct d3 p)
{
    double below = (double)solid->number[0], above = (double)solid->number[1];
    double half = (double)solid->number[2];
    return fabs(p.y) < half &&
           hypot(p.x, p.z) < below + (above - below) * (p.y + half) / (2.0 * half);
}

static bool in_cylinder(const struct solid *solid, struct d3 p)
{
    return fabs(p.y) < (double)solid->number[1] && hypot(p.x, p.z) < (double)solid->number[0];
}

static void test_cylinder(void **unused)
{
    (void)unused;
    struct solid solid = {.name = "cylinder", .function = CYLINDER, .number = {0.7f, 0.9f}};
    solid.inside = in_cylinder;
    solid.exact_outside = solid.exact_inside = true;
    double r = (double)solid.number[0], h = (double)solid.number[1];
    add_turned(&solid, 0.0, -h, r, -h);
    add_turned(&solid, r, -h, r, h);
    add_turned(&solid, r, h, 0.0, h);
    check_solid(&solid);
}

static void test_capped_cones(void **unused)
{
    (void)unused;
    const float numbers[][4] = {{0.9f, 0.3f, 0.7f},
                                {0.2f, 1.0f, 0.5f},
                                {0.8f, 0.0f, 0.8f},
                                {0.5f, 0.5f, 0.5f},
                                {0.1f, 1.4f, 0.1f}};
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++) {
        struct solid solid = {.name = "capped cone", .function = CAPPED_CONE, .inside = in_cone};
        solid.exact_outside = solid.exact_inside = true;
        for (int i = 0; i < 3; i++)
            solid.number[i] = numbers[k][i];
        double below = (double)numbers[k][0], above = (double)numbers[k][1];
        double h = (double)numbers[k][2];
        add_turned(&solid, 0.0, -h, below, -h);
        add_turned(&solid, below, -h, above, h);
        add_turned(&solid, above, h, 0.0, h);
        check_solid(&solid);
    }
}

static bool in_hexagon(const struct solid *solid, struct d3 p)
{
    bool inside = fabs(p.y) < (double)solid->number[1];
    for (int k = 0; k < 6; k++) {
        double angle = MIRROR_PI * k / 3.0;
        inside = inside && p.x * cos(angle) + p.z * sin(angle) < (double)solid->number[0];
    }
    return inside;
}

// Six sides; of each base three rhombi, from the middle to three corners in a row.
static void test_hexagonal_prism(void **unused)
{
    (void)unused;
    struct solid solid = {.name = "prism", .function = HEX_PRISM, .number = {0.6f, 0.8f}};
    solid.inside = in_hexagon;
    solid.exact_outside = solid.exact_inside = true;
    double h = (double)solid.number[1], far = (double)solid.number[0] / cos(MIRROR_PI / 6.0);
    struct d3 corner[6];
    for (int k = 0; k < 6; k++) {
        double angle = MIRROR_PI * (k / 3.0 + 1.0 / 6.0);
        corner[k] = d3(far * cos(angle), 0.0, far * sin(angle));
    }
    for (int k = 0; k < 6; k++) {
        struct d3 low = d3_sub(corner[k], d3(0.0, h, 0.0));
        add_flat(&solid, low, d3_sub(corner[(k + 1) % 6], corner[k]), d3(0.0, 2.0 * h, 0.0));
        double side = k % 2 == 0 ? h : -h;
        add_flat(&solid, d3(0.0, side, 0.0), corner[k], corner[(k + 2) % 6]);
    }
    check_solid(&solid);
}

static bool never(const struct solid *solid, struct d3 p)
{
    (void)solid, (void)p;
    return false;
}

// The segment is the surface, its stroke the rod.
static void test_capsule(void **unused)
{
    (void)unused;
    struct solid solid = {.name = "capsule", .function = CAPSULE, .number = {0.35f}};
    solid.inside = never;
    solid.thickness = (double)solid.number[0];
    solid.exact_outside = solid.exact_inside = true;
    struct d3 a = d3(-0.5, (double)-0.3f, (double)0.2f),
              b = d3((double)0.4f, (double)0.6f, (double)-0.1f);
    add_flat(&solid, a, d3_sub(b, a), d3(0.0, 0.0, 0.0));
    check_solid(&solid);
}

// ---- Extrusions ----

static bool in_ring(const struct solid *solid, struct d3 p)
{
    return fabs(hypot(p.x, p.z) - (double)solid->number[0]) < (double)solid->number[1] &&
           fabs(p.y) < (double)solid->number[2];
}

// A figure with a hole, of which outside and inside are exact: so is the solid.
static void test_extruded_ring(void **unused)
{
    (void)unused;
    struct solid solid = {.name = "ring", .function = EXTRUDED_RING, .number = {0.8f, 0.3f, 0.5f}};
    solid.inside = in_ring;
    solid.exact_outside = solid.exact_inside = true;
    double h = (double)solid.number[2];
    double x[2] = {(double)solid.number[0] - (double)solid.number[1],
                   (double)solid.number[0] + (double)solid.number[1]};
    for (int k = 0; k < 2; k++) {
        add_turned(&solid, x[k], -h, x[k], h);
        add_turned(&solid, x[0], k ? h : -h, x[1], k ? h : -h);
    }
    check_solid(&solid);
}

static bool in_elbow(const struct solid *solid, struct d3 p)
{
    bool foot = p.x > -0.3 && p.x < 0.9 && p.z > -0.3 && p.z < 0.0;
    bool stem = p.x > -0.3 && p.x < 0.0 && p.z > -0.3 && p.z < 0.9;
    return (foot || stem) && fabs(p.y) < (double)solid->number[0];
}

// A union of two rectangles: exact outside, inside a lower bound of the depth; so is the solid.
static void test_extruded_elbow(void **unused)
{
    (void)unused;
    struct solid solid = {.name = "elbow", .function = EXTRUDED_ELBOW, .number = {0.75f}};
    solid.inside = in_elbow;
    solid.exact_outside = true;
    const double corner[6][2] = {{-0.3, -0.3}, {0.9, -0.3}, {0.9, 0.0},
                                 {0.0, 0.0},   {0.0, 0.9},  {-0.3, 0.9}};
    double h = (double)solid.number[0];
    for (int k = 0; k < 6; k++) {
        const double *a = corner[k], *b = corner[(k + 1) % 6];
        add_flat(&solid, d3(a[0], -h, a[1]), d3(b[0] - a[0], 0.0, b[1] - a[1]),
                 d3(0.0, 2.0 * h, 0.0));
    }
    for (int k = 0; k < 2; k++) {
        struct d3 origin = d3(-0.3, k ? h : -h, -0.3);
        add_flat(&solid, origin, d3(1.2, 0.0, 0.0), d3(0.0, 0.0, 0.3));
        add_flat(&solid, origin, d3(0.3, 0.0, 0.0), d3(0.0, 0.0, 1.2));
    }
    struct tally tally = check_solid(&solid);
    assert_true(tally.least[0] < 0.8 && tally.least[1] > 0.999);
}

// An extrusion whose figure turns and shrinks on its way up is steeper than 1: by what the page
// proves, with the farthest point of the figure, a corner.
static void test_twisted_extrusions(void **unused)
{
    (void)unused;
    const float numbers[][2] = {{0.0f, 0.0f}, {0.0f, 0.3f}, {1.5f, 0.0f}, {3.0f, 0.3f}};
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++) {
        float *values =
            call(&(struct solid){.function = TWISTED, .number = {numbers[k][0], numbers[k][1]}});
        double reach = sqrt(0.5), twist = (double)numbers[k][0], taper = (double)numbers[k][1];
        double bound = sqrt(1.0 + reach * reach * (twist * twist + taper * taper)), most = 0.0;
        for (int i = 0; i < ITEMS; i++) {
            const float *slot = values + (size_t)4 * SLOTS * (size_t)i;
            struct d3 p = d3_of(slot), q = d3_of(slot + 4);
            double apart = d3_length(d3_sub(p, q));
            if (apart > 1000.0 * slack_at(p))
                most = fmax(most, fabs((double)slot[3] - (double)slot[7]) / apart);
        }
        free(values);
        print_message("# twist %.1f, taper %.1f: steepest %.4f, bound %.4f\n", twist, taper, most,
                      bound);
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
    add_turned_circle(&solid, (double)centre, 1.0);
    print_message("# centre %.1f:\n", (double)centre);
    return check_solid(&solid);
}

// A disc of radius 1, its centre at c. It keeps clear of the axis: exact. It crosses the axis, and
// its larger part is drawn: exact outside, inside the part at x < 0 makes the rim too near. It is
// symmetric: a ball. Its smaller part is drawn: the other way round.
static void test_turned_discs(void **unused)
{
    (void)unused;
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

// With an offset, clear of the axis, at a slant: exact everywhere.
static void test_turned_rectangle(void **unused)
{
    (void)unused;
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
        add_turned(&solid, corner[k][0], corner[k][1], corner[(k + 1) % 4][0],
                   corner[(k + 1) % 4][1]);
    check_solid(&solid);
}

// A stroke that ends on the axis reaches across it, by its width; what is there has its mirror
// image in the stroke: exact outside.
static void test_turned_bowl(void **unused)
{
    (void)unused;
    struct solid solid = {.name = "bowl", .function = TURNED_BOWL, .number = {0.08f}};
    solid.inside = never;
    solid.thickness = (double)solid.number[0];
    solid.exact_outside = true;
    const double point[4][2] = {{0.0, -0.7}, {0.4, -0.7}, {0.9, 0.1}, {0.6, 0.7}};
    for (int k = 0; k < 3; k++)
        add_turned(&solid, point[k][0], point[k][1], point[k + 1][0], point[k + 1][1]);
    check_solid(&solid);
}

static bool in_filled(const struct solid *solid, struct d3 p)
{
    return hypot(p.x, p.z) < 2.0 * (double)solid->number[0] && fabs(p.y) < (double)solid->number[1];
}

// A rectangle whose side lies on the axis makes a cylinder; but inside it the side counts, which no
// ray can see: on the axis the depth is 0.
static void test_a_side_on_the_axis(void **unused)
{
    (void)unused;
    struct solid solid = {.name = "half a rectangle",
                          .function = TURNED_RECTANGLE,
                          .number = {0.4f, 0.6f, 0.0f, 0.4f}};
    solid.inside = in_filled;
    solid.exact_outside = true;
    add_turned(&solid, 0.0, -(double)0.6f, 2.0 * (double)0.4f, -(double)0.6f);
    add_turned(&solid, 2.0 * (double)0.4f, -(double)0.6f, 2.0 * (double)0.4f, (double)0.6f);
    add_turned(&solid, 2.0 * (double)0.4f, (double)0.6f, 0.0, (double)0.6f);
    struct tally tally = check_solid(&solid);
    assert_true(tally.least[0] < 1e-6);
}

// The numbers of the page: discs of radius 1, and a point of the axis.
static void test_what_is_not_drawn_counts(void **unused)
{
    (void)unused;
    const struct {
        float centre, y;
        double asked; // to six places
    } rows[] = {
        {-0.8f, 1.0f, 0.280625}, // the tip of the lemon is 0.4 away
        {0.8f, 0.0f, -0.2},      // the rim of the apple is 0.6 away
        {-1.5f, 0.0f, 0.5},      // nothing is drawn at all
    };
    for (size_t k = 0; k < sizeof rows / sizeof *rows; k++) {
        float *values = call(
            &(struct solid){.function = TURNED_DISC, .number = {rows[k].centre, 0.0f, rows[k].y}});
        double asked = (double)values[3];
        free(values);
        print_message("# centre %.1f, asked at height %.1f: %.6f\n", (double)rows[k].centre,
                      (double)rows[k].y, asked);
        assert_true(fabs(asked - rows[k].asked) < 1e-6);
    }
}

// ---- What is the same ----

static void assert_same(struct solid a, struct solid b, double tolerance)
{
    float *first = call(&a), *second = call(&b);
    double worst = 0.0;
    for (int i = 0; i < ITEMS * SLOTS; i++) {
        const float *one = first + (size_t)4 * (size_t)i, *other = second + (size_t)4 * (size_t)i;
        worst = fmax(worst, fabs((double)one[3] - (double)other[3]) / slack_at(d3_of(one)));
    }
    free(first);
    free(second);
    print_message("# %s and %s: at most %.2f of the rounding apart\n", a.name, b.name, worst);
    assert_true(worst <= tolerance);
}

static void test_other_roads(void **unused)
{
    (void)unused;
    assert_same(
        (struct solid){.name = "turned circle", .function = TURNED_CIRCLE, .number = {0.8f, 0.3f}},
        (struct solid){.name = "torus", .function = TORUS, .number = {0.8f, 0.3f}}, 0.0);
    assert_same((struct solid){.name = "turned rectangle",
                               .function = TURNED_RECTANGLE,
                               .number = {0.7f, 0.9f, 0.0f, 0.0f}},
                (struct solid){.name = "cylinder", .function = CYLINDER, .number = {0.7f, 0.9f}},
                1.0);
    assert_same(
        (struct solid){
            .name = "straight cone", .function = CAPPED_CONE, .number = {0.7f, 0.7f, 0.9f}},
        (struct solid){.name = "cylinder", .function = CYLINDER, .number = {0.7f, 0.9f}}, 1.0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_cylinder),           cmocka_unit_test(test_capped_cones),
        cmocka_unit_test(test_hexagonal_prism),    cmocka_unit_test(test_capsule),
        cmocka_unit_test(test_extruded_ring),      cmocka_unit_test(test_extruded_elbow),
        cmocka_unit_test(test_twisted_extrusions), cmocka_unit_test(test_turned_discs),
        cmocka_unit_test(test_turned_rectangle),   cmocka_unit_test(test_turned_bowl),
        cmocka_unit_test(test_a_side_on_the_axis), cmocka_unit_test(test_what_is_not_drawn_counts),
        cmocka_unit_test(test_other_roads),
    };
    return cmocka_run_group_tests_name("solids", tests, gpu_setup, gpu_teardown);
}
