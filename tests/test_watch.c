// test_watch.c - a change of a file is told once, when the writing is over, and only of files that
// count.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "../common/window/watch.h"
#include "support_scratch.h"

enum { MANY = 50 };

static struct watch watch;
static char path[2][4096];

static void write_file(int file, const char *text)
{
    scratch_write(strrchr(path[file], '/') + 1, text);
}

// Look until a change is told. Returns how many looks that took, MANY when none was told.
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

static void a_change_is_told_once(void **unused)
{
    (void)unused;
    assert_int_equal(looks(), MANY);
    write_file(1, "another text");
    assert_int_equal(looks(), 2); // seen at the first, told at the second
    assert_int_equal(looks(), MANY);
}

static void what_is_still_written_waits(void **unused)
{
    (void)unused;
    static const char text[] = "a text that is written letter by letter";
    char part[sizeof text] = "";
    for (size_t i = 0; i < sizeof text - 1; i++) {
        part[i] = text[i];
        write_file(0, part);
        assert_false(watch_look(&watch));
    }
    assert_int_equal(looks(), 1);
}

// An editor that takes the file away, or empties it, before it writes it anew.
static void a_file_that_is_missing_is_waited_for(void **unused)
{
    (void)unused;
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
}

static void a_file_that_no_longer_counts_is_forgotten(void **unused)
{
    (void)unused;
    char *others[] = {path[1]};
    watch_keep(&watch, path[0], others, 1);
    assert_int_equal(watch.count, 2);
    watch_keep(&watch, path[0], NULL, 0);
    assert_int_equal(watch.count, 1);
    write_file(1, "another text");
    assert_int_equal(looks(), MANY);
    write_file(0, "another text");
    assert_int_equal(looks(), 2);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_change_is_told_once, set_up, tear_down),
        cmocka_unit_test_setup_teardown(what_is_still_written_waits, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_file_that_is_missing_is_waited_for, set_up, tear_down),
        cmocka_unit_test_setup_teardown(a_file_that_no_longer_counts_is_forgotten, set_up,
                                        tear_down),
    };
    return cmocka_run_group_tests_name("watch", tests, NULL, NULL);
}
