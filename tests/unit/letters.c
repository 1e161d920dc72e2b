// letters.c - tests the letters of the overlay: texts are read as UTF-8, the font has every
// character that the course uses, and the image of a letter covers the area inside its outline.
#include "lib/test.h"
#include "picture/letters.h"

// ---- Texts ----

TEST(texts_are_read_as_utf8)
{
    static const struct {
        const char *text;
        uint32_t code;
        int bytes;
    } wanted[] = {
        {"a", 'a', 1},
        {"\t", ' ', 1},
        {"\xc2\xb7", 0xB7, 2},
        {"\xe2\x86\x90", 0x2190, 3},
        {"\xf0\x9f\x98\x80", 0x1F600, 4},
        {"\n", 0xFFFD, 1},
        {"\x7f", 0xFFFD, 1},
        {"\xc2\x85", 0xFFFD, 2},         // a two-byte control character
        {"\xa9x", 0xFFFD, 1},            // a continuation byte without its start
        {"\xc3x", 0xFFFD, 1},            // a start byte without its continuation
        {"\xe2\x86", 0xFFFD, 2},         // a character cut off by the end of the text
        {"\xc1\x81", 0xFFFD, 2},         // an overlong encoding of A
        {"\xed\xa0\x80", 0xFFFD, 3},     // half of a surrogate pair
        {"\xf4\x90\x80\x80", 0xFFFD, 4}, // beyond the last code point
        {"\xff", 0xFFFD, 1},
    };
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++) {
        const char *at = wanted[i].text;
        uint32_t code = letters_next(&at);
        if (code != wanted[i].code || at - wanted[i].text != wanted[i].bytes)
            fail_msg("text %zu is read as U+%04X, from %d bytes", i, code,
                     (int)(at - wanted[i].text));
    }
}

// ---- The font ----

// A copy of a letter's image, because letters_find may move the atlas.
struct picture {
    struct letter letter;
    unsigned char pixel[128][128];
};

static struct picture picture_of(uint32_t code, float scale, int phase)
{
    struct letters letters = {0};
    struct picture picture = {.letter = {0}};
    letters_begin(&letters, scale);
    picture.letter = *letters_find(&letters, code, phase);
    for (int y = 0; y < picture.letter.height; y++)
        for (int x = 0; x < picture.letter.width; x++)
            picture.pixel[y][x] =
                letters.pixel[(picture.letter.y + y) * LETTERS_ROW + picture.letter.x + x];
    letters_close(&letters);
    return picture;
}

// True if the font lacks a letter, that is, if the letter looks like U+10FFFF, which no font has.
static bool is_missing(uint32_t code)
{
    struct picture missing = picture_of(0x10FFFF, 3.0f, 0), picture = picture_of(code, 3.0f, 0);
    return memcmp(&picture.pixel, &missing.pixel, sizeof picture.pixel) == 0;
}

// ASCII, accented letters of French and of other European languages, Greek, some Cyrillic,
// punctuation, the symbols of formulas, arrows and shapes.
static const char SIGNS[] =
    "!\"#$%&'()*+,-./"
    "0123456789:;<=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_`abcdefghijklmnopqrstuvwxyz{|}~"
    "àâäæçéèêëîïôöœùûüÿÀÂÄÆÇÉÈÊËÎÏÔÖŒÙÛÜŸñßåøąčěřšžıłő«»°²³µ·×÷±½"
    "αβγδεζηθικλμνξοπρςστυφχψωΓΔΘΛΞΠΣΦΨΩцукен"
    "–—‘’“”…•′″‹›₀₁₂₃ⁿ€ℝ←↑→↓↔⇒∂∇∈∏∑−∘√∞∥∧∨∩∪∫≈≠≤≥⊂⋅⌈⌉⌊⌋■□▲▶▼◀●○✓";

TEST(the_font_has_the_characters_of_the_course)
{
    for (const char *at = SIGNS; *at != '\0';) {
        uint32_t code = letters_next(&at);
        if (is_missing(code))
            fail_msg("the font lacks U+%04X", code);
        assert_true(letters_advance(code) > 0.0f);
    }
    assert_true(is_missing(0x1F600));
}

// Columns of numbers are aligned because every digit has the same width.
TEST(digits_have_the_same_width)
{
    for (uint32_t digit = '1'; digit <= '9'; digit++)
        assert_true(letters_advance(digit) == letters_advance('0'));
}

// ---- Images ----

static double covered(const struct picture *picture, double *middle)
{
    double sum = 0.0, moment = 0.0;
    for (int y = 0; y < picture->letter.height; y++)
        for (int x = 0; x < picture->letter.width; x++) {
            double share = picture->pixel[y][x] / 255.0;
            sum += share;
            moment += share * (picture->letter.left + x + 0.5);
        }
    *middle = moment / sum;
    return sum;
}

// According to its outline in the font's file, the black square is 1407/2048 of the em wide and
// 1568/2048 high. Its image covers the same area at every scale, and each phase moves the image by
// another quarter of a pixel.
TEST(an_image_covers_the_area_of_the_outline)
{
    static const double scales[] = {1.0, 1.5, 2.0, 3.0, 8.0};
    for (size_t i = 0; i < sizeof scales / sizeof *scales; i++) {
        double em = scales[i] * (double)LETTERS_EM / 2048.0, first = 0.0, middle;
        double wide = 1407.0 * em, high = 1568.0 * em;
        for (int phase = 0; phase < LETTERS_PHASES; phase++) {
            struct picture picture = picture_of(0x25A0, (float)scales[i], phase);
            // Pixels on the edge are rounded to multiples of 1/255, and the others are fully
            // covered.
            assert_true(fabs(covered(&picture, &middle) - wide * high) <=
                        2.0 * (wide + high + 4.0) / 255.0);
            first = phase == 0 ? middle : first;
            // The smallest square covers an area of 53 pixels, and 26 of its pixels are rounded.
            assert_true(fabs(middle - first - 0.25 * phase) <= 0.02);
        }
    }
}

// Each image keeps its contents while other images are added. At another scale, all images are
// drawn again.
TEST(images_do_not_disturb_each_other)
{
    struct letters letters = {0};
    for (int round = 0; round < 2; round++) {
        float scale = round == 0 ? 2.0f : 7.0f;
        letters_begin(&letters, scale);
        for (int pass = 0; pass < 2; pass++)
            for (const char *at = SIGNS; *at != '\0';) {
                uint32_t code = letters_next(&at);
                for (int phase = 0; phase < LETTERS_PHASES; phase++) {
                    const struct letter *letter = letters_find(&letters, code, phase);
                    assert_true(letter->x + letter->width <= LETTERS_ROW);
                    assert_true(letter->y + letter->height <= letters.rows);
                    struct picture alone = picture_of(code, scale, phase);
                    assert_int_equal(letter->width, alone.letter.width);
                    for (int y = 0; y < letter->height; y++)
                        assert_memory_equal(alone.pixel[y],
                                            letters.pixel + (letter->y + y) * LETTERS_ROW +
                                                letter->x,
                                            (size_t)letter->width);
                }
            }
    }
    letters_close(&letters);
    letters_close(&letters);
}

TESTS(NULL, NULL)
