// The environment variable ONE_TEST, for example test_march_hits, selects the test of a program to
// run; '*' in it matches any characters.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

__attribute__((constructor)) static void choose(void)
{
    const char *name = getenv("ONE_TEST");
    if (name != NULL)
        cmocka_set_test_filter(name);
}
