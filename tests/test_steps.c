// test_steps.c - one ray's march, step by step: which of it a slice shows, where its steps are in
// the picture of another camera, and the graph of the distance along it.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "../common/picture/aside.h"
#include "../common/picture/plot.h"
#include "support_gpu.h"
#include "support_mirror.h"

enum { WIDTH = 640, HEIGHT = 360 };

static struct renderer_inputs inputs_of(const struct camera *camera, int x, int y)
{
    return (struct renderer_inputs){.width = WIDTH,
                                    .height = HEIGHT,
                                    .camera = *camera,
                                    .samples = 1,
                                    .pixel = {x, y},
                                    .zoom = 1.0f};
}

static struct probe *probe_of(const struct renderer_inputs *inputs)
{
    struct probe *probe = calloc(1, sizeof *probe);
    assert_non_null(probe);
    assert_true(renderer_probe(&gpu.renderer, inputs, inputs->pixel[0], inputs->pixel[1], probe));
    return probe;
}

static float *view_of(const struct renderer_inputs *inputs, enum shader_view view)
{
    assert_true(renderer_set_view(&gpu.renderer, view));
    float *values = gpu_numbers(inputs);
    assert_non_null(values);
    assert_true(renderer_set_view(&gpu.renderer, SHADER_PICTURE));
    return values;
}

static double dark_at(const float *values, double x, double y)
{
    return 1.0 - (double)values[4 * ((int)y * WIDTH + (int)x)];
}

// ---- The slice as far as a step ----

// Nothing within 0.5 of anywhere: step k stands at 0.5 k, and there are nine.
static const char equal_steps[] = "#include \"main.glsl\"\n"
                                  "#include \"march.glsl\"\n"
                                  "Ray pixelRay(vec2 screen)\n"
                                  "{\n"
                                  "    return Ray(vec3(0.0), vec3(0.0, 0.0, -1.0));\n"
                                  "}\n"
                                  "float sceneDistance(vec3 p) { return 0.5; }\n"
                                  "vec3 rayColour(Ray ray)\n"
                                  "{\n"
                                  "    march(ray, 0.0, 4.25, 0.001, 1000);\n"
                                  "    return vec3(0.0);\n"
                                  "}\n";

// Under each position its circle's lowest point is ink where the step is shown, and nowhere else.
static void a_slice_shows_the_circles_up_to_a_step(void **unused)
{
    (void)unused;
    const struct camera camera = {.position = {0.0f, 0.0f, 0.0f}};
    assert_true(gpu_load_text(equal_steps));
    struct renderer_inputs inputs = inputs_of(&camera, 320, 180);
    struct probe *probe = probe_of(&inputs);
    assert_int_equal(probe->steps, 9);
    struct slice_frame frame = slice_frame_of(probe, WIDTH, HEIGHT, 1.0f);
    for (int shown = 0; shown <= 9; shown++) {
        inputs.shown = (float)shown;
        float *values = view_of(&inputs, SHADER_SLICE);
        for (int k = 0; k < 9; k++) {
            double x = (0.5 * k - (double)frame.left) / (double)frame.unit;
            double y = (-0.5 - (double)frame.bottom) / (double)frame.unit;
            assert_int_equal(dark_at(values, x, y) > 0.45, shown == 0 || k < shown);
        }
        // One stands at the last of them, and the arrow goes half way to the next.
        double here = (0.5 * (shown - 1) - (double)frame.left) / (double)frame.unit;
        const float *dot = values + 4 * (HEIGHT / 2 * WIDTH + (int)here);
        if (shown > 0)
            assert_true(dot[0] > 0.7f && dot[1] < 0.1f);
        const float *arrow = dot + 4 * (int)(0.2 / (double)frame.unit);
        if (shown > 0)
            assert_int_equal(arrow[0] > 0.7f && arrow[1] < 0.1f, shown < 9);
        free(values);
    }
    free(probe);
}

// Between two steps the circle of the next one grows: its lowest point comes down.
static void a_film_is_between_two_steps(void **unused)
{
    (void)unused;
    const struct camera camera = {.position = {0.0f, 0.0f, 0.0f}};
    assert_true(gpu_load_text(equal_steps));
    struct renderer_inputs inputs = inputs_of(&camera, 320, 180);
    struct probe *probe = probe_of(&inputs);
    struct slice_frame frame = slice_frame_of(probe, WIDTH, HEIGHT, 1.0f);
    double x = (1.0 - (double)frame.left) / (double)frame.unit, before = 0.0;
    for (int i = 0; i <= 4; i++) {
        inputs.shown = 2.0f + 0.25f * (float)i; // from step 1 to step 2, at 1
        float *values = view_of(&inputs, SHADER_SLICE);
        double lowest = 0.0;
        for (int y = HEIGHT / 2 - 8; y > 40; y--) // under the dot, above the axis
            if (dark_at(values, x, y) > 0.45)
                lowest = HEIGHT / 2 - y;
        if (i <= 2)
            assert_true(lowest < 12.0);
        else
            assert_true(lowest > before + 10.0);
        before = lowest;
        free(values);
    }
    free(probe);
}

// ---- A ray that stays in space ----

static const struct camera second = {.position = {3.6f, 1.9f, 2.2f}, .pan = -58.0f, .tilt = -20.0f};

// The place of a point in the picture of a perspective or a parallel view, in double precision.
//   half  half the height of what a parallel view shows; 0: perspective
static bool project(const struct camera *camera, const float p[3], double half, double place[2])
{
    struct camera_basis basis = camera_basis_of(camera);
    double along[3] = {0.0, 0.0, 0.0};
    for (int i = 0; i < 3; i++) {
        double way = (double)p[i] - (double)camera->position[i];
        along[0] += way * (double)basis.right[i];
        along[1] += way * (double)basis.up[i];
        along[2] += way * (double)basis.forward[i];
    }
    double scale = half > 0.0 ? 1.0 / half : MIRROR_FOCAL_LENGTH / along[2];
    place[0] = 0.5 * WIDTH + 0.5 * HEIGHT * scale * along[0];
    place[1] = 0.5 * HEIGHT + 0.5 * HEIGHT * scale * along[1];
    return along[2] > 0.01;
}

static int check_places(const struct probe *probe, const struct camera *camera, double half)
{
    int seen = 0;
    for (int k = 0; k < probe_rows(probe); k++) {
        const struct probe_step *step = &probe->step[k];
        double place[2];
        bool before = project(camera, step->position, half, place);
        if (!before || fabs(place[0]) > 4000.0 || fabs(place[1]) > 4000.0)
            continue;
        assert_true(step->seen);
        for (int i = 0; i < 2; i++)
            assert_true(fabs((double)step->place[i] - place[i]) < 0.02 + 1e-4 * fabs(place[i]));
        seen++;
    }
    return seen;
}

static void the_places_are_those_of_the_other_camera(void **unused)
{
    (void)unused;
    struct camera first;
    assert_true(gpu_load("chapters/01_normal_colouring.frag"));
    assert_true(mirror_camera(gpu.root, "01_normal_colouring", &first));
    struct renderer_inputs own = inputs_of(&first, 340, 140), inputs = inputs_of(&second, 340, 140);
    struct renderer_eye eye = aside_eye(&gpu.renderer, &own);
    inputs.eye = &eye;
    struct probe *probe = probe_of(&inputs), *from = probe_of(&own);
    assert_true(probe->aside && !from->aside);
    own.eye = &eye; // whose camera is the picture's own
    struct probe *again = probe_of(&own);
    assert_false(again->aside);
    free(again);
    assert_int_equal(probe->steps, from->steps);
    for (int k = 0; k < probe->steps; k++) { // the same ray, to the bit
        assert_memory_equal(&probe->step[k].t, &from->step[k].t, sizeof(float));
        assert_memory_equal(probe->step[k].position, from->step[k].position, 3 * sizeof(float));
        assert_true(from->step[k].seen && from->step[k].place[0] == 340.5f &&
                    from->step[k].place[1] == 140.5f);
    }
    assert_memory_equal(probe->colour, from->colour, 3);
    int seen = check_places(probe, &second, 0.0);
    print_message("# %d of %d steps have a place\n", seen, probe->steps);
    assert_true(seen >= 8);
    free(probe);
    // A camera beside the ray sees what is in front of it alone.
    inputs.camera = (struct camera){.position = {0.9f, 0.1f, 1.0f}, .pan = -30.0f, .tilt = -10.0f};
    probe = probe_of(&inputs);
    int behind = 0;
    for (int k = 0; k < probe->steps; k++) {
        double place[2];
        bool before = project(&inputs.camera, probe->step[k].position, 0.0, place);
        assert_true(before || !probe->step[k].seen);
        behind += !before;
    }
    seen = check_places(probe, &inputs.camera, 0.0);
    print_message("# %d steps behind a third camera, %d before it\n", behind, seen);
    assert_true(behind >= 2 && seen >= 5);
    free(from);
    free(probe);
}

// The wheel and Tab change the picture's view, and the ray stays; a parallel view has places too.
static void a_parallel_view_has_places(void **unused)
{
    (void)unused;
    assert_true(gpu_load("chapters/08_orthographic_view.frag"));
    struct parameters *all = &gpu.renderer.parameters;
    assert_true(parameters_assign(all, "orthographic=0"));
    struct camera first;
    assert_true(mirror_camera(gpu.root, "08_orthographic_view", &first));
    struct renderer_inputs own = inputs_of(&first, 300, 160), inputs = own;
    struct renderer_eye eye = aside_eye(&gpu.renderer, &own);
    struct probe *from = probe_of(&own);
    inputs.eye = &eye;
    assert_true(parameters_assign(all, "orthographic=1"));
    struct probe *probe = probe_of(&inputs);
    assert_true(probe->aside);
    assert_int_equal(probe->steps, from->steps);
    assert_memory_equal(probe->step[2].position, from->step[2].position, 3 * sizeof(float));
    const struct parameter *framing = parameters_find(all, "framingDistance");
    const struct parameter *focal = parameters_find(all, "focalLength");
    assert_non_null(framing);
    int seen = check_places(probe, &first, framing->value[0] / focal->value[0]);
    print_message("# %d of %d steps have a place\n", seen, probe->steps);
    assert_true(seen >= 5);
    free(from);
    free(probe);
}

// A view of its own: the angle to the view grows evenly from the middle.
static const char round_view[] =
    "#include \"main.glsl\"\n"
    "#include \"march.glsl\"\n"
    "Ray pixelRay(vec2 screen)\n"
    "{\n"
    "    float angle = 0.9 * length(screen);\n"
    "    vec2 way = screen / max(length(screen), 1e-6) * sin(angle);\n"
    "    return Ray(iCameraPosition, way.x * iCameraRight + way.y * iCameraUp +\n"
    "               cos(angle) * iCameraForward);\n"
    "}\n"
    "float sceneDistance(vec3 p) { return 0.7; }\n"
    "vec3 rayColour(Ray ray)\n"
    "{\n"
    "    march(ray, 0.0, 12.0, 0.001, 1000);\n"
    "    return vec3(0.0);\n"
    "}\n";

static void any_view_has_places(void **unused)
{
    (void)unused;
    const struct camera first = {.position = {0.0f, 0.0f, 6.0f}};
    const struct camera side = {.position = {-2.0f, 0.5f, 1.0f}, .pan = 40.0f, .tilt = -10.0f};
    assert_true(gpu_load_text(round_view));
    struct renderer_inputs own = inputs_of(&first, 330, 190), inputs = inputs_of(&side, 330, 190);
    struct renderer_eye eye = aside_eye(&gpu.renderer, &own);
    inputs.eye = &eye;
    struct probe *probe = probe_of(&inputs);
    struct camera_basis basis = camera_basis_of(&side);
    int seen = 0;
    for (int k = 0; k < probe->steps; k++) {
        const struct probe_step *step = &probe->step[k];
        double way[3] = {0.0, 0.0, 0.0};
        for (int i = 0; i < 3; i++) {
            double d = (double)step->position[i] - (double)side.position[i];
            way[0] += d * (double)basis.right[i];
            way[1] += d * (double)basis.up[i];
            way[2] += d * (double)basis.forward[i];
        }
        double across = hypot(way[0], way[1]), angle = atan2(across, way[2]);
        double x = 0.5 * (WIDTH + HEIGHT * angle / 0.9 * way[0] / across);
        double y = 0.5 * (HEIGHT + HEIGHT * angle / 0.9 * way[1] / across);
        if (angle < 1.4) {
            assert_true(step->seen && fabs((double)step->place[0] - x) < 0.05 &&
                        fabs((double)step->place[1] - y) < 0.05);
            seen++;
        }
    }
    print_message("# %d places\n", seen);
    assert_true(seen >= 5);
    free(probe);
}

// ---- The plot ----

static void a_plot_has_room_for_every_step(void **unused)
{
    (void)unused;
    static const int sizes[][2] = {{320, 180}, {640, 360}, {1280, 720}, {3840, 2160}};
    const float t[] = {0.0f, 3.0f, 4.0f}, hit[] = {3.0f, 1.0f, -1.5f};
    struct probe *probe = calloc(1, sizeof *probe);
    assert_non_null(probe);
    probe->steps = 3;
    probe->end = PROBE_HIT;
    for (int i = 0; i < 3; i++) {
        probe->step[i].t = t[i];
        probe->step[i].distance = hit[i];
    }
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        int width = sizes[i][0], height = sizes[i][1];
        double cell = floor(height / 180.0);
        struct slice_frame slice = slice_frame_of(probe, width, height, 1.0f);
        struct plot_frame plot = plot_frame_of(probe, width, height, &slice);
        assert_true((double)plot.split == 0.5 * height);
        // The slice's ray runs in the middle of what is above.
        assert_true(fabs(-(double)slice.bottom / (double)slice.unit - 0.75 * height) < 0.01);
        for (int k = 0; k < 3; k++) {
            double y = (double)plot.zero + (double)hit[k] / (double)plot.unit;
            assert_true(y > 13.0 * cell && y < (double)plot.split - 9.0 * cell);
        }
        double shown = ((double)plot.split - 13.0 * cell) * (double)plot.unit;
        double ticks = shown / (double)plot.tick;
        assert_true(ticks > 2.0 && ticks < 9.0);
        double said = plot.digits[0] / pow(10.0, plot.digits[1]);
        assert_true(fabs(said - (double)plot.tick) < 1e-6);
    }
    free(probe);
}

static const float *plot_pixel(const float *values, const struct slice_frame *slice,
                               const struct plot_frame *plot, double t, double distance)
{
    double x = (t - (double)slice->left) / (double)slice->unit;
    double y = (double)plot->zero + distance / (double)plot->unit;
    return values + 4 * ((int)floor(y) * WIDTH + (int)floor(x));
}

// The curve is the scene's distance in double precision, the stairs are the march of the table, and
// the dashed line is the threshold that the march was given.
static void the_plot_is_the_distance_and_the_march(void **unused)
{
    (void)unused;
    struct camera camera;
    assert_true(gpu_load("chapters/01_normal_colouring.frag"));
    assert_true(parameters_assign(&gpu.renderer.parameters, "hitThreshold=0.2"));
    assert_true(mirror_camera(gpu.root, "01_normal_colouring", &camera));
    struct renderer_inputs inputs = inputs_of(&camera, 340, 140);
    struct probe *probe = probe_of(&inputs);
    for (int k = 0; k < probe->steps; k++)
        assert_true(fabs((double)probe->step[k].threshold - 0.2) < 1e-6);
    struct slice_frame slice = slice_frame_of(probe, WIDTH, HEIGHT, 1.0f);
    struct plot_frame plot = plot_frame_of(probe, WIDTH, HEIGHT, &slice);
    float *values = view_of(&inputs, SHADER_PLOT);
    struct mirror_ray ray =
        mirror_screen_ray(&camera, MIRROR_FOCAL_LENGTH, mirror_screen_x(340.5, WIDTH, HEIGHT),
                          mirror_screen_y(140.5, HEIGHT));
    double right = (double)slice.left + WIDTH * (double)slice.unit;
    double last = (double)probe->step[probe->steps - 1].t, limit = (double)plot.unit * 12.0;
    int curve = 0, stairs = 0, dashes = 0;
    for (double t = 0.2; t < 0.97 * right; t += 0.05) {
        double distance = mirror_distance(&mirror_scene_01, mirror_at(ray, t), NULL);
        if (distance < 0.2 + limit || distance > (double)probe->step[0].distance)
            continue;
        const float *seen = plot_pixel(values, &slice, &plot, t, distance);
        assert_true(seen[2] > seen[0] || seen[0] < 0.4f); // the curve, or a stair over it
        curve += seen[2] > seen[0] + 0.3f;
    }
    for (int k = 0; k + 1 < probe->steps && (double)probe->step[k + 1].t < right; k++) {
        double from = (double)probe->step[k].t, to = (double)probe->step[k + 1].t;
        if (to - from < 10.0 * (double)slice.unit)
            continue;
        const float *seen = plot_pixel(values, &slice, &plot, 0.3 * from + 0.7 * to,
                                       (double)probe->step[k].distance);
        assert_true(seen[0] < 0.4f);
        stairs++;
    }
    for (double t = 0.5; t < 0.8 * right; t += (double)slice.unit) {
        const float *seen = plot_pixel(values, &slice, &plot, t, 0.2);
        dashes += seen[2] > seen[1] + 0.2f && seen[0] > seen[1] + 0.1f;
    }
    print_message(
        "# %d places of the curve, %d stairs, %d pixels of the threshold's line, to %.2f\n", curve,
        stairs, dashes, last);
    assert_true(curve >= 20 && stairs >= 2 && dashes >= 150);
    free(values);
    free(probe);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_slice_shows_the_circles_up_to_a_step),
        cmocka_unit_test(a_film_is_between_two_steps),
        cmocka_unit_test(the_places_are_those_of_the_other_camera),
        cmocka_unit_test(a_parallel_view_has_places),
        cmocka_unit_test(any_view_has_places),
        cmocka_unit_test(a_plot_has_room_for_every_step),
        cmocka_unit_test(the_plot_is_the_distance_and_the_march),
    };
    return cmocka_run_group_tests_name("steps", tests, gpu_setup, gpu_teardown);
}
