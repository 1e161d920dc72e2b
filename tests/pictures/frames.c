// frames.c - tests that the faster frames, chapters/experiments/16_frame_*.frag, look like the
// pictures of their chapters.
#include "lib/test.h"
#include "lib/coarse.h"
#include "lib/compare.h"

static struct image drawn(const char *stem, const char *path, double time)
{
    struct renderer_inputs inputs = {
        .width = 640, .height = 360, .time = (float)time, .samples = 1};
    struct image picture = {0};
    inputs.camera = gpu_camera(stem);
    gpu_open_shader(path);
    assert_true(renderer_picture(&gpu.renderer, &inputs, &picture));
    return picture;
}

static struct image_difference difference_of(struct image *one, struct image *other,
                                             const char *name)
{
    struct image_difference difference;
    assert_true(image_compare(one, other, &difference));
    printf("# %s: ", name);
    image_print_difference(&difference);
    image_free(one);
    image_free(other);
    return difference;
}

static void check_frame(const char *stem, const char *chapter, const char *frame)
{
    for (int time = 0; time < 2; time++) {
        struct image own = drawn(stem, chapter, time), other = drawn(stem, frame, time);
        struct image_difference difference = difference_of(&own, &other, stem);
        assert_true(difference.differs > 0 && image_same(&difference));
    }
}

TEST(test_the_faster_stage_looks_the_same_as_in_chapter_03)
{
    check_frame("03_shadows", "chapters/03_shadows.frag", "chapters/experiments/16_frame_03.frag");
}

TEST(test_the_faster_pyramid_looks_the_same_as_in_chapter_06)
{
    check_frame("06_sierpinski_symmetry", "chapters/06_sierpinski_symmetry.frag",
                "chapters/experiments/16_frame_06.frag");
}

// If a march may end anywhere within a threshold as wide as a pixel, its picture depends on where
// the rays start. The march of 16_frame_09.frag ends where the distance equals the threshold, so
// with and without the coarse pass, its pictures agree within the tolerance.
TEST(test_the_city_does_not_depend_on_where_rays_begin)
{
    static const char frame[] = "chapters/experiments/16_frame_09.frag";
    struct renderer_inputs inputs = {.width = 640, .height = 360, .samples = 1};
    struct image picture[2] = {{0}, {0}};
    inputs.camera = gpu_camera("09_sky_and_sunset");
    gpu_open_shader(frame);
    for (int time = 0; time < 2; time++) {
        inputs.time = (float)time;
        for (int i = 0; i < 2; i++) {
            gpu_set("coarsePass", i);
            assert_true(renderer_picture(&gpu.renderer, &inputs, &picture[i]));
        }
        struct image_difference difference = difference_of(&picture[0], &picture[1], "09");
        assert_true(difference.differs > 0 && image_same(&difference));
    }
}

// 16_frame_09.frag writes the city's distance out, so that shared terms are computed once. With the
// chapter's own march, this distance gives the same picture as the distance of city.glsl.
TEST(test_the_distance_written_out_gives_the_same_city)
{
    struct renderer_inputs inputs = {.width = 640, .height = 360, .time = 1.0f, .samples = 1};
    struct image own = drawn("09_sky_and_sunset", "chapters/09_sky_and_sunset.frag", 1.0),
                 other = {0};
    inputs.camera = gpu_camera("09_sky_and_sunset");
    assert_true(
        gpu_load_text("#include \"main.glsl\"\n#include \"cone.glsl\"\n#include \"crossing.glsl\"\n"
                      "#define marchCrossing marchCone\n"
                      "#include \"experiments/16_frame_09.frag\"\n"));
    gpu_set("coarsePass", 0.0);
    assert_true(renderer_picture(&gpu.renderer, &inputs, &other));
    struct image_difference difference = difference_of(&own, &other, "city");
    assert_true(image_same(&difference));
}

TESTS(gpu_setup, gpu_teardown)
