// test_frames.c - chapters/experiments/16_frame_*.frag: frames in less time show the pictures of
// their chapters.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "support_coarse.h"
#include "support_compare.h"

static struct image drawn(const char *stem, const char *path, double time)
{
    struct renderer_inputs inputs = {
        .width = 640, .height = 360, .time = (float)time, .samples = 1};
    struct image picture = {0};
    assert_true(mirror_camera(gpu.root, stem, &inputs.camera) && gpu_load(path));
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

static void test_the_stage_looks_as_in_its_chapter(void **unused)
{
    (void)unused;
    check_frame("03_shadows", "chapters/03_shadows.frag", "chapters/experiments/16_frame_03.frag");
}

static void test_the_pyramid_looks_as_in_its_chapter(void **unused)
{
    (void)unused;
    check_frame("06_sierpinski_symmetry", "chapters/06_sierpinski_symmetry.frag",
                "chapters/experiments/16_frame_06.frag");
}

// Where a march ends anywhere within a threshold as wide as a pixel, no other march draws the same
// picture. Where it ends at the threshold, the coarse pass draws the same.
static void test_the_city_does_not_depend_on_where_rays_begin(void **unused)
{
    (void)unused;
    static const char frame[] = "chapters/experiments/16_frame_09.frag";
    struct renderer_inputs inputs = {.width = 640, .height = 360, .samples = 1};
    struct image picture[2] = {{0}, {0}};
    assert_true(mirror_camera(gpu.root, "09_sky_and_sunset", &inputs.camera) && gpu_load(frame));
    for (int time = 0; time < 2; time++) {
        inputs.time = (float)time;
        for (int i = 0; i < 2; i++) {
            coarse_set("coarsePass", i);
            assert_true(renderer_picture(&gpu.renderer, &inputs, &picture[i]));
        }
        struct image_difference difference = difference_of(&picture[0], &picture[1], "09");
        assert_true(difference.differs > 0 && image_same(&difference));
    }
}

// The city's distance, written out, is that of city.glsl: the chapter's own march over the one and
// the other draws the same picture.
static void test_the_distance_written_out_is_the_same(void **unused)
{
    (void)unused;
    struct renderer_inputs inputs = {.width = 640, .height = 360, .time = 1.0f, .samples = 1};
    struct image own = drawn("09_sky_and_sunset", "chapters/09_sky_and_sunset.frag", 1.0),
                 other = {0};
    assert_true(mirror_camera(gpu.root, "09_sky_and_sunset", &inputs.camera));
    assert_true(
        gpu_load_text("#include \"main.glsl\"\n#include \"cone.glsl\"\n#include \"crossing.glsl\"\n"
                      "#define marchCrossing marchCone\n"
                      "#include \"experiments/16_frame_09.frag\"\n"));
    coarse_set("coarsePass", 0.0);
    assert_true(renderer_picture(&gpu.renderer, &inputs, &other));
    struct image_difference difference = difference_of(&own, &other, "city");
    assert_true(image_same(&difference));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_stage_looks_as_in_its_chapter),
        cmocka_unit_test(test_the_pyramid_looks_as_in_its_chapter),
        cmocka_unit_test(test_the_city_does_not_depend_on_where_rays_begin),
        cmocka_unit_test(test_the_distance_written_out_is_the_same),
    };
    return cmocka_run_group_tests_name("frames in less time", tests, gpu_setup, gpu_teardown);
}
