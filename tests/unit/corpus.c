// corpus.c - the files of tests/corpus, from which `make fuzz` starts, break no promise.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
// cmocka needs the four above.
#include <cmocka.h>

#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

#include "lib/fuzz.h"
#include "lib/gpu.h"
#include "lib/scratch.h"

#define FILE_LIMIT  65536
#define MOST_MEMORY 1000 // MB, for all files together: a damaged one may claim to be larger
#ifdef __APPLE__
#define RESIDENT_MB 1048576 // ru_maxrss counts bytes
#else
#define RESIDENT_MB 1024 // ru_maxrss counts kilobytes
#endif

static uint8_t bytes[FILE_LIMIT];

// A folder of the corpus: each file, and each prefix of it.
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
    struct rusage usage;
    assert_int_equal(getrusage(RUSAGE_SELF, &usage), 0);
    assert_in_range(usage.ru_maxrss / RESIDENT_MB, 1, MOST_MEMORY);
}

int main(void)
{
    struct CMUnitTest tests[FUZZ_TARGETS];
    for (int i = 0; i < FUZZ_TARGETS; i++)
        tests[i] = (struct CMUnitTest){.name = fuzz_targets[i].name,
                                       .test_func = test_folder,
                                       .initial_state = (void *)(size_t)&fuzz_targets[i]};
    return cmocka_run_group_tests(tests, scratch_setup, scratch_teardown);
}
