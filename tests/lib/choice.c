// The environment variable ONE_TEST, such as test_march_hits, selects the one test of a program
// that runs; '*' in it matches any characters.
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
