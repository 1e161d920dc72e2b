// test.h - makes a program of tests that cmocka runs, and includes the headers that all tests need:
//
//   TEST(a_ray_has_length_1)
//   {
//       assert_true(...);
//   }
//
//   TESTS(gpu_setup, gpu_teardown)
//
// The tests run in the order in which they are written. If the environment variable ONE_TEST is
// set, for example to a_ray_has_length_1, only the tests with this name run. A '*' in the name
// matches any characters.
#ifndef TESTS_TEST_H
#define TESTS_TEST_H

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

// A test; its body can use 'void **state'. The second form takes a setup and a teardown function of
// cmocka; each may be NULL.
#define TEST(name) TEST_WITH(name, NULL, NULL)
#define TEST_WITH(name, setup, teardown)                                                           \
    static void name(void **state);                                                                \
    __attribute__((constructor)) static void add_##name(void)                                      \
    {                                                                                              \
        test_add(__LINE__, &(struct CMUnitTest){#name, name, setup, teardown, NULL});              \
    }                                                                                              \
    static void name(__attribute__((unused)) void **state)

// The program, which runs all tests of the file. Setup and teardown, which may be NULL, run once.
#define TESTS(setup, teardown)                                                                     \
    int main(void)                                                                                 \
    {                                                                                              \
        return test_run(setup, teardown);                                                          \
    }

// Used only by the macros above.
//   line  the test's line in the file; the tests run in the order of their lines
void test_add(int line, const struct CMUnitTest *test);
int test_run(CMFixtureFunction setup, CMFixtureFunction teardown);

#endif
