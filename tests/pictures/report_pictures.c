// report_pictures.c - compares the pictures of docs/benchmark.md with the report's figures: the
// edges of objects, shadows and lawns lie between the same pixels as in the figures.
#include "lib/test.h"
#include "lib/report_pictures.h"

// The figures are 864x606 pixels, of which the top 30 rows are the title; row 0 is the top.
enum { WIDTH = 864, HEIGHT = 576, TITLE = 30 };

// Two pixels of a printed figure, on either side of an edge.
struct pixel {
    int x, y;
};
struct border {
    struct pixel in, out;
};

static float *draw(int scene, enum shader_view view)
{
    struct renderer_inputs inputs = report_inputs(&report_scenes[scene], WIDTH, HEIGHT);
    assert_true(report_load(&gpu.renderer, &report_scenes[scene], NULL));
    assert_true(renderer_set_view(&gpu.renderer, view));
    return gpu_numbers(&inputs);
}

static const float *pixel_at(const float *pixels, struct pixel pixel)
{
    return pixels + 4 * ((HEIGHT - 1 - (pixel.y - TITLE)) * WIDTH + pixel.x);
}

// In the depth view, a grey pixel is a hit, and a pixel in the blue of VIEW_NOTHING is a miss.
static double solid(const float *colour)
{
    return colour[0] == colour[2] ? 1.0 : 0.0;
}

static double light(const float *colour)
{
    return 0.2126 * (double)colour[0] + 0.7152 * (double)colour[1] + 0.0722 * (double)colour[2];
}

static double green(const float *colour)
{
    return 2.0 * (double)colour[1] / ((double)colour[0] + (double)colour[2]);
}

static double yellow(const float *colour)
{
    return (double)colour[0] / (double)colour[2];
}

// Check that, at every edge, the measure of the inner pixel is more than factor times that of the
// outer pixel.
static void assert_borders(const float *pixels, const struct border *border, size_t count,
                           double (*measure)(const float *), double factor)
{
    for (size_t i = 0; i < count; i++) {
        double in = measure(pixel_at(pixels, border[i].in));
        double out = measure(pixel_at(pixels, border[i].out));
        if (!(in > factor * out))
            fail_msg("%d,%d: %g, and %d,%d: %g", border[i].in.x, border[i].in.y, in,
                     border[i].out.x, border[i].out.y, out);
    }
}

#define COUNT(array) (sizeof(array) / sizeof *(array))

TEST(test_boxes_are_as_in_figure_9)
{
    static const struct border outline[] = {
        {{477, 108}, {477, 98}},  {{477, 168}, {477, 180}}, {{454, 138}, {440, 138}},
        {{501, 138}, {514, 138}}, {{353, 248}, {344, 244}}, {{596, 248}, {606, 245}},
        {{466, 238}, {466, 229}}, {{380, 255}, {430, 290}}, {{190, 428}, {178, 420}},
        {{768, 448}, {779, 446}}, {{240, 412}, {240, 396}}, {{700, 424}, {700, 408}}};
    static const struct border shadow[] = {{{240, 520}, {215, 436}}, {{345, 480}, {300, 440}},
                                           {{300, 520}, {355, 532}}, {{480, 545}, {430, 532}},
                                           {{250, 450}, {280, 436}}, {{600, 560}, {400, 520}}};
    float *pixels = draw(0, VIEW_DEPTH);
    assert_borders(pixels, outline, COUNT(outline), solid, 0.5);
    free(pixels);
    pixels = draw(0, VIEW_PICTURE);
    assert_borders(pixels, shadow, COUNT(shadow), light, 1.5);
    free(pixels);
}

TEST(test_pyramid_is_as_in_figure_10)
{
    static const struct border outline[] = {
        {{440, 144}, {430, 140}}, {{404, 188}, {396, 180}}, {{525, 215}, {535, 213}},
        {{566, 340}, {576, 336}}, {{604, 450}, {615, 447}}, {{170, 464}, {160, 456}},
        {{645, 574}, {656, 578}}, {{400, 518}, {400, 535}}, {{560, 550}, {558, 568}},
        {{430, 275}, {480, 320}}, {{360, 335}, {345, 300}}};
    float *pixels = draw(1, VIEW_DEPTH);
    assert_borders(pixels, outline, COUNT(outline), solid, 0.5);
    free(pixels);
}

// Only the lamp and the lawns are compared: the towers are as wide as in the figure, but their
// heights differ.
TEST(test_lamp_and_lawns_are_as_in_figure_11)
{
    static const struct border globe[] = {{{374, 322}, {374, 280}},
                                          {{374, 294}, {420, 322}},
                                          {{345, 322}, {330, 322}},
                                          {{402, 322}, {418, 322}},
                                          {{374, 350}, {345, 365}}};
    static const struct border lawn[] = {{{250, 560}, {440, 520}},
                                         {{30, 480}, {100, 510}},
                                         {{640, 520}, {500, 510}},
                                         {{800, 500}, {560, 520}}};
    float *pixels = draw(2, VIEW_PICTURE);
    assert_borders(pixels, globe, COUNT(globe), yellow, 1.1);
    assert_borders(pixels, lawn, COUNT(lawn), green, 1.3);
    free(pixels);
}

TESTS(gpu_setup, gpu_teardown)
