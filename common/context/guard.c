#include "context/guard.h"

#include <limits.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include "report.h"

#define STACK_NEEDED (1024 * 1024) // bytes
#define CACHE_NEEDED 4e6           // bytes; the first file of Mesa's takes 1.3 million
#define MEMORY_MOST  4e9           // bytes that a driver may take for one program
#define THREADS_MOST 32            // that llvmpipe starts, one for each processor

static struct {
    char said[1024];
    char stack[64 * 1024]; // for the signal, as the other one may be used up
    struct sigaction before;
    stack_t stack_before;
    struct rlimit memory_before;
    bool limited;
} crash;

bool guard_stack(void)
{
    struct rlimit limit;
    if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= STACK_NEEDED)
        return true;
    return report(
        "the stack may take %lu KiB only, and %d are needed: allow more with ulimit -s 8192",
        (unsigned long)limit.rlim_cur / 1024, STACK_NEEDED / 1024);
}

// ---- Threads ----

static void *wait_for(void *turn)
{
    pthread_mutex_lock(turn);
    pthread_mutex_unlock(turn);
    return NULL;
}

// llvmpipe waits for ever for a thread that it could not start. Where it may not have all that it
// wants at the same time, it is told to do with none.
static void guard_threads(void)
{
    pthread_mutex_t turn = PTHREAD_MUTEX_INITIALIZER;
    pthread_t thread[THREADS_MOST];
    long processors = sysconf(_SC_NPROCESSORS_ONLN), started = 0;
    long wanted = processors < THREADS_MOST ? processors : THREADS_MOST;
    pthread_mutex_lock(&turn);
    while (started < wanted && pthread_create(&thread[started], NULL, wait_for, &turn) == 0)
        started++;
    pthread_mutex_unlock(&turn);
    for (long i = 0; i < started; i++)
        pthread_join(thread[i], NULL);
    if (started < wanted)
        setenv("LP_NUM_THREADS", "0", 1);
}

// ---- Caches ----

void guard_forget_caches(void)
{
    setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
    setenv("MESA_GLSL_CACHE_DISABLE", "true", 1);
    setenv("__GL_SHADER_DISK_CACHE", "0", 1);
}

// Without room for the cache, do without it.
static void guard_cache(void)
{
    static const char *const folders[][2] = {
        {"MESA_SHADER_CACHE_DIR", ""}, {"XDG_CACHE_HOME", ""}, {"HOME", "/.cache"}, {"HOME", ""}};
    struct statvfs disk;
    char path[PATH_MAX];
    for (size_t i = 0; i < sizeof folders / sizeof *folders; i++) {
        const char *folder = getenv(folders[i][0]);
        if (folder == NULL ||
            snprintf(path, sizeof path, "%s%s", folder, folders[i][1]) >= (int)sizeof path ||
            statvfs(path, &disk) != 0)
            continue;
        if ((double)disk.f_bavail * (double)disk.f_frsize < CACHE_NEEDED)
            guard_forget_caches();
        return;
    }
}

// ---- Signals ----

static void end(const char *said)
{
    ssize_t written = write(STDERR_FILENO, said, strlen(said));
    (void)written;
    _exit(1);
}

static void on_crash(int number)
{
    (void)number;
    end(crash.said);
}

// Mesa's shader cache is a file in memory: on a full disk, writing into it ends in this signal.
static void on_missing_page(int number)
{
    (void)number;
    end("the graphics driver lost its memory: is the disk full that holds its cache of shaders? "
        "set MESA_SHADER_CACHE_DISABLE=true\n");
}

void guard_process(void)
{
    struct sigaction action = {.sa_handler = on_missing_page, .sa_flags = SA_ONSTACK};
    sigaction(SIGBUS, &action, NULL);
    guard_cache();
    guard_threads();
}

void guard_memory(void)
{
    struct rlimit limit;
    double pages = 0.0;
    FILE *file = fopen("/proc/self/statm", "r");
    bool known = file != NULL && fscanf(file, "%lf", &pages) == 1;
    if (file != NULL)
        fclose(file);
    if (!known || getrlimit(RLIMIT_AS, &limit) != 0)
        return;
    crash.memory_before = limit;
    double most = pages * (double)sysconf(_SC_PAGESIZE) + MEMORY_MOST;
    if (most < (double)limit.rlim_cur)
        limit.rlim_cur = (rlim_t)most;
    crash.limited = setrlimit(RLIMIT_AS, &limit) == 0;
}

void guard_begin(const char *format, ...)
{
    struct sigaction action = {.sa_handler = on_crash, .sa_flags = SA_ONSTACK};
    stack_t own = {.ss_sp = crash.stack, .ss_size = sizeof crash.stack};
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(crash.said, sizeof crash.said - 1, format, arguments);
    va_end(arguments);
    strcat(crash.said, "\n");
    sigaltstack(&own, &crash.stack_before);
    sigaction(SIGSEGV, &action, &crash.before);
}

void guard_end(void)
{
    if (crash.limited)
        setrlimit(RLIMIT_AS, &crash.memory_before);
    crash.limited = false;
    sigaction(SIGSEGV, &crash.before, NULL);
    sigaltstack(&crash.stack_before, NULL);
}
