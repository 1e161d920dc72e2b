// pair.c - tests two pictures side by side: each side is bit-for-bit identical to the picture that
// is drawn alone, the second picture follows the settings of the first, and labels describe the
// sides.
#include "lib/test.h"
#include "picture/comparison.h"
#include "lib/gpu.h"
#include "lib/scratch.h"

enum { WIDTH = 61, HEIGHT = 40 };

static struct renderer second;
static struct comparison comparison;

#define FIRST                                                                                      \
    GPU_COURSE "uniform float bright; // 0.5 in [0, 1]: for this test\n"                           \
               "uniform float bri; // 1 in [0, 8]: for this test\n"                                \
               "uniform int kind; // 2 in [0, 9]: for this test\n"                                 \
               "vec3 rayColour(Ray r) { return vec3(bright, r.origin.x * bri, float(kind)); }\n"

#define SECOND                                                                                     \
    GPU_COURSE "uniform float bright; // 0.25 in [0, 1]: for this test\n"                          \
               "uniform float bri; // 1 in [0, 4]: for this test\n"                                \
               "uniform float kind; // 3 in [0, 9]: for this test\n"                               \
               "vec3 rayColour(Ray r) { return vec3(r.origin.y * bright, bri, kind); }\n"

static void load_both(const char *first, const char *other)
{
    static const char *const own[] = {"bright=0.75"};
    gpu.renderer.comparison = NULL;
    assert_true(gpu_load_text(other));
    renderer_close(&second);
    second = gpu.renderer;
    assert_true(renderer_open(&gpu.renderer, &gpu.context.gl, gpu.root));
    assert_true(gpu_load_text(first));
    comparison = (struct comparison){.other = &second, .divider = 0.5, .own = own, .own_count = 1};
}

static int setup(void **state)
{
    if (gpu_setup(state) != 0)
        return -1;
    load_both(FIRST, SECOND);
    assert_true(parameters_assign(&second.parameters, "bright=0.75"));
    return 0;
}

static int teardown(void **state)
{
    renderer_close(&second);
    return gpu_teardown(state);
}

static float *numbers_of(struct renderer *renderer, const struct renderer_inputs *inputs)
{
    float *numbers = malloc(sizeof(float[4]) * WIDTH * HEIGHT);
    assert_non_null(numbers);
    assert_true(renderer_draw(renderer, inputs, 0, HEIGHT));
    target_read(&renderer->picture, renderer->gl, numbers);
    return numbers;
}

// Check that each row shows the first picture to the left of the divider and the second picture to
// the right.
static void assert_sides(const float *both, const float *one, const float *other, int split)
{
    size_t left = sizeof(float[4]) * (size_t)split, right = sizeof(float[4]) * WIDTH - left;
    for (int y = 0; y < HEIGHT; y++) {
        size_t row = 4 * (size_t)(WIDTH * y), middle = row + 4 * (size_t)split;
        assert_memory_equal(both + row, one + row, left);
        assert_memory_equal(both + middle, other + middle, right);
    }
}

TEST(each_side_is_its_own_picture)
{
    static const double dividers[] = {0.0, 0.3, 0.5, 0.99, 1.0};
    for (int samples = 1; samples <= 2; samples++) {
        struct renderer_inputs inputs = gpu_inputs(WIDTH, HEIGHT, samples);
        gpu.renderer.comparison = &comparison;
        comparison_follow(&gpu.renderer);
        gpu.renderer.comparison = NULL;
        float *one = numbers_of(&gpu.renderer, &inputs), *other = numbers_of(&second, &inputs);
        gpu.renderer.comparison = &comparison;
        for (size_t i = 0; i < sizeof dividers / sizeof *dividers; i++) {
            comparison.divider = dividers[i];
            int split = renderer_split(&gpu.renderer, WIDTH);
            assert_int_equal(split, (int)floor(dividers[i] * WIDTH + 0.5));
            float *both = numbers_of(&gpu.renderer, &inputs);
            assert_sides(both, one, other, split);
            for (int top = HEIGHT; top > 0; top -= 8)
                assert_true(gpu_sharpen(&gpu.renderer, &inputs, top - 8, 8));
            target_read(&gpu.renderer.sharp, gpu.renderer.gl, both);
            assert_sides(both, one, other, split);
            free(both);
        }
        free(one);
        free(other);
    }
}

static double value_of(const struct renderer *renderer, const char *name)
{
    return parameters_find(&renderer->parameters, name)->value[0];
}

TEST(the_second_picture_follows_except_in_its_own_values)
{
    gpu.renderer.comparison = &comparison;
    assert_true(parameters_assign(&gpu.renderer.parameters, "bri=7"));
    assert_true(parameters_assign(&gpu.renderer.parameters, "bright=0.125"));
    assert_true(parameters_assign(&gpu.renderer.parameters, "kind=8"));
    gpu.renderer.focal_length = 1.5f;
    gpu.renderer.orthographic = 0.25;
    comparison_follow(&gpu.renderer);
    assert_true(value_of(&second, "bri") == 4.0); // 7, clamped to the second picture's range
    assert_true(value_of(&second, "bright") == 0.75);
    assert_true(value_of(&second, "kind") == 3.0); // unchanged, because the types differ
    assert_true(second.focal_length == 1.5f && second.orthographic == 0.25);
    assert_true(value_of(&gpu.renderer, "bright") == 0.125);
}

TEST(own_values_have_a_position_and_a_side)
{
    static const char *const names[] = {"bright (left)", "bright (right)", "bri",
                                        "kind (left)",   "kind (right)",   "own (right)"};
    enum { COUNT = sizeof names / sizeof *names };
    load_both(FIRST, SECOND "uniform float own; // 1 in [0, 1]: for this test\n");
    gpu.renderer.comparison = &comparison;
    assert_int_equal(comparison_parameter_count(&gpu.renderer), COUNT);
    assert_null(comparison_parameter(&gpu.renderer, COUNT));
    for (int i = 0; i < COUNT; i++) {
        char name[80];
        const struct parameter *parameter = comparison_parameter(&gpu.renderer, i);
        comparison_parameter_name(&gpu.renderer, parameter, name, sizeof name);
        assert_string_equal(name, names[i]);
        const struct parameters *all = comparison_parameters_of(&gpu.renderer, parameter);
        assert_ptr_equal(parameters_find(all, parameter->name), parameter);
        assert_true((all == &second.parameters) == (strstr(name, "(right)") != NULL));
    }
    assert_string_equal(comparison_side_name(&gpu.renderer, WIDTH, 30), "left");
    assert_string_equal(comparison_side_name(&gpu.renderer, WIDTH, 31), "right");
    assert_null(comparison_side_name(&gpu.renderer, WIDTH, -1));
    gpu.renderer.comparison = NULL;
    assert_int_equal(comparison_parameter_count(&gpu.renderer), 3);
    assert_null(comparison_side_name(&gpu.renderer, WIDTH, 30));
    load_both(FIRST, SECOND);
    assert_true(parameters_assign(&second.parameters, "bright=0.75"));
}

TEST(a_view_is_set_in_both_pictures)
{
    struct renderer_inputs inputs = gpu_inputs(WIDTH, HEIGHT, 1);
    gpu.renderer.comparison = &comparison;
    assert_true(renderer_set_view(&gpu.renderer, VIEW_DEPTH));
    assert_int_equal(second.view, VIEW_DEPTH);
    assert_true(renderer_draw(&gpu.renderer, &inputs, 0, HEIGHT));
    assert_true(renderer_set_view(&gpu.renderer, VIEW_PICTURE));
    // If one picture lacks the view, both pictures keep their old view.
    static const char toy[] = "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }";
    for (int side = 0; side < 2; side++) {
        load_both(side == 0 ? toy : FIRST, side == 0 ? SECOND : toy);
        gpu.renderer.comparison = &comparison;
        capture_begin();
        bool shown = renderer_set_view(&gpu.renderer, VIEW_NORMALS);
        assert_int_equal(line_count(capture_end()), 1);
        assert_false(shown);
        assert_int_equal(gpu.renderer.view, VIEW_PICTURE);
        assert_int_equal(second.view, VIEW_PICTURE);
    }
    load_both(FIRST, SECOND);
}

#define MARCHED                                                                                    \
    "#include \"main.glsl\"\n#include \"march.glsl\"\n"                                            \
    "Ray pixelRay(vec2 screen) { return Ray(vec3(0.0), vec3(0.0, 0.0, -1.0)); }\n"                 \
    "vec3 rayColour(Ray ray) { return vec3(march(ray, 0.0, 9.0, 0.001, 64).t); }\n"

// Both curves are inside the picture, although the distances of one side are eight times as large.
TEST(a_plot_has_room_for_both_sides)
{
    static const char *const scenes[] = {MARCHED "float sceneDistance(vec3 p) { return 0.5; }\n",
                                         MARCHED "float sceneDistance(vec3 p) { return 4.0; }\n"};
    const int width = 320, height = 180;
    struct renderer_inputs inputs = gpu_inputs(width, height, 1);
    for (int near = 0; near < 2; near++) {
        int curve[2] = {0, 0};
        load_both(scenes[near], scenes[1 - near]);
        gpu.renderer.comparison = &comparison;
        assert_true(renderer_set_view(&gpu.renderer, VIEW_PLOT));
        float *numbers = gpu_numbers(&inputs);
        for (int i = 0; i < width * height; i++) {
            const float *colour = numbers + 4 * i;
            curve[i % width >= width / 2] += colour[2] > colour[0] + 0.2f;
        }
        free(numbers);
        assert_true(curve[0] > 50 && curve[1] > 50);
    }
    assert_true(renderer_set_view(&gpu.renderer, VIEW_PICTURE));
    load_both(FIRST, SECOND);
}

TEST(a_probe_uses_the_side_of_its_pixel)
{
    static struct probe probe;
    struct renderer_inputs inputs = gpu_inputs(WIDTH, HEIGHT, 1);
    gpu.renderer.comparison = &comparison;
    assert_true(parameters_assign(&gpu.renderer.parameters, "bright=0.6"));
    assert_true(parameters_assign(&gpu.renderer.parameters, "kind=0"));
    assert_true(parameters_assign(&second.parameters, "kind=1"));
    comparison.divider = 0.5;
    for (int x = 0; x < WIDTH; x++) {
        assert_true(renderer_probe(&gpu.renderer, &inputs, x, HEIGHT / 2, &probe));
        assert_int_equal(probe.colour[2], x < 31 ? 0 : 255);
        assert_true(renderer_at(&gpu.renderer, WIDTH, x) == (x < 31 ? &gpu.renderer : &second));
    }
}

TEST(labels_say_what_differs)
{
    char text[64];
    gpu.renderer.comparison = &comparison;
    comparison.label[0] = comparison.label[1] = NULL;
    assert_true(parameters_assign(&gpu.renderer.parameters, "bright=0.5"));
    assert_true(parameters_assign(&second.parameters, "bright=0.75"));
    comparison_text(&gpu.renderer, 0, text, sizeof text);
    assert_string_equal(text, "bright=0.5");
    comparison_text(&gpu.renderer, 1, text, sizeof text);
    assert_string_equal(text, "bright=0.75");
    comparison.label[0] = "right.frag";
    comparison.label[1] = "wrong.frag";
    comparison_text(&gpu.renderer, 1, text, sizeof text);
    assert_string_equal(text, "wrong.frag  bright=0.75");
    comparison.own_count = 0;
    comparison_text(&gpu.renderer, 0, text, sizeof text);
    assert_string_equal(text, "right.frag");
    // A parameter that only the second picture has is listed only if its value differs from the
    // value in the file.
    struct parameter glow = {.name = "glow", .components = 1, .value = {0.25}, .initial = {0.25}};
    const struct parameters all = second.parameters;
    second.parameters = (struct parameters){.item = &glow, .count = 1};
    comparison_text(&gpu.renderer, 1, text, sizeof text);
    assert_string_equal(text, "wrong.frag");
    glow.value[0] = 0.5;
    comparison_text(&gpu.renderer, 1, text, sizeof text);
    assert_string_equal(text, "wrong.frag  glow=0.5");
    second.parameters = all;
}

// Wherever the divider is, the labels are completely inside the picture, and each label is on its
// own side of the divider.
TEST(labels_stay_on_their_side)
{
    struct overlay overlay = {0};
    gpu.renderer.comparison = &comparison;
    comparison.label[0] = "a name that is too long for the left side of a small picture.frag";
    comparison.label[1] = "another name, which is no shorter, for the picture on the right.frag";
    assert_true(overlay_open(&overlay, &gpu.context.gl));
    for (double divider = 0.0; divider <= 1.0; divider += 0.05)
        for (int size = 0; size < 3; size++) {
            int width = (int[]){320, 1280, 3840}[size], height = width * 9 / 16;
            float scale = overlay_scale_of(height);
            comparison.divider = divider;
            comparison_gather(&gpu.renderer, &overlay, width, height, scale);
            float at = (float)renderer_split(&gpu.renderer, width) / scale;
            for (int i = 0; i < overlay.count; i++) {
                const struct overlay_rectangle *r = &overlay.rectangle[i];
                bool line = r->right - r->left < 4.0f && r->letter == 0;
                assert_true(line || (r->left >= 6.0f && r->right <= (float)width / scale - 6.0f));
                assert_true(r->bottom <= (float)height / scale + 0.01f);
                assert_true(line || r->right < at || r->left > at);
            }
            assert_true(overlay.count >= 2 + (divider < 0.2 ? 0 : 8) + (divider > 0.8 ? 0 : 8));
        }
    overlay_close(&overlay);
}

TESTS(setup, teardown)
