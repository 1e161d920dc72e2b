// marches.c - the marches of chapters/experiments/16_marches.glsl: their numbers of evaluations
// compared with marches in double precision, and the surfaces that they find compared with the true
// ones.
#include "lib/test.h"
#include "lib/marches.h"

enum { WIDTH = 96, HEIGHT = 54 };

static const double far = 40.0, threshold = 0.0005;

static double spread_of(int height)
{
    return 1.0 / (height * MIRROR_FOCAL_LENGTH);
}

static struct mirror_ray ray_of(const struct camera *camera, int pixel)
{
    return mirror_screen_ray(camera, MIRROR_FOCAL_LENGTH,
                             mirror_screen_x(pixel % WIDTH + 0.5, WIDTH, HEIGHT),
                             mirror_screen_y(pixel / WIDTH + 0.5, HEIGHT));
}

// True if the march in double precision takes the same number of steps and ends for the same reason
// when its threshold is a few roundings smaller or larger.
static bool settled(int stress, enum march_kind kind, struct mirror_ray ray,
                    const struct mirror_march *march)
{
    for (int side = -1; side <= 1; side += 2) {
        struct mirror_march other =
            march_in_double(stress, kind, ray, far, threshold + side * 2e-6, spread_of(HEIGHT));
        if (other.steps != march->steps || other.end != march->end)
            return false;
    }
    return true;
}

// The march of a pixel ends as the march in double precision does, after the same number of
// evaluations, except where rounding may decide. One pixel in 200 may differ.
static void compare_counts(int stress, enum march_kind kind)
{
    const struct march_scene *scene = &march_scenes[MARCH_STRESS + stress];
    assert_true(march_load(&gpu.renderer, scene, kind));
    struct march_picture picture = march_draw(&gpu.renderer, scene, WIDTH, HEIGHT);
    struct camera camera = march_inputs(scene, WIDTH, HEIGHT).camera;
    long sum = 0, sum_in_double = 0;
    int compared = 0, differ = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        struct mirror_ray ray = ray_of(&camera, i);
        struct mirror_march march =
            march_in_double(stress, kind, ray, far, threshold, spread_of(HEIGHT));
        sum += picture.evaluations[i];
        sum_in_double += march.steps;
        if (!settled(stress, kind, ray, &march))
            continue;
        compared++;
        differ +=
            picture.evaluations[i] != march.steps || picture.found[i] != (march.end == MIRROR_HIT);
    }
    march_free(&picture);
    print_message(
        "# %s, %s: %ld evaluations, in double precision %ld; of %d rays compared, %d differ\n",
        scene->name, march_names[kind], sum, sum_in_double, compared, differ);
    assert_true(compared > WIDTH * HEIGHT * 9 / 10);
    assert_true(differ <= compared / 200);
    assert_true(labs(sum - sum_in_double) <= sum_in_double / 200);
}

TEST(evaluations_are_those_of_a_march_in_double)
{
    for (int stress = 0; stress < 4; stress++)
        for (int kind = 0; kind < MARCH_COARSE; kind++)
            compare_counts(stress, (enum march_kind)kind);
}

// ---- What they find ----

static struct march_picture found_by(const struct march_scene *scene, enum march_kind kind)
{
    assert_true(march_load(&gpu.renderer, scene, kind));
    return march_draw(&gpu.renderer, scene, WIDTH, HEIGHT);
}

// A sound march finds every surface and ends at most one threshold behind it. Where it finds
// something, it is nearer to a surface than its threshold.
static void check_found(int stress, const struct march_picture *picture,
                        const struct camera *camera, double spread,
                        const struct mirror_march *truth)
{
    const double rounding = 1e-5;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        bool hit = truth[i].end == MIRROR_HIT;
        if (hit)
            assert_true(picture->found[i] && picture->t[i] <= truth[i].t + threshold + rounding);
        if (picture->found[i]) {
            struct d3 p = mirror_at(ray_of(camera, i), picture->t[i]);
            assert_true(fabs(march_stress_distance(stress, p)) <
                        threshold + spread * picture->t[i] + rounding);
        }
    }
}

static struct mirror_march *true_hits(int stress, const struct camera *camera)
{
    struct mirror_march *truth = malloc(WIDTH * HEIGHT * sizeof *truth);
    assert_non_null(truth);
    for (int i = 0; i < WIDTH * HEIGHT; i++)
        truth[i] = march_in_double(stress, MARCH_PLAIN, ray_of(camera, i), far, 1e-9, 0.0);
    return truth;
}

TEST(sound_marches_find_the_surface_within_the_threshold)
{
    for (int stress = 0; stress < 4; stress++) {
        const struct march_scene *scene = &march_scenes[MARCH_STRESS + stress];
        struct camera camera = march_inputs(scene, WIDTH, HEIGHT).camera;
        struct mirror_march *truth = true_hits(stress, &camera);
        for (int kind = 0; kind < MARCH_KINDS; kind++)
            if (kind != MARCH_OVERSTEP) {
                struct march_picture picture = found_by(scene, (enum march_kind)kind);
                check_found(stress, &picture, &camera, kind == MARCH_CONE ? spread_of(HEIGHT) : 0.0,
                            truth);
                march_free(&picture);
            }
        free(truth);
    }
}

static struct march_costs costs_in(int scene, enum march_kind kind)
{
    struct march_picture truth = found_by(&march_scenes[scene], MARCH_TIGHT);
    struct march_picture picture = found_by(&march_scenes[scene], kind);
    double eps = parameters_find(&gpu.renderer.parameters, "hitThreshold")->value[0];
    struct march_costs costs = march_costs_of(&picture, &truth, eps);
    march_free(&picture);
    march_free(&truth);
    return costs;
}

TEST(steps_that_nothing_checks_pass_thin_bodies)
{
    struct march_costs torus = costs_in(MARCH_STRESS, MARCH_OVERSTEP),
                       plates = costs_in(MARCH_STRESS + 3, MARCH_OVERSTEP);
    print_message("# missed: %d pixels of the torus, %d of the plates\n", torus.false_misses,
                  plates.false_misses);
    assert_true(torus.false_misses > 10 && plates.false_misses > 200);
}

TEST(no_sound_march_misses_anything_in_the_chapters)
{
    for (int scene = 0; scene < 2; scene++)
        for (int kind = 0; kind < MARCH_KINDS; kind++)
            if (kind != MARCH_OVERSTEP)
                assert_int_equal(costs_in(scene, (enum march_kind)kind).false_misses, 0);
}

TEST(every_scene_of_the_table_compiles)
{
    for (int scene = 0; scene < MARCH_SCENES; scene++)
        assert_true(march_load(&gpu.renderer, &march_scenes[scene], MARCH_COARSE));
}

// ---- Costs ----

TEST(costs_of_a_known_picture_are_right)
{
    int evaluations[16 * 8];
    double t[16 * 8], true_t[16 * 8];
    bool found[16 * 8], truly[16 * 8];
    for (int i = 0; i < 16 * 8; i++) {
        evaluations[i] = i % 16 < 8 ? 2 : 3;
        t[i] = true_t[i] = 5.0;
        found[i] = truly[i] = i % 2;
    }
    evaluations[0] = 10;
    found[0] = true;  // a hit without a surface
    found[1] = false; // a missed surface
    t[3] = 5.02;      // the next surface, behind the true one
    t[5] = 5.005;     // within the threshold
    struct march_picture picture = {16, 8, evaluations, t, found, 0.5},
                         truth = {16, 8, NULL, true_t, truly, 0.0};
    struct march_costs costs = march_costs_of(&picture, &truth, 0.01);
    double mean = (63 * 2 + 10 + 64 * 3) / 128.0 + 0.5;
    assert_true(fabs(costs.evaluations - mean) < 1e-12);
    assert_true(fabs(costs.lockstep - (0.5 * (10 + 3) + 0.5) / mean) < 1e-12);
    assert_int_equal(costs.false_hits, 1);
    assert_int_equal(costs.false_misses, 2);
    int fewest[16 * 8];
    for (int i = 0; i < 16 * 8; i++)
        fewest[i] = -1;
    fewest[0] = 5, fewest[15] = 2;
    assert_true(fabs(march_over_bound(&picture, fewest) - (10.5 + 3.5) / 7.0) < 1e-12);
}

TESTS(gpu_setup, gpu_teardown)
