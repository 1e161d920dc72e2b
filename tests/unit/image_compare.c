// image_compare.c - tests tests/lib/compare.c, which computes the two measures f2 and b8 and
// decides with them whether two pictures are the same.
#include "lib/test.h"
#include "lib/compare.h"
#include "lib/image.h"
#include "lib/scratch.h"

static void assert_near(double value, double expected, double tolerance)
{
    if (fabs(value - expected) > tolerance)
        fail_msg("%.17g is not %.17g", value, expected);
}

TEST(identical_pictures_do_not_differ)
{
    struct image a = picture_smooth(203, 101), b = picture_copy(&a);
    struct image_difference difference;
    assert_true(image_compare(&a, &b, &difference));
    assert_true(difference.f2 == 0.0 && difference.b8 == 0.0);
    assert_int_equal(difference.largest, 0);
    assert_int_equal(difference.differs, 0);
    assert_true(image_same(&difference));
    image_free(&a);
    image_free(&b);
}

// A single pixel differs, by 64 in green: first in a full block, then in the corner block, which is
// 3x5 pixels because the picture has 203x101 = (25 * 8 + 3) x (12 * 8 + 5) pixels.
TEST(one_pixel_counts_as_defined)
{
    const double blocks = 26.0 * 13.0;
    struct image a = picture_smooth(203, 101), b = picture_copy(&a);
    struct image_difference difference;
    unsigned char *first = &b.pixel[1], *last = &b.pixel[3 * (203 * 101 - 1) + 1];
    *first = (unsigned char)(*first ^ 64);
    assert_true(image_compare(&a, &b, &difference));
    assert_near(difference.f2, 1.0 / (203.0 * 101.0), 1e-15);
    assert_near(difference.b8, 64.0 / 64.0 / sqrt(blocks), 1e-12);
    assert_int_equal(difference.largest, 64);
    assert_int_equal(difference.differs, 1);
    assert_int_equal(difference.x, 0);
    assert_int_equal(difference.y, 100);
    assert_true(image_same(&difference));
    *first = (unsigned char)(*first ^ 64);
    *last = (unsigned char)(*last ^ 64);
    assert_true(image_compare(&a, &b, &difference));
    assert_near(difference.b8, 64.0 / 15.0 / sqrt(blocks), 1e-12);
    assert_int_equal(difference.x, 202);
    assert_int_equal(difference.y, 0);
    image_free(&a);
    image_free(&b);
}

TEST(two_is_tolerated_and_three_is_not)
{
    struct image a = picture_smooth(64, 64), b = picture_copy(&a);
    struct image_difference difference;
    b.pixel[300] = (unsigned char)(a.pixel[300] + 2);
    assert_true(image_compare(&a, &b, &difference));
    assert_true(difference.f2 == 0.0 && difference.differs == 1);
    b.pixel[300] = (unsigned char)(a.pixel[300] - 3);
    assert_true(image_compare(&a, &b, &difference));
    assert_near(difference.f2, 1.0 / 4096.0, 1e-15);
    image_free(&a);
    image_free(&b);
}

TEST(a_shift_by_one_pixel_is_caught)
{
    struct image a = picture_smooth(640, 360), b = picture_copy(&a);
    struct image_difference difference;
    memmove(b.pixel + 3, a.pixel, 3 * (640 * 360 - 1));
    assert_true(image_compare(&a, &b, &difference));
    assert_true(difference.f2 > 0.1);
    assert_false(image_same(&difference));
    image_free(&a);
    image_free(&b);
}

TEST(a_little_more_everywhere_is_caught)
{
    struct image a = picture_smooth(203, 101), b = picture_copy(&a);
    struct image_difference difference;
    for (int i = 2; i < 3 * 203 * 101; i += 3)
        b.pixel[i] = (unsigned char)(b.pixel[i] + 1);
    assert_true(image_compare(&a, &b, &difference));
    assert_true(difference.f2 == 0.0);
    assert_near(difference.b8, 1.0, 1e-12);
    assert_false(image_same(&difference));
    image_free(&a);
    image_free(&b);
}

TEST(both_measures_decide)
{
    struct image_difference difference = {.f2 = 0.0005, .b8 = 0.15};
    assert_true(image_same(&difference));
    difference.f2 = 0.00051;
    assert_false(image_same(&difference));
    difference = (struct image_difference){.b8 = 0.151};
    assert_false(image_same(&difference));
}

TEST(different_sizes_are_not_compared)
{
    struct image a = picture_smooth(8, 6), b = picture_smooth(6, 8), picture = {0};
    struct image_difference difference;
    capture_begin();
    assert_true(picture_refused(image_compare(&a, &b, &difference), "8x6 and 6x8"));
    capture_begin();
    assert_true(picture_refused(image_difference_picture(&a, &b, &picture), "8x6 and 6x8"));
    image_free(&a);
    image_free(&b);
}

TEST(the_difference_can_be_seen)
{
    static unsigned char before[] = {10, 20, 255, 0, 100, 100};
    static unsigned char after[] = {10, 21, 0, 255, 90, 131};
    static const unsigned char expected[] = {128, 132, 0, 255, 88, 252};
    const struct image a = {.width = 2, .height = 1, .pixel = before};
    const struct image b = {.width = 2, .height = 1, .pixel = after};
    struct image picture = {0};
    assert_true(image_difference_picture(&a, &b, &picture));
    assert_memory_equal(picture.pixel, expected, sizeof expected);
    image_free(&picture);
}

TESTS(NULL, NULL)
