// platform.h for Linux, macOS and similar systems: crashes and memory.
#include "platform.h"

#include <signal.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

static struct {
    const char *words, *lost_page, *short_memory;
    char stack[64 * 1024]; // for the signal handler, in case the program's stack is used up
    struct sigaction before;
    stack_t stack_before;
    struct rlimit memory_before;
    bool limited;
} state;

static void end(const char *words)
{
    ssize_t written = write(STDERR_FILENO, words, strlen(words));
    (void)written;
    _exit(1);
}

static void on_crash(int number)
{
    (void)number;
    end(state.words);
}

static void on_short_memory(int number)
{
    (void)number;
    end(state.short_memory);
}

static void on_lost_page(int number)
{
    (void)number;
    end(state.lost_page);
}

void platform_watch_crash(const char *words)
{
    struct sigaction action = {.sa_handler = on_crash, .sa_flags = SA_ONSTACK};
    stack_t own = {.ss_sp = state.stack, .ss_size = sizeof state.stack};
    if (words == NULL) {
        sigaction(SIGSEGV, &state.before, NULL);
        sigaltstack(&state.stack_before, NULL);
        return;
    }
    state.words = words;
    sigaltstack(&own, &state.stack_before);
    sigaction(SIGSEGV, &action, &state.before);
}

void platform_watch_lost_page(const char *words)
{
    struct sigaction action = {.sa_handler = on_lost_page, .sa_flags = SA_ONSTACK};
    state.lost_page = words;
    sigaction(SIGBUS, &action, NULL);
}

void platform_watch_short_memory(const char *words)
{
    struct sigaction action = {.sa_handler = on_short_memory};
    struct rlimit limit;
    state.short_memory = words;
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return;
    sigaction(SIGSEGV, &action, NULL);
    sigaction(SIGABRT, &action, NULL); // without memory, LLVM prints two lines and aborts
}

void platform_limit_memory(double more)
{
    struct rlimit limit;
    double pages = 0.0;
    FILE *file = fopen("/proc/self/statm", "r");
    bool known = file != NULL && fscanf(file, "%lf", &pages) == 1;
    if (file != NULL)
        fclose(file);
    if (!known || getrlimit(RLIMIT_AS, &limit) != 0)
        return;
    state.memory_before = limit;
    double most = pages * (double)sysconf(_SC_PAGESIZE) + more;
    if (most < (double)limit.rlim_cur)
        limit.rlim_cur = (rlim_t)most;
    state.limited = setrlimit(RLIMIT_AS, &limit) == 0;
}

void platform_free_memory(void)
{
    if (state.limited)
        setrlimit(RLIMIT_AS, &state.memory_before);
    state.limited = false;
}
