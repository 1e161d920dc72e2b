// solids.c - the distances to the cylinder, the hexagonal prism, the capped cones and the capsule
// of shaders/solids.glsl on the GPU, compared with the distance to the nearest point of the
// surface. swept.c tests extrusions and revolutions. The surface comes only from the description of
// the solid.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/solid.h"

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

TEST(test_cylinder_is_exact)
{
    struct solid solid = {.name = "cylinder", .function = CYLINDER, .number = {0.7f, 0.9f}};
    solid.inside = in_cylinder;
    solid.exact_outside = solid.exact_inside = true;
    double r = (double)solid.number[0], h = (double)solid.number[1];
    solid_add_turned(&solid, 0.0, -h, r, -h);
    solid_add_turned(&solid, r, -h, r, h);
    solid_add_turned(&solid, r, h, 0.0, h);
    solid_check(&solid);
}

TEST(test_capped_cones_are_exact)
{
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
        solid_add_turned(&solid, 0.0, -h, below, -h);
        solid_add_turned(&solid, below, -h, above, h);
        solid_add_turned(&solid, above, h, 0.0, h);
        solid_check(&solid);
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

// The surface has six sides, and in each base three rhombi from the centre to three consecutive
// corners.
TEST(test_hexagonal_prism_is_exact)
{
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
        solid_add_flat(&solid, low, d3_sub(corner[(k + 1) % 6], corner[k]), d3(0.0, 2.0 * h, 0.0));
        double side = k % 2 == 0 ? h : -h;
        solid_add_flat(&solid, d3(0.0, side, 0.0), corner[k], corner[(k + 2) % 6]);
    }
    solid_check(&solid);
}

// The surface is a segment, which is thickened by the capsule's radius.
TEST(test_capsule_is_exact)
{
    struct solid solid = {.name = "capsule", .function = CAPSULE, .number = {0.35f}};
    solid.inside = solid_never;
    solid.thickness = (double)solid.number[0];
    solid.exact_outside = solid.exact_inside = true;
    struct d3 a = d3(-0.5, (double)-0.3f, (double)0.2f),
              b = d3((double)0.4f, (double)0.6f, (double)-0.1f);
    solid_add_flat(&solid, a, d3_sub(b, a), d3(0.0, 0.0, 0.0));
    solid_check(&solid);
}

// ---- Solids that must be equal ----

static void assert_same(struct solid a, struct solid b, double tolerance)
{
    float *first = solid_call(&a), *second = solid_call(&b);
    double worst = 0.0;
    for (int i = 0; i < SOLID_ITEMS * SOLID_SLOTS; i++) {
        const float *one = first + (size_t)4 * (size_t)i, *other = second + (size_t)4 * (size_t)i;
        worst = fmax(worst, fabs((double)one[3] - (double)other[3]) / solid_slack(d3_of(one)));
    }
    free(first);
    free(second);
    print_message("# %s and %s differ by at most %.2f times the allowed error\n", a.name, b.name,
                  worst);
    assert_true(worst <= tolerance);
}

TEST(test_equal_solids_have_equal_distances)
{
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

TESTS(gpu_setup, gpu_teardown)
