// The environment variable ONE_TEST selects which tests of a program run. Its value is the name of
// a test, for example a_ray_has_length_1, in which a '*' matches any characters.
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
