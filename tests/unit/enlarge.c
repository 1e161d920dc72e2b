// enlarge.c - tests the filters that enlarge a picture drawn at a lower resolution, by comparison
// with formulas in double precision and with pictures at full resolution.
#include "lib/test.h"
#include "lib/enlarge.h"

enum { SMALL_WIDTH = 40, SMALL_HEIGHT = 24, WIDTH = 97, HEIGHT = 71 };

static const double byte = 1.0 / 255.0;

// Draw a picture of this size into the renderer's target, without enlarging it.
//   text  GLSL that sets the colour c from p, the texel's integer coordinates, which start at 0,0
static void draw_small(const char *text, int width, int height)
{
    char shader[1024];
    snprintf(shader, sizeof shader, "void mainImage(out vec4 c, in vec2 p) { p -= 0.5; %s }", text);
    struct renderer_inputs inputs = {.width = width, .height = height, .samples = 1};
    assert_true(gpu_load_text(shader));
    assert_true(renderer_draw(&gpu.renderer, &inputs, 0, height));
}

static float *large(enum enlarge_filter filter)
{
    return enlarge_numbers(filter, &gpu.renderer.picture, WIDTH, HEIGHT);
}

// The position of a large picture's pixel in the small picture, along one axis, in texels.
static double position(int pixel, int side, int small)
{
    return (pixel + 0.5) * small / side - 0.5;
}

static double clamped(double value, double low, double high)
{
    return fmin(fmax(value, low), high);
}

TEST(even_pictures_stay_as_they_are)
{
    for (int filter = 0; filter < ENLARGE_FILTERS; filter++)
        for (int tiny = 0; tiny < 2; tiny++) {
            draw_small("c = vec4(0.2, 0.6, 1.0, 1.0);", tiny ? 1 : 40, tiny ? 1 : 24);
            float *numbers = large((enum enlarge_filter)filter);
            for (int i = 0; i < WIDTH * HEIGHT; i++) {
                assert_true(fabs((double)numbers[4 * i] - 0.2) < 1e-5);
                assert_true(fabs((double)numbers[4 * i + 1] - 0.6) < 1e-5);
                assert_true(fabs((double)numbers[4 * i + 2] - 1.0) < 1e-5);
            }
            free(numbers);
        }
}

// Values are clamped to [0, 1] before they are averaged, so a lamp with the value 50 counts as
// white.
TEST(values_are_clamped_before_the_mean)
{
    draw_small("c = vec4(p.x < 19.5 ? 50.0 : -50.0);", SMALL_WIDTH, SMALL_HEIGHT);
    float *numbers = large(ENLARGE_BILINEAR);
    for (int x = 0; x < WIDTH; x++) {
        double expected = clamped(20.0 - position(x, WIDTH, SMALL_WIDTH), 0.0, 1.0);
        assert_true(fabs((double)numbers[4 * (WIDTH * 30 + x)] - expected) < 1e-4);
    }
    free(numbers);
}

// Neither axis is reversed, and positions beyond the outermost texels' centres are clamped.
TEST(bilinear_is_linear_between_texels)
{
    draw_small("c = vec4(p.x / 51.0, p.y / 51.0, p.x * p.y / 1275.0, 1.0);", SMALL_WIDTH,
               SMALL_HEIGHT);
    float *numbers = large(ENLARGE_BILINEAR);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        double x = clamped(position(i % WIDTH, WIDTH, SMALL_WIDTH), 0.0, SMALL_WIDTH - 1.0);
        double y = clamped(position(i / WIDTH, HEIGHT, SMALL_HEIGHT), 0.0, SMALL_HEIGHT - 1.0);
        assert_true(fabs((double)numbers[4 * i] - x / 51.0) < 1e-5);
        assert_true(fabs((double)numbers[4 * i + 1] - y / 51.0) < 1e-5);
        assert_true(fabs((double)numbers[4 * i + 2] - x * y / 1275.0) < 0.51 * byte);
    }
    free(numbers);
}

// The enlarger's copy of the picture is resized whenever either side of the picture grows or
// shrinks.
TEST(a_picture_may_change_along_one_axis)
{
    static const int sizes[][2] = {{40, 24}, {60, 24}, {60, 37}, {31, 37}, {31, 20}};
    struct enlarge enlarge = {0};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        draw_small("c = vec4(p.x / 64.0, p.y / 64.0, 0.5, 1.0);", sizes[i][0], sizes[i][1]);
        const struct target *picture = &gpu.renderer.picture;
        float *expected = large(ENLARGE_BILINEAR);
        float *numbers = enlarge_numbers_with(&enlarge, ENLARGE_BILINEAR, picture, WIDTH, HEIGHT);
        assert_memory_equal(numbers, expected, sizeof(float[4]) * WIDTH * HEIGHT);
        free(numbers);
        free(expected);
    }
    enlarge_close(&enlarge, &gpu.context.gl);
}

// The picture is a straight edge between black and white, at 14 angles. The values of the edge
// filter are within the range of the 4 nearest texels, so there is no ringing, and their squared
// error is less than 0.92 of the bilinear filter's.
TEST(the_edge_filter_follows_an_edge)
{
    for (int degrees = 7; degrees < 180; degrees += 13) {
        double off[ENLARGE_FILTERS] = {0};
        char text[256];
        double along = degrees * 3.14159265358979 / 180.0, a = -sin(along), b = cos(along);
        snprintf(text, sizeof text,
                 "c = vec4(step(0.0, %.9f * (p.x - 19.7) + %.9f * (p.y - 11.2)));", a, b);
        draw_small(text, SMALL_WIDTH, SMALL_HEIGHT);
        float *small = malloc(sizeof(float[4]) * SMALL_WIDTH * SMALL_HEIGHT);
        assert_non_null(small);
        target_read(&gpu.renderer.picture, gpu.renderer.gl, small);
        for (int filter = 0; filter < ENLARGE_FILTERS; filter++) {
            float *numbers = large((enum enlarge_filter)filter);
            for (int i = 0; i < WIDTH * HEIGHT; i++) {
                double x = position(i % WIDTH, WIDTH, SMALL_WIDTH);
                double y = position(i / WIDTH, HEIGHT, SMALL_HEIGHT);
                double truth = a * (x - 19.7) + b * (y - 11.2) >= 0.0 ? 1.0 : 0.0;
                double value = (double)numbers[4 * i];
                off[filter] += pow(clamped(value, 0.0, 1.0) - truth, 2.0);
                if (filter != ENLARGE_EDGE || x < 0.0 || y < 0.0 || x > 38.9 || y > 22.9)
                    continue;
                const float *near = small + 4 * (SMALL_WIDTH * (int)y + (int)x);
                const float *above = near + 4 * SMALL_WIDTH;
                double low = fmin(fmin((double)near[0], (double)near[4]),
                                  fmin((double)above[0], (double)above[4]));
                double high = fmax(fmax((double)near[0], (double)near[4]),
                                   fmax((double)above[0], (double)above[4]));
                assert_true(value >= low - 1e-5 && value <= high + 1e-5);
            }
            free(numbers);
        }
        free(small);
        print_message("# an edge at %d degrees: squared error %.1f with the edge filter, %.1f with "
                      "the bilinear filter\n",
                      degrees, off[ENLARGE_EDGE], off[ENLARGE_BILINEAR]);
        assert_true(off[ENLARGE_EDGE] < 0.92 * off[ENLARGE_BILINEAR]);
    }
}

// At half the resolution, the edge filter's root mean square error is less than 0.95 of the
// bilinear filter's on solids and shadows, and at most 4 % larger on textures.
TEST(the_edge_filter_is_near_the_full_picture)
{
    static const double most[ENLARGE_SCENES] = {0.95, 0.93, 1.04, 1.02, 1.01};
    struct enlarge_error error[ENLARGE_FILTERS];
    for (int scene = 0; scene < ENLARGE_SCENES; scene++) {
        enlarge_measure(&enlarge_scenes[scene], 2.0, error);
        print_message("# %s: root mean square error %.2f with the edge filter, %.2f with the "
                      "bilinear filter\n",
                      enlarge_scenes[scene].shader, error[ENLARGE_EDGE].rms,
                      error[ENLARGE_BILINEAR].rms);
        assert_true(error[ENLARGE_EDGE].rms < most[scene] * error[ENLARGE_BILINEAR].rms);
    }
}

TESTS(gpu_setup, gpu_teardown)
