// sheet.c - tests the sheet of chapter 10: the outline of its figure has the same width at every
// zoom level, and the sheet's two colours differ even for eyes that lack the L or the M cones.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

enum { WIDTH = 640, HEIGHT = 360 };

static void set(const char *name, double x, double y)
{
    struct parameter *parameter = parameters_find(&gpu.renderer.parameters, name);
    assert_non_null(parameter);
    parameter->value[0] = x;
    parameter->value[1] = y;
}

// The picture from a height above the middle of the sheet. The ray that it shows starts inside the
// figure and ends at once, so only a dot and a ring are drawn in the middle of the picture.
static float *picture_from(double height)
{
    struct renderer_inputs inputs = {.width = WIDTH,
                                     .height = HEIGHT,
                                     .camera = {.position = {0.0f, 0.0f, (float)height}},
                                     .samples = 1,
                                     .pixel = {-1, -1}};
    return gpu_numbers(&inputs);
}

static void load(int figure)
{
    assert_true(gpu_load("chapters/10_distance_in_the_plane.frag"));
    set("figure", figure, 0.0);
    set("rayStart", 0.0, 0.0);
    set("aim", 1.0, 0.0);
}

// The coordinate of a pixel's centre on the sheet. From bottom to top, the picture shows a part of
// the sheet that is `height` units high.
static double coordinate(int pixel, int size, double height)
{
    return (2.0 * pixel + 1.0 - size) / HEIGHT * height / 2.0;
}

static double mix(double a, double b, double share)
{
    return a + share * (b - a);
}

// The distance to the sheet's rectangle, mixed with that to its disc.
static double mixture(double x, double y, double morph)
{
    double u = fabs(x) - 0.9, v = fabs(y) - 0.55;
    double box = hypot(fmax(u, 0.0), fmax(v, 0.0)) + fmin(fmax(u, v), 0.0);
    return mix(box, hypot(x - 0.8, y + 0.3) - 0.5, morph);
}

// The width of the white outline in pixels, measured perpendicular to it at the point on the left
// where y = 0.05.
//   slope  receives the length of the mixture's gradient there
static double outline_width(double height, double morph, double *slope)
{
    load(2);
    set("morph", morph, 0.0);
    set("lineSpacing", 1.0, 0.0);
    float *values = picture_from(height);
    double pixel = height / HEIGHT, low = -3.0, high = 0.1, h = 1e-5, width = 0.0;
    for (int i = 0; i < 50; i++) {
        double middle = 0.5 * (low + high);
        *(mixture(middle, 0.05, morph) > 0.0 ? &low : &high) = middle;
    }
    double x = (mixture(low + h, 0.05, morph) - mixture(low - h, 0.05, morph)) / (2.0 * h);
    double y = (mixture(low, 0.05 + h, morph) - mixture(low, 0.05 - h, morph)) / (2.0 * h);
    *slope = hypot(x, y);
    for (double along = -6.0; along < 6.0; along += 0.125) {
        int column = (int)floor(0.5 * WIDTH + low / pixel + along * x / *slope);
        int row = (int)floor(0.5 * HEIGHT + 0.05 / pixel + along * y / *slope);
        // Nothing but the white outline has so much blue.
        width += values[4 * (row * WIDTH + column) + 2] > 0.84f ? 0.125 : 0.0;
    }
    free(values);
    return width;
}

// The outline is 2.6 pixels wide; only pixels that it covers by at least half count.
TEST(test_the_outline_has_one_width)
{
    for (double height = 1.9; height < 6.0; height *= 1.6)
        for (int mixed = 0; mixed < 3; mixed++) {
            double slope, width = outline_width(height, 0.25 * mixed, &slope);
            print_message("# from height %.1f, slope %.2f: outline of %.2f pixels\n", height, slope,
                          width);
            assert_true(width >= 1.8 && width <= 3.4);
        }
}

// With full colour vision, and also without L or without M cones, the inside is so much darker than
// the outside that hue is not needed to tell them apart.
TEST(test_inside_is_darker_for_every_eye)
{
    load(2);
    set("lineSpacing", 1.0, 0.0);
    float *values = picture_from(2.4);
    for (enum mirror_vision eye = VISION_FULL; eye <= VISION_DEUTAN; eye++) {
        double lightest = 0.0, darkest = 1.0;
        for (int y = 0; y < HEIGHT; y++)
            for (int x = 0; x < WIDTH; x++) {
                double u = fabs(coordinate(x, WIDTH, 2.4)) - 0.9,
                       v = fabs(coordinate(y, HEIGHT, 2.4)) - 0.55;
                double d = fmax(u, v), pixel = 2.4 / HEIGHT;
                if (fabs(d) < 3.0 * pixel || d < -0.48)
                    continue;
                const float *c = values + 4 * (y * WIDTH + x);
                double lightness = mirror_lightness(d3_of(c), eye);
                if (d < 0.0)
                    lightest = fmax(lightest, lightness);
                else
                    darkest = fmin(darkest, lightness);
            }
        print_message("# eye %d: lightness at most %.3f inside, at least %.3f outside\n", eye,
                      lightest, darkest);
        assert_true(lightest + 0.1 < darkest);
    }
    free(values);
}

TESTS(gpu_setup, gpu_teardown)
