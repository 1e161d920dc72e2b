// handles.c - tests that handles are where a projection in double precision puts their points, and
// that they follow a pointer, in perspective and in a parallel projection.
#include "lib/test.h"
#include "picture/handles.h"
#include "lib/gpu.h"

enum { WIDTH = 320, HEIGHT = 180 };

#define POINTS                                                                                     \
    "uniform vec2 flat2;  // (0.6, 0.1) handle units: in the plane z = 0\n"                        \
    "uniform float other; // 1 in [0, 2]: no handle\n"                                             \
    "uniform vec2 ground; // (0.5, -1) handle xz units: on the ground\n"                           \
    "uniform vec3 ball;   // (0.3, 0.5, -2) handle units: anywhere\n"                              \
    "uniform vec3 lamp;   // (-0.4, 0.7, 0.2) handle xz units: at its height\n"                    \
    "uniform vec3 behind; // (0, 0, 9) handle units: behind the camera\n"                          \
    "vec3 rayColour(Ray r) { return vec3(flat2 + ground, ball.x + lamp.y + behind.z); }\n"

static const char PERSPECTIVE[] = "#include \"main.glsl\"\n#include \"camera.glsl\"\n"
                                  "Ray pixelRay(vec2 screen) { return perspectiveRay(screen); }\n"
                                  "float sceneDistance(vec3 p) { return p.z; }\n" POINTS;
static const char PARALLEL[] =
    "#include \"main.glsl\"\n#include \"orthographic.glsl\"\n"
    "Ray pixelRay(vec2 screen) { return orthographicRay(screen, 1.5); }\n"
    "float sceneDistance(vec3 p) { return p.z; }\n" POINTS;

static struct renderer_inputs inputs(void)
{
    return (struct renderer_inputs){
        .width = WIDTH,
        .height = HEIGHT,
        .camera = {.position = {0.4f, 1.0f, 4.0f}, .pan = -6.0f, .tilt = -12.0f},
        .samples = 1,
        .pixel = {-1, -1}};
}

// Find the pixel of a point. In perspective, focalLength is 2. Returns false if the point is behind
// the camera.
static bool project(const double p[3], bool parallel, double pixel[2])
{
    const struct renderer_inputs in = inputs();
    const double pan = (double)in.camera.pan * GLM_PI / 180.0,
                 tilt = (double)in.camera.tilt * GLM_PI / 180.0;
    const double right[3] = {cos(pan), 0.0, sin(pan)};
    const double up[3] = {-sin(pan) * sin(tilt), cos(tilt), cos(pan) * sin(tilt)};
    const double forward[3] = {sin(pan) * cos(tilt), sin(tilt), -cos(pan) * cos(tilt)};
    double along[3] = {0.0};
    for (int i = 0; i < 3; i++) {
        double from = p[i] - (double)in.camera.position[i];
        along[0] += from * right[i];
        along[1] += from * up[i];
        along[2] += from * forward[i];
    }
    double scale = parallel ? 1.0 / 1.5 : 2.0 / along[2];
    pixel[0] = 0.5 * (WIDTH + along[0] * scale * HEIGHT);
    pixel[1] = 0.5 * (HEIGHT + along[1] * scale * HEIGHT);
    return along[2] > 0.0;
}

// Set point to the position of a handle.
//   i  index of the handle, in the order of the shader's text
static void point_of(int i, const struct parameter *p, double point[3])
{
    const double third[] = {0.0, p->value[1], p->value[2], p->value[2], p->value[2]};
    point[0] = p->value[0];
    point[1] = i == 1 ? 0.0 : p->value[1];
    point[2] = third[i];
}

TEST(a_handle_is_where_its_point_is)
{
    for (int parallel = 0; parallel < 2; parallel++) {
        struct handle handle[HANDLES_MOST];
        const struct renderer_inputs in = inputs();
        assert_true(gpu_load_text(parallel ? PARALLEL : PERSPECTIVE));
        assert_int_equal(handles_find(&gpu.renderer, &in, handle), 5);
        for (int i = 0; i < 5; i++) {
            double point[3], pixel[2];
            point_of(i, handle[i].parameter, point);
            assert_int_equal(handle[i].seen, project(point, parallel, pixel));
            for (int k = 0; k < 2 && handle[i].seen; k++)
                assert_true(fabs((double)handle[i].pixel[k] - pixel[k]) < 0.05);
        }
    }
}

// A shader with its own main has no rays: its handles lie on the screen.
TEST(without_rays_a_handle_is_a_place_on_the_screen)
{
    struct handle handle[HANDLES_MOST];
    const struct renderer_inputs in = inputs();
    assert_true(gpu_load_text("#version 330 core\nin vec2 FragCoord;\nout vec4 FragColor;\n"
                              "uniform vec2 place; // (0.5, -0.25) handle half screen heights: it\n"
                              "uniform vec3 ball; // (0, 0, 1) handle units: not on the screen\n"
                              "void main() { FragColor = vec4(place, ball.x, 1.0); }\n"));
    assert_int_equal(handles_find(&gpu.renderer, &in, handle), 2);
    assert_true(handle[0].seen && !handle[1].seen);
    assert_true(fabsf(handle[0].pixel[0] - 205.0f) < 1e-3f);
    assert_true(fabsf(handle[0].pixel[1] - 67.5f) < 1e-3f);
    assert_true(handles_drag(&gpu.renderer, &in, handle, 0, (const double[]){100.0, 150.0}));
    assert_true(fabs(handle[0].parameter->value[0] + 0.667) < 1e-9);
    assert_true(fabs(handle[0].parameter->value[1] - 0.667) < 1e-9);
}

// Each handle in front of the camera is dragged to three distant pixels. The coordinate that is
// constant in a handle's plane does not change.
TEST(a_handle_follows_a_pointer)
{
    static const double to[][2] = {{220.0, 90.0}, {60.0, 80.0}, {160.0, 75.0}};
    for (int parallel = 0; parallel < 2; parallel++)
        for (int i = 0; i < 4; i++)
            for (size_t k = 0; k < sizeof to / sizeof *to; k++) {
                struct handle handle[HANDLES_MOST];
                const struct renderer_inputs in = inputs();
                double point[3], pixel[2];
                assert_true(gpu_load_text(parallel ? PARALLEL : PERSPECTIVE));
                assert_int_equal(handles_find(&gpu.renderer, &in, handle), 5);
                struct parameter *p = handle[i].parameter;
                const struct parameter before = *p;
                assert_true(handles_drag(&gpu.renderer, &in, handle, i, to[k]));
                point_of(i, p, point);
                assert_true(project(point, parallel, pixel));
                // Values are rounded to a thousandth of a unit, which is at most half a pixel here.
                if (hypot(pixel[0] - to[k][0], pixel[1] - to[k][1]) >= 0.5)
                    fail_msg("parallel %d: handle %d, dragged to position %zu, is at pixel %g, %g; "
                             "its point is %g, %g, %g",
                             parallel, i, k, pixel[0], pixel[1], point[0], point[1], point[2]);
                if (i == 3)
                    assert_true(before.value[1] == p->value[1]);
                memcpy(p->value, before.value, sizeof p->value);
            }
}

// A handle's value stops at the end of its range, no drag loses a handle, and a handle behind the
// camera does not move.
TEST(a_handle_stays_in_its_range)
{
    struct handle handle[HANDLES_MOST];
    const struct renderer_inputs in = inputs();
    assert_true(gpu_load_text(PARALLEL));
    assert_int_equal(handles_find(&gpu.renderer, &in, handle), 5);
    for (int i = 0; i < 80; i++)
        handles_drag(&gpu.renderer, &in, handle, 0, (const double[]){1e6, 0.0});
    assert_true(handle[0].parameter->value[0] == 10.0);
    assert_false(handles_drag(&gpu.renderer, &in, handle, 0, (const double[]){1e6, 100.0}) &&
                 handle[0].parameter->value[0] != 10.0);
    assert_false(handles_drag(&gpu.renderer, &in, handle, 4, (const double[]){10.0, 0.0}));
    assert_true(gpu_load_text(PERSPECTIVE));
    assert_int_equal(handles_find(&gpu.renderer, &in, handle), 5);
    for (int i = 0; i < 80; i++)
        handles_drag(&gpu.renderer, &in, handle, 1,
                     (const double[]){160.0, i < 40 ? 400.0 : -400.0});
    assert_true(handle[1].seen);
}

TESTS(gpu_setup, gpu_teardown)
