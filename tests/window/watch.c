// watch.c - tests that a change to a file is reported once, after it is complete, and only for
// watched files.
#include "lib/test.h"
#include "window/watch.h"
#include "lib/scratch.h"
#include "lib/system.h"

enum { MANY = 50 };

static struct watch watch;
static char path[2][4096];

static void write_file(int file, const char *text)
{
    scratch_write(strrchr(path[file], '/') + 1, text);
}

// Poll until a change is reported. Returns the number of polls, or MANY if none was reported.
static int looks(void)
{
    int count = 1;
    while (count < MANY && !watch_look(&watch))
        count++;
    return count;
}

static int set_up(void **unused)
{
    (void)unused;
    scratch_make();
    for (int i = 0; i < 2; i++) {
        strcpy(path[i], scratch_write(i == 0 ? "one.frag" : "two.glsl", "text"));
        watch_add(&watch, path[i]);
        watch_add(&watch, path[i]);
    }
    return watch.count == 2 ? 0 : -1;
}

static int tear_down(void **unused)
{
    (void)unused;
    watch_clear(&watch);
    scratch_remove();
    return 0;
}

TEST_WITH(a_change_is_reported_once, set_up, tear_down)
{
    assert_int_equal(looks(), MANY);
    write_file(1, "another text");
    assert_int_equal(looks(), 2); // noticed at the first poll, reported at the second
    assert_int_equal(looks(), MANY);
}

TEST_WITH(a_file_that_is_still_being_written_is_not_reported, set_up, tear_down)
{
    static const char text[] = "a text that is written letter by letter";
    char part[sizeof text] = "";
    for (size_t i = 0; i < sizeof text - 1; i++) {
        part[i] = text[i];
        write_file(0, part);
        assert_false(watch_look(&watch));
    }
    assert_int_equal(looks(), 1);
}

// Some editors remove or empty a file before they write it again.
TEST_WITH(a_missing_file_is_reported_only_after_a_while, set_up, tear_down)
{
    for (int emptied = 0; emptied < 2; emptied++) {
        if (emptied)
            write_file(0, "");
        else
            remove(path[0]);
        for (int i = 0; i < 4; i++)
            assert_false(watch_look(&watch));
        write_file(0, emptied ? "back once more" : "back");
        assert_int_equal(looks(), 2);
        assert_int_equal(looks(), MANY);
    }
    remove(path[0]);
    int until_missed = looks();
    assert_true(until_missed >= 4 && until_missed < MANY);
    assert_int_equal(looks(), MANY);
    write_file(1, "a shader that no longer includes a missing file");
    assert_int_equal(looks(), 2);
}

TEST_WITH(a_file_that_no_longer_counts_is_forgotten, set_up, tear_down)
{
    for (int kept = 1; kept >= 0; kept--) {
        watch_begin(&watch);
        for (int i = 0; i <= kept; i++)
            watch_add(&watch, path[i]);
        watch_end(&watch);
        assert_int_equal(watch.count, kept + 1);
    }
    write_file(1, "another text");
    assert_int_equal(looks(), MANY);
    write_file(0, "another text");
    assert_int_equal(looks(), 2);
}

TEST_WITH(a_watch_leaves_no_file_open, set_up, tear_down)
{
    struct watch other = {0};
    int before = system_open_files();
    for (int i = 0; i < 50; i++) {
        watch_add(&other, path[i % 2]);
        watch_look(&other);
        watch_clear(&other);
    }
    assert_int_equal(system_open_files(), before);
}

TESTS(NULL, NULL)
