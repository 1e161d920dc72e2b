// report.c - tests messages on standard error: a message is one line, which no name in it can
// break.
#include "lib/test.h"
#include "report.h"
#include "lib/scratch.h"

// Report a text, and return what is printed on standard error. report_last() must return the same
// text.
static const char *reported(const char *text)
{
    capture_begin();
    report("%s", text);
    const char *said = capture_end();
    assert_string_equal(said, report_last());
    return said;
}

TEST(control_characters_are_shown_not_obeyed)
{
    assert_string_equal(reported("plain"), "plain\n");
    assert_string_equal(reported("two\nlines\r\n"), "two?lines??\n");
    assert_string_equal(reported("a\tb\x1b[31m\x07\x7f\x01\x1f"), "a?b?[31m????\n");
    assert_string_equal(reported("\xc2\x80-\xc2\x9b[m\xc2\x9f"), "?-?[m?\n");
    // Other characters remain: é, a no-break space, and characters with bytes that look like
    // control characters.
    assert_string_equal(reported("\xc3\xa9 \xc2\xa0 \xc3\x9b \xe2\x82\xac ~"),
                        "\xc3\xa9 \xc2\xa0 \xc3\x9b \xe2\x82\xac ~\n");
}

TEST(a_text_may_have_several_lines)
{
    capture_begin();
    report_lines("one\n\ttwo\x1b[m\r\n");
    assert_string_equal(capture_end(), "one\n\ttwo?[m?\n");
    capture_begin();
    report_lines("no end\n of line");
    assert_string_equal(capture_end(), "no end\n of line\n");
}

// Each piece is followed by 'x', which must remain.
TEST(bytes_that_are_not_utf8_are_replaced)
{
    static const char *const pieces[] = {
        "\xe9",     // ISO 8859-1
        "\x80",     // the end of a character
        "\xe2\x82", // a character without its end
        "\xc0\xaf", // '/' in two bytes
        "\xe0\x80\x8a",
        "\xf0\x80\x80\x8a", // a line feed in three bytes and in four
        "\xed\xa0\x80",     // half of a UTF-16 pair
        "\xf4\x90\x80\x80", // beyond U+10FFFF
        "\xff",
        "\xfe",
        "\xe2\x80\xa8",
        "\xe2\x80\xa9", // U+2028, U+2029
        "\xe2\x80\xaa",
        "\xe2\x80\xae", // U+202A, U+202E
        "\xe2\x81\xa6",
        "\xe2\x81\xa9", // U+2066, U+2069
        "\xc2\x80",
        "\xc2\x9b", // U+0080, and U+009B, which begins a command
    };
    for (size_t i = 0; i < sizeof pieces / sizeof *pieces; i++) {
        char text[16], clean[16];
        snprintf(text, sizeof text, "%sx", pieces[i]);
        assert_string_equal(reported(text), "?x\n");
        report_clean(clean, sizeof clean, text);
        assert_string_equal(clean, "?x");
    }
    assert_string_equal(
        reported("\xe2\x80\xa7\xe2\x80\xaf\xe2\x81\xa5\xe2\x81\xaa\xf4\x8f\xbf\xbd"),
        "\xe2\x80\xa7\xe2\x80\xaf\xe2\x81\xa5\xe2\x81\xaa\xf4\x8f\xbf\xbd\n");
}

TEST(a_clean_copy_is_cut_between_characters)
{
    char clean[5];
    report_clean(clean, sizeof clean, "a\xc3\xa9\xc3\xa9");
    assert_string_equal(clean, "a\xc3\xa9");
    report_clean(clean, sizeof clean, "a\nb\x1b");
    assert_string_equal(clean, "a?b?");
    report_clean(clean, 1, "a");
    assert_string_equal(clean, "");
}

// A message of 100,000 bytes still says what, where, why and what to do.
TEST(a_long_word_is_shortened_in_the_middle)
{
    static char word[100001];
    for (size_t length = 238; length < sizeof word - 1;
         length = length < 243 ? length + 1 : sizeof word - 1) {
        memset(word, 'x', length);
        word[0] = 'a', word[length - 1] = 'z', word[length] = '\0';
        capture_begin();
        report("--set '%s': must be NAME=VALUE: %s/x.frag has these: é", word, word);
        const char *said = capture_end();
        assert_true(strlen(said) < 600);
        assert_int_equal(strncmp(said, "--set 'axxx", 11), 0);
        assert_non_null(strstr(said, "xxxz': must be NAME=VALUE: axxx"));
        assert_non_null(strstr(said, "z/x.frag has these: é\n"));
        assert_true((strstr(said, "...") != NULL) == (length > 237));
    }
    // No character is cut in two.
    for (int shift = 0; shift < 3; shift++) {
        size_t to = (size_t)shift;
        memset(word, 'x', to);
        for (int i = 0; i < 400; i++, to += 3)
            memcpy(word + to, "\xe2\x82\xac", 4);
        assert_null(strchr(reported(word), '?'));
    }
}

TEST(a_long_line_is_shortened_in_the_middle)
{
    static char text[100001];
    for (size_t i = 0; i < sizeof text - 1; i++)
        text[i] = i % 10 == 9 ? ' ' : 'x';
    capture_begin();
    report("begin %s end", text);
    const char *said = capture_end();
    assert_int_equal(strlen(said), 1599 + 1);
    assert_int_equal(strncmp(said, "begin xxx", 9), 0);
    assert_string_equal(said + strlen(said) - 5, " end\n");
    // Each line of a longer text is shortened on its own.
    char *lines = malloc(3 * sizeof text);
    assert_non_null(lines);
    snprintf(lines, 3 * sizeof text, "one\n%s\n\ttwo\n\n%s", text, text);
    capture_begin();
    report_lines(lines);
    said = capture_end();
    assert_int_equal(line_count(said), 5);
    assert_int_equal(strlen(said), 2 * (1599 + 1) + 4 + 5 + 1);
    assert_non_null(strstr(said, "\n\ttwo\n\nxxx"));
    free(lines);
}

TEST(the_last_report_is_kept)
{
    char text[20000];
    capture_begin();
    report("first: %d", 1);
    assert_string_equal(report_last(), "first: 1\n");
    for (size_t i = 0; i < sizeof text; i++)
        text[i] = i % 10 == 9 ? '\n' : 'y';
    for (size_t length = 8180; length < 8200; length++) {
        text[length] = '\0';
        report_lines(text);
        assert_true(strlen(report_last()) >= 8180);
        text[length] = length % 10 == 9 ? '\n' : 'y';
    }
    capture_end();
}

TESTS(NULL, NULL)
