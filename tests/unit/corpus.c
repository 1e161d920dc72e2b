// corpus.c - tests that no file of tests/corpus, from which `make fuzz` starts, breaks a promise
// that tests/lib/fuzz.h checks.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
// cmocka.h needs the four headers above.
#include <cmocka.h>

#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

#include "lib/fuzz.h"
#include "lib/gpu.h"
#include "lib/scratch.h"

#define FILE_LIMIT 65536
// The limit on the peak memory of the process, as a multiple of the peak at its start. No file is
// large, but a damaged file may claim to be.
#define GROWTH_LIMIT 40

static uint8_t bytes[FILE_LIMIT];
static long at_start;

// The peak memory of this process so far, in the unit of the system's ru_maxrss.
static long most_memory(void)
{
    struct rusage usage;
    assert_int_equal(getrusage(RUSAGE_SELF, &usage), 0);
    return usage.ru_maxrss;
}

// Run a target on every file in the target's folder of the corpus, and on seven prefixes of each
// file.
static void run_folder(const struct fuzz_target *target)
{
    char pattern[4096 + 64];
    glob_t files;
    snprintf(pattern, sizeof pattern, "%s/tests/corpus/%s/*", gpu_project_root(), target->name);
    assert_int_equal(glob(pattern, 0, NULL, &files), 0);
    assert_true(files.gl_pathc >= 10);
    for (size_t i = 0; i < files.gl_pathc; i++) {
        FILE *file = fopen(files.gl_pathv[i], "rb");
        assert_non_null(file);
        size_t size = fread(bytes, 1, sizeof bytes, file);
        fclose(file);
        assert_true(size < sizeof bytes);
        target->run(bytes, size);
        for (size_t part = 1; part < 8; part++)
            target->run(bytes, part * size / 8);
    }
    globfree(&files);
}

static void test_folder(void **state)
{
    run_folder(*state);
    printf("# the peak memory is %.1f times the peak at the start\n",
           (double)most_memory() / (double)at_start);
    assert_true(most_memory() < GROWTH_LIMIT * at_start);
}

int main(void)
{
    at_start = most_memory();
    struct CMUnitTest tests[FUZZ_TARGETS];
    for (int i = 0; i < FUZZ_TARGETS; i++)
        tests[i] = (struct CMUnitTest){.name = fuzz_targets[i].name,
                                       .test_func = test_folder,
                                       .initial_state = (void *)(size_t)&fuzz_targets[i]};
    return cmocka_run_group_tests(tests, scratch_setup, scratch_teardown);
}
