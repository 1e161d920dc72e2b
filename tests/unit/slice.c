// slice.c - tests the frame of the slice view, and the number of steps that the steps view shows.
// The pictures in tests/references test how a slice is drawn.
#include "lib/test.h"
#include "picture/renderer_ray.h"
#include "picture/slice.h"
#include "lib/gpu.h"
#include "lib/mirror.h"
#include "lib/scratch.h"

enum { WIDTH = 640, HEIGHT = 360 };

// ---- The number of steps ----

// A scene where the distance is 0.5 everywhere, so step k is at 0.5 k. The march of column x takes
// x + 1 steps, because its limit is 0.5 x + 0.25.
static const char equal_steps[] = "#include \"main.glsl\"\n"
                                  "#include \"march.glsl\"\n"
                                  "Ray pixelRay(vec2 screen)\n"
                                  "{\n"
                                  "    float column = screen.x * iResolution.y * 0.5 +\n"
                                  "                   iResolution.x * 0.5 - 0.5;\n"
                                  "    return Ray(vec3(column, 0.0, 0.0), vec3(0.0, 0.0, -1.0));\n"
                                  "}\n"
                                  "float sceneDistance(vec3 p) { return 0.5; }\n"
                                  "vec3 rayColour(Ray ray)\n"
                                  "{\n"
                                  "    float far = 0.5 * ray.origin.x + 0.25;\n"
                                  "    march(ray, 0.0, far, 0.001, 1000);\n"
                                  "    return vec3(0.0);\n"
                                  "}\n";

// In a chapter, the steps view gives a pixel the colour for the number of steps in the pixel's
// probe, whose table a slice draws. The colour for n steps is the colour of column n - 1 in the
// scene above.
TEST(the_steps_view_agrees_with_the_table)
{
    struct renderer_inputs inputs = {.width = WIDTH, .height = HEIGHT, .samples = 1};
    assert_true(gpu_load_text(equal_steps));
    assert_true(renderer_set_view(&gpu.renderer, VIEW_STEPS));
    float *colours = gpu_numbers(&inputs);
    inputs.camera = gpu_open_chapter("01_normal_colouring");
    float *view = gpu_numbers(&inputs);
    struct probe *probe = malloc(sizeof *probe);
    assert_non_null(probe);
    static const int pixel[][2] = {{320, 180}, {340, 140}, {250, 60}, {274, 180}, {10, 300}};
    for (size_t i = 0; i < sizeof pixel / sizeof *pixel; i++) {
        assert_true(renderer_probe(&gpu.renderer, &inputs, pixel[i][0], pixel[i][1], probe));
        int shown = probe->steps < 64 ? probe->steps : 64;
        const float *seen = view + 4 * (pixel[i][1] * WIDTH + pixel[i][0]);
        const float *expected = colours + 4 * (HEIGHT / 2 * WIDTH + shown - 1);
        assert_memory_equal(seen, expected, 4 * sizeof(float));
    }
    free(probe);
    free(view);
    free(colours);
    assert_true(renderer_set_view(&gpu.renderer, VIEW_PICTURE));
}

// ---- The frame ----

static struct slice_frame frame_of(enum probe_end end, const float *t, const float *distance,
                                   int steps, float zoom)
{
    struct probe *probe = calloc(1, sizeof *probe);
    assert_non_null(probe);
    probe->steps = steps;
    probe->end = end;
    for (int i = 0; i < steps; i++) {
        probe->step[i].t = t[i];
        probe->step[i].distance = distance[i];
    }
    struct slice_frame frame = slice_frame_of(probe, WIDTH, HEIGHT, zoom);
    free(probe);
    return frame;
}

static void assert_shows(struct slice_frame frame, double from, double to)
{
    double right = (double)frame.left + WIDTH * (double)frame.unit;
    assert_true((double)frame.left <= from && right >= to);
    double tick = (double)frame.digits[0] / pow(10.0, frame.digits[1]);
    assert_true(fabs(tick - (double)frame.tick) <= 1e-6 * tick);
    double ticks = (right - (double)frame.left) / (double)frame.tick;
    assert_true(ticks > 3.0 && ticks < 9.0);
}

TEST(the_frame_shows_the_march)
{
    const float hit_t[] = {0.0f, 3.0f, 4.0f}, hit[] = {3.0f, 1.0f, 1e-4f};
    assert_shows(frame_of(PROBE_HIT, hit_t, hit, 3, 1.0f), 0.0, 4.2);
    const float miss_t[] = {0.0f, 2.0f, 4.0f, 12.0f, 30.0f},
                miss[] = {2.0f, 0.1f, 8.0f, 18.0f, 40.0f};
    struct slice_frame frame = frame_of(PROBE_PASSED, miss_t, miss, 5, 1.0f);
    assert_shows(frame, 0.0, 2.2);
    assert_true((double)frame.left + WIDTH * (double)frame.unit < 12.0);
    for (int i = 0; i <= 100; i++) {
        double zooms = (double)SLICE_ZOOM_MAXIMUM / (double)SLICE_ZOOM_MINIMUM;
        float zoom = SLICE_ZOOM_MINIMUM * (float)pow(zooms, i / 100.0);
        assert_shows(frame_of(PROBE_PASSED, miss_t, miss, 5, zoom), 2.0, 2.0);
    }
    // For a ray that leaves a surface, such as a shadow ray, the distances grow, and the whole
    // march is inside the frame.
    const float leave_t[] = {0.0f, 0.002f, 0.006f, 1.0f, 3.5f},
                leave[] = {0.002f, 0.004f, 0.994f, 2.5f, 4.0f};
    assert_shows(frame_of(PROBE_PASSED, leave_t, leave, 5, 1.0f), 0.0, 3.4);
    // The frame is valid without a march, for a march that ends where it starts, and if t or the
    // distance is not a number.
    assert_shows(frame_of(PROBE_NO_MARCH, NULL, NULL, 0, 1.0f), 0.0, 1.0);
    const float zero[] = {0.0f}, nan[] = {NAN};
    assert_shows(frame_of(PROBE_HIT, zero, zero, 1, 1.0f), 0.0, 0.5);
    assert_shows(frame_of(PROBE_GAVE_UP, zero, nan, 1, 1.0f), 0.0, 0.5);
    assert_shows(frame_of(PROBE_GAVE_UP, nan, nan, 1, 1.0f), 0.0, 0.5);
    // A zoom of 0 counts as a zoom of 1. For a march that ends beyond 1e9, the frame shows 1 unit
    // and a margin, enlarged around 0.
    assert_shows(frame_of(PROBE_HIT, hit_t, hit, 3, 0.0f), 0.0, 4.2);
    const float far_t[] = {0.0f, 2e9f}, far[] = {2e9f, 1e-4f};
    frame = frame_of(PROBE_HIT, far_t, far, 2, 2.0f);
    assert_float_equal(WIDTH * frame.unit, 0.55f, 1e-5f);
    assert_float_equal(frame.left, -0.05f, 1e-6f);
}

// Beside the numbers of the axis, at the left and right edges of the picture, there is no ink:
// whatever the zoom, no number is cut.
TEST(no_number_of_the_axis_is_cut)
{
    struct renderer_inputs inputs = {.width = WIDTH,
                                     .height = HEIGHT,
                                     .samples = 1,
                                     .pixel = {320, 180},
                                     .camera = gpu_open_chapter("01_normal_colouring")};
    assert_true(renderer_set_view(&gpu.renderer, VIEW_SLICE));
    for (int i = 0; i <= 60; i++) {
        inputs.zoom = (float)pow(1.05, i - 30);
        float *view = gpu_numbers(&inputs);
        for (int row = 6; row < 16; row++)
            for (int edge = 0; edge < 2; edge++) {
                const float *colour = view + 4 * (row * WIDTH + edge * (WIDTH - 1));
                assert_true((double)colour[1] > 0.6);
            }
        free(view);
    }
    assert_true(renderer_set_view(&gpu.renderer, VIEW_PICTURE));
}

// Lines divide a tick whose first digit is 1 or 5 into five parts, and a tick whose first digit is
// 2 into four parts.
TEST(the_lines_are_round_parts_of_a_tick)
{
    static const float parts[10] = {[1] = 5.0f, [2] = 4.0f, [5] = 5.0f};
    for (float end = 0.01f; end < 5e3f; end *= 1.3f) {
        const float t[] = {0.0f, end}, distance[] = {end, 1e-4f};
        struct slice_frame frame = frame_of(PROBE_HIT, t, distance, 2, 1.0f);
        int first = frame.digits[0];
        while (first >= 10)
            first /= 10;
        assert_true(first == 1 || first == 2 || first == 5);
        assert_float_equal(frame.tick / frame.line, parts[first], 1e-4f);
    }
}

// A slice that is drawn with fewer pixels, because it is moving, shows the march of the picture at
// full size, as the table of the ray does, although a smaller picture has other rays, thresholds
// and starts.
TEST(a_coarse_slice_shows_the_same_march)
{
    static struct probe probe;
    struct renderer_inputs inputs = {.width = 960, .height = 540, .samples = 1};
    struct march march, other;
    inputs.camera = gpu_open_chapter("16_fewer_steps");
    for (int x = 500; x < 900; x += 80) {
        struct renderer_inputs small = inputs;
        small.pixel[0] = inputs.pixel[0] = x;
        small.pixel[1] = inputs.pixel[1] = 200;
        small.width = 227;
        small.height = 128;
        assert_true(renderer_probe(&gpu.renderer, &inputs, x, 200, &probe));
        small.whole[0] = 960;
        small.whole[1] = 540;
        assert_true(renderer_march_selected(&gpu.renderer, NULL, &small, &march));
        assert_int_equal(march.steps, probe_rows(&probe));
        for (int k = 0; k < march.steps && k < RENDERER_STEPS; k++)
            assert_true(fabsf(march.step[k][0] - probe.step[k].t) <= 0.0f);
        // In halves of the height from the middle, the ray meets both pictures at the same place.
        assert_true(renderer_march_selected(&gpu.renderer, NULL, &inputs, &other));
        for (int i = 0; i < 2; i++) {
            float middle[2] = {i == 0 ? 113.5f : 64.0f, i == 0 ? 480.0f : 270.0f};
            assert_true(fabsf((march.pixel[i] - middle[0]) / 64.0f -
                              (other.pixel[i] - middle[1]) / 270.0f) < 1e-5f);
        }
    }
}

TESTS(gpu_setup, gpu_teardown)
