// platform.h for Linux, macOS and similar systems: crashes and memory.
#include "platform.h"

#include <math.h>
#include <signal.h>
#include <spawn.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

static struct {
    const char *words, *lost_page;
    char stack[64 * 1024]; // for the signal handler, in case the program's stack is used up
    struct sigaction before[2];
    stack_t stack_before;
    struct rlimit memory_before;
    bool limited;
} state;

// A driver that cannot get more memory crashes or aborts.
static const int crashes[2] = {SIGSEGV, SIGABRT};

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

static void on_lost_page(int number)
{
    (void)number;
    end(state.lost_page);
}

void platform_watch_crash(const char *words)
{
    struct sigaction action = {.sa_handler = on_crash, .sa_flags = SA_ONSTACK};
    stack_t own = {.ss_sp = state.stack, .ss_size = sizeof state.stack};
    bool watched = state.words != NULL, watches = words != NULL;
    if (watches)
        state.words = words;
    if (watches && !watched)
        sigaltstack(&own, &state.stack_before);
    for (int i = 0; i < 2 && watches != watched; i++)
        sigaction(crashes[i], watches ? &action : &state.before[i],
                  watches ? &state.before[i] : NULL);
    if (!watches && watched)
        sigaltstack(&state.stack_before, NULL);
    state.words = words;
}

void platform_watch_lost_page(const char *words)
{
    struct sigaction action = {.sa_handler = on_lost_page, .sa_flags = SA_ONSTACK};
    state.lost_page = words;
    sigaction(SIGBUS, &action, NULL);
}

double platform_memory_limit(char *option)
{
    static const struct {
        int resource;
        char option;
    } kinds[] = {{RLIMIT_AS, 'v'}, {RLIMIT_DATA, 'd'}};
    double least = HUGE_VAL;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        struct rlimit limit = state.memory_before;
        bool known = (kinds[i].resource == RLIMIT_AS && state.limited) ||
                     getrlimit(kinds[i].resource, &limit) == 0;
        if (known && limit.rlim_cur != RLIM_INFINITY && (double)limit.rlim_cur < least) {
            least = (double)limit.rlim_cur;
            *option = kinds[i].option;
        }
    }
    return least;
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

// ---- The editor ----

extern char **environ;

bool platform_edit(const char *path)
{
    static char shell[] = "sh", option[] = "-c";
    static char find[] = "[ -n \"${VISUAL:-$EDITOR}\" ] || command -v xdg-open >/dev/null || "
                         "command -v open >/dev/null";
    static char script[] =
        "editor=${VISUAL:-$EDITOR}\n"
        "for each in xdg-open open; do\n"
        "    [ -n \"$editor\" ] || ! command -v $each >/dev/null || editor=$each\n"
        "done\n"
        "exec $editor \"$1\"";
    char *const look[] = {shell, option, find, NULL};
    char *const argument[] = {shell, option, script, shell, (char *)path, NULL};
    pid_t child;
    int status = 0;
    if (posix_spawnp(&child, shell, NULL, NULL, look, environ) != 0 ||
        waitpid(child, &status, 0) != child || status != 0)
        return false;
    return posix_spawnp(&child, shell, NULL, NULL, argument, environ) == 0;
}
