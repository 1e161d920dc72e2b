// platform.h for Linux, macOS and their like: what may happen to the process.
#include "platform.h"

#include <pthread.h>
#include <signal.h>
#include <stdint.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/statvfs.h>
#include <unistd.h>

enum { THREADS_LIMIT = 64 };

static struct {
    const char *words, *lost_page;
    char stack[64 * 1024]; // for the signal, as the other one may be used up
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

size_t platform_stack(void)
{
    struct rlimit limit;
    bool known = getrlimit(RLIMIT_STACK, &limit) == 0 && limit.rlim_cur < SIZE_MAX;
    return known ? (size_t)limit.rlim_cur : SIZE_MAX;
}

int platform_processors(void)
{
    return (int)sysconf(_SC_NPROCESSORS_ONLN);
}

static void *wait_for(void *turn)
{
    pthread_mutex_lock(turn);
    pthread_mutex_unlock(turn);
    return NULL;
}

bool platform_has_threads(int count)
{
    pthread_mutex_t turn = PTHREAD_MUTEX_INITIALIZER;
    pthread_t thread[THREADS_LIMIT];
    int started = 0;
    pthread_mutex_lock(&turn);
    while (started < count && pthread_create(&thread[started], NULL, wait_for, &turn) == 0)
        started++;
    pthread_mutex_unlock(&turn);
    for (int i = 0; i < started; i++)
        pthread_join(thread[i], NULL);
    return started == count;
}

double platform_room(const char *folder)
{
    struct statvfs disk;
    return statvfs(folder, &disk) == 0 ? (double)disk.f_bavail * (double)disk.f_frsize : -1.0;
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
