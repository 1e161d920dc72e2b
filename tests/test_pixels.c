// test_pixels.c - pixels of every chapter and first step against a colour computed in double
// precision by another text: its own march, to the limit, its own normals and shading.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "support_pixels.h"

// The march ends up to a threshold before the surface, which moves a shaded colour by at most 0.06
// of 255 here. Where the normal itself is the colour more is seen: 0.001 before a ball of radius
// 0.16 the normal may turn by 1.6 of 255; 0.42 at these pixels.
static double tolerance_of(const char *picture)
{
    return (strcmp(picture, "01_normal_colouring") == 0 ? 0.5 : 0.1) / 255.0;
}

static const struct pixel pixels[] = {
    {"00_first_scene", 214, 338, "sky-"},
    {"00_first_scene", 304, 172, "ball+"},
    {"00_first_scene", 320, 174, "ball+"},
    {"00_first_scene", 352, 102, "frame+"},
    {"00_first_scene", 374, 218, "frame+"},
    {"00_first_scene", 424, 174, "sky-"},
    {"01_normal_colouring", 158, 116, "orbit 3-"},
    {"01_normal_colouring", 174, 120, "orbit 3-"},
    {"01_normal_colouring", 190, 198, "orbit 4-"},
    {"01_normal_colouring", 200, 198, "orbit 4-"},
    {"01_normal_colouring", 234, 64, "orbit 2-"},
    {"01_normal_colouring", 250, 34, "orbit 2-"},
    {"01_normal_colouring", 300, 210, "ball-"},
    {"01_normal_colouring", 310, 246, "sky-"},
    {"01_normal_colouring", 312, 84, "frame-"},
    {"01_normal_colouring", 314, 156, "ball-"},
    {"01_normal_colouring", 340, 244, "orbit 6-"},
    {"01_normal_colouring", 342, 242, "orbit 6-"},
    {"01_normal_colouring", 354, 204, "frame-"},
    {"01_normal_colouring", 400, 56, "orbit 1-"},
    {"01_normal_colouring", 404, 54, "orbit 1-"},
    {"01_normal_colouring", 418, 206, "orbit 7-"},
    {"01_normal_colouring", 418, 220, "orbit 7-"},
    {"01_normal_colouring", 570, 184, "sky-"},
    {"02_lighting", 164, 326, "sky-"},
    {"02_lighting", 232, 196, "block-"},
    {"02_lighting", 240, 176, "block-"},
    {"02_lighting", 264, 90, "stage-"},
    {"02_lighting", 270, 210, "block+"},
    {"02_lighting", 274, 200, "block+"},
    {"02_lighting", 288, 100, "stage+"},
    {"02_lighting", 296, 78, "stage-"},
    {"02_lighting", 314, 338, "sky-"},
    {"02_lighting", 332, 256, "frame+"},
    {"02_lighting", 336, 258, "frame+"},
    {"02_lighting", 342, 84, "stage+"},
    {"02_lighting", 358, 214, "inside-"},
    {"02_lighting", 358, 242, "frame-"},
    {"02_lighting", 366, 200, "inside-"},
    {"02_lighting", 366, 284, "above-"},
    {"02_lighting", 368, 290, "above-"},
    {"02_lighting", 372, 240, "frame-"},
    {"02_lighting", 400, 116, "resting-"},
    {"02_lighting", 402, 116, "resting-"},
    {"03_shadows", 18, 104, "sky-"},
    {"03_shadows", 230, 196, "block-"},
    {"03_shadows", 234, 186, "block-"},
    {"03_shadows", 262, 192, "block#"},
    {"03_shadows", 264, 190, "block#"},
    {"03_shadows", 278, 192, "block+"},
    {"03_shadows", 282, 192, "block+"},
    {"03_shadows", 300, 76, "stage-"},
    {"03_shadows", 308, 136, "stage#"},
    {"03_shadows", 326, 66, "stage-"},
    {"03_shadows", 350, 112, "stage+"},
    {"03_shadows", 358, 242, "frame-"},
    {"03_shadows", 360, 210, "inside-"},
    {"03_shadows", 366, 282, "above-"},
    {"03_shadows", 368, 196, "inside-"},
    {"03_shadows", 368, 276, "above-"},
    {"03_shadows", 372, 86, "stage#"},
    {"03_shadows", 380, 210, "inside#"},
    {"03_shadows", 382, 212, "inside#"},
    {"03_shadows", 398, 118, "resting-"},
    {"03_shadows", 398, 192, "frame-"},
    {"03_shadows", 420, 104, "resting-"},
    {"03_shadows", 446, 66, "stage+"},
    {"03_shadows", 490, 240, "sky-"},
    {"1_screen", 124, 206, "screen-"},
    {"1_screen", 230, 156, "screen-"},
    {"1_screen", 350, 236, "screen-"},
    {"1_screen", 40, 314, "screen-"},
    {"1_screen", 440, 244, "screen-"},
    {"2_distance", 210, 228, "inside-"},
    {"2_distance", 222, 162, "inside-"},
    {"2_distance", 24, 334, "outside-"},
    {"2_distance", 240, 330, "outside-"},
    {"2_distance", 258, 202, "inside-"},
    {"2_distance", 28, 56, "outside-"},
    {"3_ray", 124, 206, "ray-"},
    {"3_ray", 230, 156, "ray-"},
    {"3_ray", 350, 236, "ray-"},
    {"3_ray", 40, 314, "ray-"},
    {"3_ray", 440, 244, "ray-"},
    {"4_march", 146, 312, "sky-"},
    {"4_march", 164, 204, "sky-"},
    {"4_march", 188, 330, "sky-"},
    {"4_march", 246, 110, "ground-"},
    {"4_march", 274, 200, "ball-"},
    {"4_march", 278, 228, "ball-"},
    {"4_march", 302, 182, "ball-"},
    {"4_march", 304, 12, "ground-"},
    {"4_march", 368, 68, "ground-"},
    {"5_light", 148, 112, "ground+"},
    {"5_light", 266, 232, "ball+"},
    {"5_light", 342, 196, "ball+"},
    {"5_light", 376, 138, "ball-"},
    {"5_light", 384, 172, "ball-"},
    {"5_light", 474, 34, "ground+"},
    {"5_light", 532, 196, "sky-"},
    {"5_light", 578, 124, "ground+"},
    {"5_light", 82, 324, "sky-"},
};

enum { PIXELS = sizeof pixels / sizeof pixels[0] };

static void check_named(const char *name)
{
    const struct mirror_picture *picture = mirror_find(name);
    assert_non_null(picture);
    const struct pixel_list list = {pixels, PIXELS, tolerance_of(name)};
    pixels_check(picture, &list);
}

static void test_first_steps(void **unused)
{
    (void)unused;
    check_named("1_screen");
    check_named("2_distance");
    check_named("3_ray");
    check_named("4_march");
    check_named("5_light");
}

static void test_chapter_00(void **unused)
{
    (void)unused;
    check_named("00_first_scene");
}

static void test_chapter_01(void **unused)
{
    (void)unused;
    check_named("01_normal_colouring");
}

static void test_chapter_02(void **unused)
{
    (void)unused;
    check_named("02_lighting");
}

static void test_chapter_03(void **unused)
{
    (void)unused;
    check_named("03_shadows");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_first_steps), cmocka_unit_test(test_chapter_00),
        cmocka_unit_test(test_chapter_01),  cmocka_unit_test(test_chapter_02),
        cmocka_unit_test(test_chapter_03),
    };
    return cmocka_run_group_tests_name("pixels", tests, gpu_setup, gpu_teardown);
}
