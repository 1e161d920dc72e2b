#include "lib/test.h"

static struct {
    struct CMUnitTest test[64];
    int line[64];
    size_t count;
} all;

void test_add(int line, const struct CMUnitTest *test)
{
    if (all.count == sizeof all.line / sizeof *all.line)
        abort();
    size_t at = all.count++;
    for (; at > 0 && all.line[at - 1] > line; at--) {
        all.test[at] = all.test[at - 1];
        all.line[at] = all.line[at - 1];
    }
    all.test[at] = *test;
    all.line[at] = line;
}

int test_run(CMFixtureFunction setup, CMFixtureFunction teardown)
{
    return _cmocka_run_group_tests("tests", all.test, all.count, setup, teardown);
}
