// platform.h for Linux, macOS and similar systems: files, the program, its environment.
#include "platform.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#ifdef __APPLE__
#include <mach-o/dyld.h>
#define MODIFIED(status) ((status).st_mtimespec)
#else
#define MODIFIED(status) ((status).st_mtim)
#endif

enum { LINK_LIMIT = 40 };

// ---- Files that are read ----

bool platform_look(const char *path, struct platform_file *file)
{
    struct stat status;
    *file = (struct platform_file){0};
    if (stat(path, &status) != 0)
        return false;
    *file = (struct platform_file){
        .regular = S_ISREG(status.st_mode),
        .size = (long long)status.st_size,
        .changed = 1000000000LL * MODIFIED(status).tv_sec + MODIFIED(status).tv_nsec,
        .identity = {(unsigned long long)status.st_dev, (unsigned long long)status.st_ino}};
    return true;
}

bool platform_is_same(const struct platform_file *one, const struct platform_file *other)
{
    return one->identity[0] == other->identity[0] && one->identity[1] == other->identity[1];
}

char *platform_resolve(const char *path)
{
    return realpath(path, NULL);
}

// O_NONBLOCK prevents the program from hanging if a FIFO replaces the file after platform_look.
FILE *platform_open(const char *path)
{
    struct platform_file file;
    if (platform_look(path, &file) && !file.regular) {
        errno = 0;
        return NULL;
    }
    int number = open(path, O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    return number < 0 ? NULL : fdopen(number, "r");
}

FILE *platform_open_text(char **text, size_t *size)
{
    return open_memstream(text, size);
}

bool platform_close_text(FILE *stream)
{
    bool failed = ferror(stream) != 0;
    return fclose(stream) == 0 && !failed;
}

// ---- Files that are written ----

// Follow the links in the last component of a path, even to a missing file, because a rename would
// replace the link itself. Returns 0 or an errno.
static int follow_links(const char *path, char target[PLATFORM_PATH])
{
    char text[PLATFORM_PATH], joined[PLATFORM_PATH];
    ssize_t length;
    if (snprintf(target, PLATFORM_PATH, "%s", path) >= PLATFORM_PATH)
        return ENAMETOOLONG;
    for (int i = 0; (length = readlink(target, text, sizeof text - 1)) >= 0; i++) {
        text[length] = '\0';
        const char *slash = strrchr(target, '/');
        int folder = text[0] == '/' || slash == NULL ? 0 : (int)(slash - target) + 1;
        if (i == LINK_LIMIT)
            return ELOOP;
        if (snprintf(joined, sizeof joined, "%.*s%s", folder, target, text) >= PLATFORM_PATH)
            return ENAMETOOLONG;
        strcpy(target, joined);
    }
    return errno == EINVAL || errno == ENOENT ? 0 : errno; // not a link, or no file
}

static const char *kind_of(mode_t mode)
{
    return S_ISDIR(mode)    ? "a folder"
           : S_ISCHR(mode)  ? "a character device"
           : S_ISBLK(mode)  ? "a block device"
           : S_ISFIFO(mode) ? "a pipe"
           : S_ISSOCK(mode) ? "a socket"
                            : "not a regular file";
}

static bool refuse(char why[PLATFORM_WHY], const char *phrase)
{
    snprintf(why, PLATFORM_WHY, "%s", phrase);
    return false;
}

// True if an existing file may be replaced. A rename needs only the folder's permission, but a
// write-protected file must not be replaced.
static bool may_replace(const char *path, mode_t mode, char why[PLATFORM_WHY])
{
    if (S_ISREG(mode))
        return access(path, W_OK) == 0 || refuse(why, strerror(errno));
    snprintf(why, PLATFORM_WHY, "it is %s: give the name of a file", kind_of(mode));
    return false;
}

// Return the length of a path's folder, including the last /, or 0 if the path has no folder.
static int folder_length(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash == NULL ? 0 : (int)(slash - path) + 1;
}

static bool folder_writable(const char *target, char why[PLATFORM_WHY])
{
    char inside[PLATFORM_PATH + 2];
    int length = folder_length(target);
    snprintf(inside, sizeof inside, "%.*s.", length, target);
    if (access(inside, W_OK | X_OK) == 0)
        return true;
    snprintf(why, PLATFORM_WHY, "folder %.*s: %s: choose another", length > 1 ? length - 1 : 1,
             length > 0 ? target : ".", strerror(errno));
    return false;
}

bool platform_target(const char *path, char target[PLATFORM_PATH], char why[PLATFORM_WHY])
{
    struct stat status;
    if (stat(path, &status) == 0) {
        if (!may_replace(path, status.st_mode, why))
            return false;
    } else if (errno != ENOENT || path[0] == '\0') {
        return refuse(why, strerror(errno));
    }
    int error = follow_links(path, target);
    if (error != 0)
        return refuse(why, strerror(error));
    if (target[strlen(target) - 1] == '/')
        return refuse(why, "a name that ends in / denotes a folder: give the name of a file");
    return folder_writable(target, why);
}

// Write data into a file and close it. Returns 0 or an errno.
static int write_and_close(int file, const char *data, size_t size)
{
    int error = 0;
    while (size > 0 && error == 0) {
        ssize_t written = write(file, data, size);
        error = written < 0 ? errno : 0;
        data += error == 0 ? written : 0;
        size -= error == 0 ? (size_t)written : 0;
    }
    return close(file) != 0 && error == 0 ? errno : error;
}

// Create a file with a new name in the target's folder. mkstemp would create a file that only its
// owner may read, and the umask cannot be read without changing it. Returns -1 with errno set on
// failure.
static int create_beside(const char *target, char name[PLATFORM_PATH + 64])
{
    int file = -1;
    for (int i = 0; file < 0 && (i == 0 || (errno == EEXIST && i < 100)); i++) {
        snprintf(name, PLATFORM_PATH + 64, "%.*s.picture-%ld-%d.tmp", folder_length(target), target,
                 (long)getpid(), i);
        file = open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    }
    return file;
}

// Write a new file beside the target and rename it. Returns 0 or an errno. After an error, no new
// file is left.
static int replace(const char *target, const char *data, size_t size)
{
    char name[PLATFORM_PATH + 64];
    int file = create_beside(target, name);
    if (file < 0)
        return errno;
    int error = write_and_close(file, data, size);
    if (error == 0 && rename(name, target) != 0)
        error = errno;
    if (error != 0)
        unlink(name);
    return error;
}

// A signal that ends the program waits until the file is complete. The signal for a file that
// exceeds the size limit is ignored, so that write() fails instead.
int platform_replace(const char *target, const char *data, size_t size)
{
    struct sigaction ignore = {.sa_handler = SIG_IGN}, before;
    sigset_t ending, mask;
    sigemptyset(&ending);
    sigaddset(&ending, SIGINT);
    sigaddset(&ending, SIGTERM);
    sigaddset(&ending, SIGHUP);
    sigprocmask(SIG_BLOCK, &ending, &mask);
    sigaction(SIGXFSZ, &ignore, &before);
    int error = replace(target, data, size);
    sigaction(SIGXFSZ, &before, NULL);
    sigprocmask(SIG_SETMASK, &mask, NULL);
    return error;
}

bool platform_reader_left(void)
{
    return write(STDOUT_FILENO, "\n", 1) < 0 && errno == EPIPE;
}

void platform_outlive_reader(void)
{
    signal(SIGPIPE, SIG_IGN);
}

const char *platform_why(int error)
{
    return strerror(error);
}

// ---- The program and its environment ----

bool platform_program(char path[PLATFORM_PATH])
{
#ifdef __APPLE__
    char own[PLATFORM_PATH];
    uint32_t size = sizeof own;
    char *resolved = _NSGetExecutablePath(own, &size) == 0 ? realpath(own, NULL) : NULL;
#else
    char *resolved = realpath("/proc/self/exe", NULL);
#endif
    bool told = resolved != NULL && snprintf(path, PLATFORM_PATH, "%s", resolved) < PLATFORM_PATH;
    free(resolved);
    return told;
}

void platform_set(const char *name, const char *value, bool over)
{
    setenv(name, value, over);
}

static double seconds_of(clockid_t clock)
{
    struct timespec now = {0};
    clock_gettime(clock, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double platform_processor_seconds(void)
{
    return seconds_of(CLOCK_PROCESS_CPUTIME_ID);
}

double platform_seconds(void)
{
    return seconds_of(CLOCK_MONOTONIC);
}

double platform_date(struct tm *date)
{
    struct timespec now = {0};
    clock_gettime(CLOCK_REALTIME, &now);
    localtime_r(&now.tv_sec, date);
    return 1e-9 * (double)now.tv_nsec;
}

bool platform_is_terminal(FILE *stream)
{
    return isatty(fileno(stream)) != 0;
}

#ifdef __APPLE__
enum platform_display platform_display(void)
{
    return PLATFORM_OWN_DISPLAY;
}
#else
static bool is_set(const char *variable)
{
    const char *value = getenv(variable);
    return value != NULL && value[0] != '\0';
}

enum platform_display platform_display(void)
{
    return is_set("WAYLAND_DISPLAY") ? PLATFORM_WAYLAND
           : is_set("DISPLAY") ? PLATFORM_X11
                               : PLATFORM_NO_DISPLAY;
}
#endif
