// letters.c - the letters of the overlay: texts are read as UTF-8, the font has every character
// that the course writes, and an image covers the area inside the outline.
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
        {"\xa9x", 0xFFFD, 1},            // the middle of a character
        {"\xc3x", 0xFFFD, 1},            // a character without its end
        {"\xe2\x86", 0xFFFD, 2},         // cut off by the text's end
        {"\xc1\x81", 0xFFFD, 2},         // an overlong encoding of A
        {"\xed\xa0\x80", 0xFFFD, 3},     // half of a surrogate pair
        {"\xf4\x90\x80\x80", 0xFFFD, 4}, // beyond the last code
        {"\xff", 0xFFFD, 1},
    };
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; i++) {
        const char *at = wanted[i].text;
        uint32_t code = letters_next(&at);
        if (code != wanted[i].code || at - wanted[i].text != wanted[i].bytes)
            fail_msg("text %zu: %x, %d bytes", i, code, (int)(at - wanted[i].text));
    }
}

// ---- The font ----

// An image at a scale, copied: letters_find may move the table.
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

// A letter that the font lacks is drawn like this one.
static bool is_missing(uint32_t code)
{
    struct picture missing = picture_of(0x10FFFF, 3.0f, 0), picture = picture_of(code, 3.0f, 0);
    return memcmp(&picture.pixel, &missing.pixel, sizeof picture.pixel) == 0;
}

// Accents of French and of its neighbours, capitals, Greek, what pages write in formulas, arrows,
// quotes.
static const char SIGNS[] =
    "!\"#$%&'()*+,-./"
    "0123456789:;<=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[\\]^_`abcdefghijklmnopqrstuvwxyz{|}~"
    "àâäæçéèêëîïôöœùûüÿÀÂÄÆÇÉÈÊËÎÏÔÖŒÙÛÜŸñßåøąčěřšžıłő«»°²³µ·×÷±½"
    "αβγδεζηθικλμνξοπρςστυφχψωΓΔΘΛΞΠΣΦΨΩцукен"
    "–—‘’“”…•′″‹›₀₁₂₃ⁿ€ℝ←↑→↓↔⇒∂∇∈∏∑−∘√∞∥∧∨∩∪∫≈≠≤≥⊂⋅⌈⌉⌊⌋■□▲▶▼◀●○✓";

TEST(the_font_has_the_signs_of_the_course)
{
    for (const char *at = SIGNS; *at != '\0';) {
        uint32_t code = letters_next(&at);
        if (is_missing(code))
            fail_msg("the font lacks U+%04X", code);
        assert_true(letters_advance(code) > 0.0f);
    }
    assert_true(is_missing(0x1F600));
}

// Columns of numbers are aligned: every digit has the same width.
TEST(digits_have_one_width)
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

// The black square is 1407 of 2048 parts of the em wide and 1568 high, according to its outline in
// the font's file. Its image covers that many pixels at every scale; and a later phase moves it by
// a quarter of a pixel.
TEST(an_image_covers_what_the_outline_does)
{
    static const double scales[] = {1.0, 1.5, 2.0, 3.0, 8.0};
    for (size_t i = 0; i < sizeof scales / sizeof *scales; i++) {
        double em = scales[i] * (double)LETTERS_EM / 2048.0, first = 0.0, middle;
        double wide = 1407.0 * em, high = 1568.0 * em;
        for (int phase = 0; phase < LETTERS_PHASES; phase++) {
            struct picture picture = picture_of(0x25A0, (float)scales[i], phase);
            // Each pixel of the edge is rounded to 1/255, and the others are full.
            assert_true(fabs(covered(&picture, &middle) - wide * high) <=
                        2.0 * (wide + high + 4.0) / 255.0);
            first = phase == 0 ? middle : first;
            // The smallest square has 52 pixels of which 26 are rounded.
            assert_true(fabs(middle - first - 0.25 * phase) <= 0.02);
        }
    }
}

// Each image keeps its contents while others are added; at another scale, all are drawn again.
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
