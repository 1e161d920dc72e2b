// test_signs.c - the numbers and words of the views: each stands whole in its room, at its height,
// and is the text that it stands for; a number in a picture is its digits beside each other.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

#include "picture/letters.h"
#include "picture/signs.h"

// Rooms of row 0 in cells, and of each word what plot.glsl keeps free for it.
static const int room[12] = {4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 2, 4};
static const int words[SIGNS_ROWS - 1] = {3, 32, 36, 8, 14, 27};

// What is covered of a part of the table, and where.
struct ink {
    double sum; // pixels
    int left, right, low, high;
};

// The part from a cell on, as wide as cells, of one row; places in pixels from its left end and its
// line.
static struct ink ink_of(const unsigned char *pixel, int cell, int row, int from, int cells)
{
    struct ink ink = {.left = 1 << 20, .right = -1, .low = 1 << 20, .high = -(1 << 20)};
    int line = (SIGNS_ROW * row + SIGNS_LINE) * cell, wide = SIGNS_WIDTH * cell;
    for (int y = -SIGNS_LINE * cell; y < (SIGNS_ROW - SIGNS_LINE) * cell; y++)
        for (int x = 0; x < cells * cell; x++) {
            int cover = pixel[(line + y) * wide + from * cell + x];
            ink.sum += cover / 255.0;
            if (cover < 64)
                continue;
            ink.left = x < ink.left ? x : ink.left;
            ink.right = x > ink.right ? x : ink.right;
            ink.low = y < ink.low ? y : ink.low;
            ink.high = y > ink.high ? y : ink.high;
        }
    return ink;
}

// The room to both sides of a digit is nearly the same; it stands on the line and is 5 cells high.
static void digits_stand_in_the_middle(void **unused)
{
    (void)unused;
    for (int cell = 1; cell <= 24; cell++) {
        unsigned char *pixel = signs_draw(cell);
        for (int i = 0; i < 10; i++) {
            struct ink ink = ink_of(pixel, cell, 0, 4 * i, room[i]);
            int behind = room[i] * cell - 1 - ink.right;
            // A 1 has its stroke right of the middle of its serif, a 4 and a 7 stand out to one
            // side.
            assert_true(abs(ink.left - behind) <= 1 + cell / 2);
            // What is round goes a tenth of a cell beyond.
            int beyond = 1 + cell / 8;
            assert_true(abs(ink.low) <= beyond && abs(ink.high + 1 - 5 * cell) <= beyond);
        }
        struct ink point = ink_of(pixel, cell, 0, 40, room[10]);
        assert_true(abs(point.low) <= 1 && point.high <= cell);
        struct ink minus = ink_of(pixel, cell, 0, 44, room[11]);
        assert_true(minus.low >= cell && minus.high <= 3 * cell);
        assert_true(minus.right - minus.left + 1 >= 2 * cell);
        assert_true(abs(minus.left - (room[11] * cell - 1 - minus.right)) <= 1 + cell / 8);
        free(pixel);
    }
}

// No image is cut off at its room's ends: there is as much ink as the letters have.
static void nothing_is_cut_off(void **unused)
{
    (void)unused;
    static const char *const texts[SIGNS_ROWS - 1] = {"t",   "distance", "threshold",
                                                      "hit", "miss",     "given up"};
    for (int cell = 1; cell <= 24; cell += 1 + cell / 4) {
        unsigned char *pixel = signs_draw(cell);
        struct letters letters = {0};
        letters_begin(&letters, (float)(5 * cell) / 7.3f);
        for (int row = 1; row < SIGNS_ROWS; row++) {
            double sum = 0.0;
            for (const char *at = texts[row - 1]; *at != '\0';) {
                const struct letter *letter = letters_find(&letters, letters_next(&at), 0);
                for (int y = 0; y < letter->height; y++)
                    for (int x = 0; x < letter->width; x++)
                        sum += letters.pixel[(letter->y + y) * LETTERS_ROW + letter->x + x] / 255.0;
            }
            struct ink ink = ink_of(pixel, cell, row, 0, SIGNS_WIDTH);
            assert_true(ink.right < words[row - 1] * cell);
            // The phase of a letter moves its ink from pixel to pixel; neighbours may share one.
            if (fabs(ink.sum - sum) > 0.02 * sum + 1.0)
                fail_msg("cell %d, '%s': %g pixels of %g", cell, texts[row - 1], ink.sum, sum);
        }
        letters_close(&letters);
        free(pixel);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(digits_stand_in_the_middle),
        cmocka_unit_test(nothing_is_cut_off),
    };
    return cmocka_run_group_tests_name("signs", tests, NULL, NULL);
}
