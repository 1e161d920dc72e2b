// guard.c - tests what a program prints when its driver crashes, above all when the memory of the
// process is limited. The crashes are simulated, so that no test depends on how much memory a
// driver needs.
#include "lib/test.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "context/guard.h"
#include "lib/scratch.h"
#include "memory.h"
#include "picture/image.h"
#include "report.h"

// More memory than any process has, even under a sanitizer, but a limit nevertheless.
#define PLENTY ((rlim_t)1 << 46)

enum { NO_LIMIT = -1 };

// Run a function in a child process whose use of a resource is limited. The child must end with
// status 1. Returns what it prints, valid until the next call.
static const char *run_limited(int resource, rlim_t most, void (*body)(void))
{
    const struct rlimit limit = {most, RLIM_INFINITY};
    capture_begin();
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        if (resource != NO_LIMIT && setrlimit(resource, &limit) != 0)
            _exit(3);
        guard_process();
        body();
        _exit(2);
    }
    int status = -1;
    waitpid(child, &status, 0);
    const char *said = capture_end();
    assert_true(WIFEXITED(status));
    assert_int_equal(WEXITSTATUS(status), 1);
    return said;
}

static void crash_guarded(void)
{
    guard_begin("egl: the graphics driver crashed on %s", "\x1b[31m\xe9");
    raise(SIGSEGV);
}

static void abort_guarded(void)
{
    guard_begin("egl: the graphics driver crashed");
    raise(SIGABRT);
}

static void crash_in_own_limit(void)
{
    guard_begin("egl: the graphics driver crashed");
    guard_memory();
    raise(SIGSEGV);
}

static void crash_outside(void)
{
    guard_begin("this is not the reason");
    guard_end();
    raise(SIGSEGV);
}

#define END "; this process may use only 70368744 MB of memory: raise the limit (ulimit -%s)\n"

static void assert_ends(const char *said, const char *begin, const char *option)
{
    char expected[256];
    snprintf(expected, sizeof expected, "%s" END, begin, option);
    assert_string_equal(said, expected);
}

TEST(a_crash_names_the_limit)
{
    assert_ends(run_limited(RLIMIT_AS, PLENTY, crash_guarded),
                "egl: the graphics driver crashed on ?[31m?", "v");
    assert_ends(run_limited(RLIMIT_DATA, PLENTY, crash_guarded),
                "egl: the graphics driver crashed on ?[31m?", "d");
    assert_ends(run_limited(RLIMIT_AS, PLENTY, abort_guarded), "egl: the graphics driver crashed",
                "v");
    assert_ends(run_limited(RLIMIT_AS, PLENTY, crash_outside), "the graphics driver crashed", "v");
}

TEST(a_crash_without_a_limit_names_none)
{
    assert_string_equal(run_limited(NO_LIMIT, 0, crash_guarded),
                        "egl: the graphics driver crashed on ?[31m?\n");
    assert_string_equal(run_limited(NO_LIMIT, 0, abort_guarded),
                        "egl: the graphics driver crashed\n");
    // guard_memory's own limit is not one that the user could raise.
    assert_string_equal(run_limited(NO_LIMIT, 0, crash_in_own_limit),
                        "egl: the graphics driver crashed\n");
}

// ---- Memory that the programs themselves request ----

#ifndef __SANITIZE_ADDRESS__ // a sanitizer ends the process instead
// The beginning of a PNG of 16384x16384 pixels.
static const unsigned char large[] = {137, 80,  78,  71, 13,  10, 26, 10, 0,   0,  0,  13, 73, 72,
                                      68,  82,  0,   0,  64,  0,  0,  0,  64,  0,  8,  6,  0,  0,
                                      0,   169, 200, 16, 132, 0,  0,  0,  100, 73, 68, 65, 84};

static void need_too_much(void)
{
    memory_zeros((size_t)1 << 40, 1);
}

static void read_large(void)
{
    struct image_bytes bytes;
    char why[IMAGE_WHY];
    if (!image_read_bytes(&bytes, scratch_path("large.png"), 4, (size_t)1 << 30, why))
        report("%s", why);
    _exit(1);
}

TEST(a_lack_of_memory_names_the_limit)
{
    assert_non_null(strstr(run_limited(RLIMIT_AS, (rlim_t)1 << 30, need_too_much),
                           "close other programs; this process may use only 1074 MB"));
    scratch_write_bytes("large.png", large, sizeof large);
    assert_non_null(strstr(run_limited(RLIMIT_AS, (rlim_t)1 << 30, read_large),
                           "not enough memory; this process may use only 1074 MB"));
}
#endif

TESTS(scratch_setup, scratch_teardown)
