// steps.c - tests the steps of one ray's march: the part of the march that a slice shows, the
// positions of the steps in another camera's picture, and the plot of the distance along the ray.
#include "lib/test.h"
#include "picture/renderer_ray.h"
#include "picture/slice.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

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
    assert_true(renderer_set_view(&gpu.renderer, VIEW_PICTURE));
    return values;
}

static double dark_at(const float *values, double x, double y)
{
    return 1.0 - (double)values[4 * ((int)y * WIDTH + (int)x)];
}

// ---- The slice up to a step ----

// A scene where the distance is 0.5 everywhere: step k is at 0.5 k, and the march has nine steps.
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

// In the second half of the way to the next step, that step's circle grows, so its lowest point
// moves down.
TEST(a_circle_grows_between_two_steps)
{
    const struct camera camera = {.position = {0.0f, 0.0f, 0.0f}};
    assert_true(gpu_load_text(equal_steps));
    struct renderer_inputs inputs = inputs_of(&camera, 320, 180);
    struct probe *probe = probe_of(&inputs);
    struct slice_frame frame = slice_frame_of(probe, WIDTH, HEIGHT, 1.0f);
    double x = (1.0 - (double)frame.left) / (double)frame.unit, before = 0.0;
    for (int i = 0; i <= 4; i++) {
        inputs.shown = 2.0f + 0.25f * (float)i; // from step 1 to step 2, which is at t = 1
        float *values = view_of(&inputs, VIEW_SLICE);
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

// ---- A ray that is pinned in space ----

static const struct camera second = {.position = {3.6f, 1.9f, 2.2f}, .pan = -58.0f, .tilt = -20.0f};

// Find the position of a point in a picture in perspective or in parallel projection, in double
// precision. Returns false if the point is not in front of the camera.
//   half  half the height that a parallel projection shows; 0 for perspective
static bool project(const struct camera *camera, const float p[3], double half, double pixel[2])
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
    pixel[0] = 0.5 * WIDTH + 0.5 * HEIGHT * scale * along[0];
    pixel[1] = 0.5 * HEIGHT + 0.5 * HEIGHT * scale * along[1];
    return along[2] > 0.01;
}

static int check_pixels(const struct probe *probe, const struct camera *camera, double half)
{
    int seen = 0;
    for (int k = 0; k < probe_rows(probe); k++) {
        const struct probe_step *step = &probe->step[k];
        double pixel[2];
        bool before = project(camera, step->position, half, pixel);
        if (!before || fabs(pixel[0]) > 4000.0 || fabs(pixel[1]) > 4000.0)
            continue;
        assert_true(step->seen);
        for (int i = 0; i < 2; i++)
            assert_true(fabs((double)step->pixel[i] - pixel[i]) < 0.02 + 1e-4 * fabs(pixel[i]));
        seen++;
    }
    return seen;
}

TEST(the_positions_are_those_in_the_other_camera_s_picture)
{
    struct camera first;
    first = gpu_open_chapter("01_normal_colouring");
    struct renderer_inputs own = inputs_of(&first, 340, 140), inputs = inputs_of(&second, 340, 140);
    struct renderer_eye eye = renderer_eye_of(&gpu.renderer, &own);
    inputs.eye = &eye;
    struct probe *probe = probe_of(&inputs), *from = probe_of(&own);
    assert_true(probe->pinned && !from->pinned);
    own.eye = &eye; // the ray starts at the picture's own camera
    struct probe *again = probe_of(&own);
    assert_false(again->pinned);
    free(again);
    assert_int_equal(probe->steps, from->steps);
    for (int k = 0; k < probe->steps; k++) { // the same ray, bit for bit
        assert_memory_equal(&probe->step[k].t, &from->step[k].t, sizeof(float));
        assert_memory_equal(probe->step[k].position, from->step[k].position, 3 * sizeof(float));
        assert_true(from->step[k].seen && from->step[k].pixel[0] == 340.5f &&
                    from->step[k].pixel[1] == 140.5f);
    }
    assert_memory_equal(probe->colour, from->colour, 3);
    int seen = check_pixels(probe, &second, 0.0);
    print_message("# %d of %d steps have a position in the picture\n", seen, probe->steps);
    assert_true(seen >= 8);
    free(probe);
    // A camera beside the ray sees only the steps in front of the camera.
    inputs.camera = (struct camera){.position = {0.9f, 0.1f, 1.0f}, .pan = -30.0f, .tilt = -10.0f};
    probe = probe_of(&inputs);
    int behind = 0;
    for (int k = 0; k < probe->steps; k++) {
        double pixel[2];
        bool before = project(&inputs.camera, probe->step[k].position, 0.0, pixel);
        assert_true(before || !probe->step[k].seen);
        behind += !before;
    }
    seen = check_pixels(probe, &inputs.camera, 0.0);
    print_message("# %d steps are behind a third camera, %d steps are in front of it\n", behind,
                  seen);
    assert_true(behind >= 2 && seen >= 5);
    free(from);
    free(probe);
}

// A custom projection: the angle between a pixel's ray and the view direction is proportional to
// the pixel's distance from the centre of the picture.
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

TEST(any_projection_has_positions)
{
    const struct camera first = {.position = {0.0f, 0.0f, 6.0f}};
    const struct camera side = {.position = {-2.0f, 0.5f, 1.0f}, .pan = 40.0f, .tilt = -10.0f};
    assert_true(gpu_load_text(round_view));
    struct renderer_inputs own = inputs_of(&first, 330, 190), inputs = inputs_of(&side, 330, 190);
    struct renderer_eye eye = renderer_eye_of(&gpu.renderer, &own);
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
            assert_true(step->seen && fabs((double)step->pixel[0] - x) < 0.05 &&
                        fabs((double)step->pixel[1] - y) < 0.05);
            seen++;
        }
    }
    print_message("# %d steps have a position in the picture\n", seen);
    assert_true(seen >= 5);
    free(probe);
}

// ---- The plot ----

TEST(a_plot_has_room_for_every_step)
{
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
        struct plot_frame plot = plot_frame_of(probe, 1, width, height, &slice);
        assert_true((double)plot.split == 0.5 * height);
        // The ray of the slice is in the middle of the picture's upper half.
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

TESTS(gpu_setup, gpu_teardown)
