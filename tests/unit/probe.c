// probe.c - tests that the colour that --probe prints is the picture's. tests/unit/trace.c tests
// the steps in the table, and tests/unit/numbers.c tests how the steps are printed.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

enum { WIDTH = 640, HEIGHT = 360 };

static struct probe probe; // too large for the stack

static void load_chapter(const char *stem, struct renderer_inputs *inputs)
{
    *inputs = (struct renderer_inputs){.width = WIDTH, .height = HEIGHT, .samples = 1};
    inputs->camera = gpu_open_chapter(stem);
}

// Check that the probe's colour equals the picture's colour at 40 pixels, however many bands and
// samples the picture has, even while the slice view is shown.
static void check_colours(const struct renderer_inputs *inputs, enum shader_view view)
{
    struct image image = {0};
    assert_true(renderer_set_view(&gpu.renderer, view));
    assert_true(renderer_picture(&gpu.renderer, inputs, &image));
    if (view == VIEW_PICTURE && gpu.renderer.fragment.dialect == DIALECT_COURSE)
        assert_true(renderer_set_view(&gpu.renderer, VIEW_SLICE));
    for (int i = 0; i < 40; i++) {
        int x = i * 7919 % image.width, y = i * 6271 % image.height;
        assert_true(renderer_probe(&gpu.renderer, inputs, x, y, &probe));
        assert_int_equal(probe.recorded, gpu.renderer.fragment.dialect == DIALECT_COURSE);
        assert_memory_equal(probe.colour,
                            image.pixel + 3 * ((image.height - 1 - y) * image.width + x), 3);
    }
    image_free(&image);
    assert_true(renderer_set_view(&gpu.renderer, VIEW_PICTURE));
}

TEST(test_probe_has_the_colour_of_the_picture)
{
    static const char *const stems[] = {"03_shadows", "06_sierpinski_symmetry",
                                        "08_orthographic_view", "09_sky_and_sunset",
                                        "00_first_scene"};
    struct renderer_inputs inputs;
    for (int i = 0; i < 5; i++) {
        load_chapter(stems[i], &inputs);
        inputs.width = 150 + i;
        inputs.height = 85;
        inputs.samples = 1 + i % 3;
        inputs.time = i;
        check_colours(&inputs, VIEW_PICTURE);
        if (gpu.renderer.fragment.dialect == DIALECT_COURSE)
            check_colours(&inputs, i == 3 ? VIEW_STEPS : VIEW_NORMALS);
    }
    inputs = (struct renderer_inputs){.width = 16384, .height = 300, .samples = 1}; // two bands
    assert_true(gpu_load("chapters/first_steps/1_screen.frag"));
    check_colours(&inputs, VIEW_PICTURE);
    assert_true(gpu_load_text("void mainImage(out vec4 c, vec2 p)\n"
                              "{ c = vec4(fract(sin(p.x * 12.9 + p.y * 78.2) * 43758.5)); }\n"));
    inputs = gpu_inputs(61, 47, 3);
    check_colours(&inputs, VIEW_PICTURE);
}

// A shader may write any number into trace, and a driver returns any number for a NaN.
TEST(test_a_probe_survives_any_number)
{
    static const float wild[] = {-1.0f, 4.0f,   1e6f,     -2147483648.0f, 2147483648.0f,
                                 3e38f, -3e38f, INFINITY, -INFINITY,      NAN};
    static float values[3][PROBE_STEPS][4];
    FILE *file = tmpfile();
    assert_non_null(file);
    for (size_t i = 0; i < sizeof wild / sizeof *wild; i++) {
        values[0][0][2] = values[0][0][3] = values[2][0][0] = values[2][0][1] = wild[i];
        probe_unpack(&probe, &values[0][0][0]);
        assert_string_equal(probe_outcome(&probe), "no march");
        assert_in_range(probe.steps, 0, 1000000000);
        assert_in_range(probe.all_steps, 0, 1000000000);
        assert_in_range(probe.evaluations, 0, 1000000000);
        assert_in_range(probe_rows(&probe), 0, PROBE_STEPS);
        probe_print(&probe, file);
    }
    fclose(file);
}

TESTS(gpu_setup, gpu_teardown)
