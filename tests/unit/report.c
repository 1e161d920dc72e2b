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

TEST(a_long_line_is_cut)
{
    static char text[20000];
    memset(text, 'x', sizeof text - 1);
    const char *said = reported(text);
    size_t length = strlen(said);
    assert_int_equal(length, 8192);
    assert_string_equal(said + length - 5, "x...\n");
}

TEST(the_last_report_is_kept)
{
    char text[20000];
    capture_begin();
    report("first: %d", 1);
    assert_string_equal(report_last(), "first: 1\n");
    memset(text, 'y', sizeof text);
    for (size_t length = 8180; length < 8200; length++) {
        text[length] = '\0';
        report_lines(text);
        assert_true(strlen(report_last()) >= 8180);
        text[length] = 'y';
    }
    capture_end();
}

TESTS(NULL, NULL)
