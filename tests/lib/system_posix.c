#include "lib/system.h"

#include <dirent.h>
#include <ftw.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

bool system_make_scratch(char path[PLATFORM_PATH])
{
    const char *parent = getenv("TMPDIR");
    snprintf(path, PLATFORM_PATH, "%s/march-test-XXXXXX",
             parent != NULL && parent[0] != '\0' ? parent : "/tmp");
    char *resolved = mkdtemp(path) != NULL ? realpath(path, NULL) : NULL;
    if (resolved != NULL)
        snprintf(path, PLATFORM_PATH, "%s", resolved);
    free(resolved);
    return resolved != NULL;
}

bool system_make_folder(const char *path)
{
    return mkdir(path, 0700) == 0;
}

static int remove_one(const char *path, const struct stat *status, int type, struct FTW *walk)
{
    (void)status, (void)type, (void)walk;
    return remove(path);
}

bool system_remove_folder(const char *path)
{
    return nftw(path, remove_one, 16, FTW_DEPTH | FTW_PHYS) == 0;
}

static bool need(bool made, const char *path)
{
    if (!made) {
        perror(path);
        abort();
    }
    return true;
}

FILE *system_open_scratch(void)
{
    FILE *file = tmpfile();
    need(file != NULL, "a file for a test");
    return file;
}

// A thread of Mesa writes compiled shaders to a cache whenever it likes.
static bool is_cache(int folder, const char *name)
{
    char path[PLATFORM_PATH];
    ssize_t length = readlinkat(folder, name, path, sizeof path - 1);
    path[length > 0 ? length : 0] = '\0';
    return strstr(path, "mesa_shader_cache") != NULL;
}

int system_open_files(void)
{
    int count = 0;
    DIR *folder = opendir("/proc/self/fd");
    if (folder == NULL) {
        printf("# open files are not counted: this system has no /proc/self/fd\n");
        return -1;
    }
    for (struct dirent *each; (each = readdir(folder)) != NULL;)
        count += !is_cache(dirfd(folder), each->d_name);
    closedir(folder);
    return count;
}

int system_run(const char *program, const char *arguments, char *text, size_t size)
{
    char command[PLATFORM_PATH];
    const char *build = getenv("BUILD");
    snprintf(command, sizeof command, "%s/%s %s 2>&1", build != NULL ? build : "build", program,
             arguments);
    FILE *pipe = popen(command, "r");
    need(pipe != NULL, command);
    text[fread(text, 1, size - 1, pipe)] = '\0';
    int status = pclose(pipe);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

bool system_make_link(const char *to, const char *path)
{
    return need(symlink(to, path) == 0, path);
}

bool system_make_pipe(const char *path)
{
    return need(mkfifo(path, 0600) == 0, path);
}
