// trace.c - tests every step of one ray's march, as a probe returns it.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/scratch.h"

static struct probe *probe_of(const struct renderer_inputs *inputs, int x, int y)
{
    struct probe *probe = calloc(1, sizeof *probe);
    assert_non_null(probe);
    assert_true(renderer_probe(&gpu.renderer, inputs, x, y, probe));
    return probe;
}

// A probe gives the same steps after a picture with several tiles and samples, and after a picture
// that is smaller than the probe's table.
TEST(a_picture_leaves_no_trace_in_a_probe)
{
    assert_true(gpu_load("chapters/02_lighting.frag"));
    struct renderer_inputs inputs = gpu_inputs(640, 360, 1);
    struct renderer_inputs others[] = {gpu_inputs(700, 530, 2), gpu_inputs(2, 1, 1)};
    struct probe *first = probe_of(&inputs, 320, 100);
    assert_int_equal(first->end, PROBE_HIT);
    assert_true(first->steps >= 3 && first->steps <= 200);
    for (int i = 0; i < 2; i++) {
        assert_true(renderer_draw(&gpu.renderer, &others[i], 0, others[i].height));
        struct probe *again = probe_of(&inputs, 320, 100);
        assert_int_equal(first->steps, again->steps);
        assert_int_equal(first->all_steps, again->all_steps);
        assert_int_equal(first->evaluations, again->evaluations);
        assert_memory_equal(first->step, again->step,
                            (size_t)first->steps * sizeof(struct probe_step));
        free(again);
    }
    free(first);
}

// The rays of this shader start at (screen, 2) and descend to the plane z = 0 at an angle, so that
// each step leaves a fifth of the distance to the plane.
#define TOWARDS_A_PLANE(steps)                                                                     \
    "#include \"main.glsl\"\n"                                                                     \
    "#include \"march.glsl\"\n"                                                                    \
    "#include \"normal.glsl\"\n"                                                                   \
    "Ray pixelRay(vec2 screen) { return Ray(vec3(screen, 2.0), vec3(0.6, 0.0, -0.8)); }\n"         \
    "float sceneDistance(vec3 p) { return p.z; }\n"                                                \
    "vec3 rayColour(Ray ray)\n"                                                                    \
    "{\n"                                                                                          \
    "    Hit hit = march(ray, 0.0, 10.0, 1.0e-4, " steps ");\n"                                    \
    "    march(Ray(ray.origin, vec3(0.0, 0.0, 1.0)), 0.0, 5.0, 1.0e-4, 100);\n"                    \
    "    return normalAt(ray.origin, 0.01);\n"                                                     \
    "}\n"

static void check_probe(const char *text, int steps, enum probe_end end)
{
    assert_true(gpu_load_text(text));
    struct renderer_inputs inputs = gpu_inputs(200, 100, 1);
    struct probe *probe = probe_of(&inputs, 150, 20);
    assert_int_equal(probe->steps, steps);
    assert_int_equal(probe->end, end);
    assert_int_equal(probe->all_steps, steps + 2);
    assert_int_equal(probe->evaluations, steps + 2 + 6);
    assert_true(probe->interval[0] == 0.0f && probe->interval[1] == 10.0f);
    double left = 2.0, t = 0.0;
    for (int i = 0; i < steps; i++) {
        const double expected[3] = {1.01 + 0.6 * t, -0.59, left};
        assert_true(fabs((double)probe->step[i].t - t) < 1e-6);
        assert_true(fabs((double)probe->step[i].distance - left) < 1e-6);
        for (int k = 0; k < 3; k++)
            assert_true(fabs((double)probe->step[i].position[k] - expected[k]) < 1e-6);
        t += left;
        left *= 0.2;
    }
    free(probe);
}

// 2 / 5^n is below the threshold for the first time at n = 7, the eighth step.
TEST(a_probe_shows_every_step)
{
    check_probe(TOWARDS_A_PLANE("100"), 8, PROBE_HIT);
    check_probe(TOWARDS_A_PLANE("5"), 5, PROBE_GAVE_UP);
}

TESTS(gpu_setup, gpu_teardown)
