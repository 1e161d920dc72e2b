#include "picture/image.h"

#include <errno.h>
#include <fcntl.h>
#include <libgen.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <png.h>

#include "report.h"

enum { CHANNELS = 3, LINK_LIMIT = 40 };

bool image_create(struct image *image, int width, int height)
{
    *image = (struct image){0};
    if (width < 1 || width > IMAGE_SIDE_LIMIT || height < 1 || height > IMAGE_SIDE_LIMIT)
        return report("picture %dx%d: each side must be 1 to %d pixels", width, height,
                      IMAGE_SIDE_LIMIT);
    unsigned char *pixel = calloc((size_t)width * (size_t)height, CHANNELS);
    if (pixel == NULL)
        return report("picture %dx%d: not enough memory: choose a smaller one", width, height);
    *image = (struct image){.width = width, .height = height, .pixel = pixel};
    return true;
}

void image_free(struct image *image)
{
    free(image->pixel);
    *image = (struct image){0};
}

// A NaN becomes 0: the comparison is false for it.
static unsigned char byte_of(float value)
{
    float positive = value > 0.0f ? value : 0.0f;
    return (unsigned char)((positive < 1.0f ? positive : 1.0f) * 255.0f + 0.5f);
}

void image_store(struct image *image, const float *values, int bottom, int rows)
{
    for (int row = 0; row < rows; row++) {
        size_t y = (size_t)(image->height - 1 - (bottom + row));
        unsigned char *pixel = image->pixel + CHANNELS * (size_t)image->width * y;
        const float *value = values + 4 * (size_t)image->width * (size_t)row;
        for (int x = 0; x < image->width; x++)
            for (int channel = 0; channel < CHANNELS; channel++)
                pixel[CHANNELS * x + channel] = byte_of(value[4 * x + channel]);
    }
}

// ---- Where a picture is written ----

// Put what a path's last name links to in its place, also where that is missing: a rename would
// replace the link. Returns 0 or an errno.
static int follow_links(const char *path, char target[PATH_MAX])
{
    char text[PATH_MAX], joined[PATH_MAX];
    ssize_t length;
    if (snprintf(target, PATH_MAX, "%s", path) >= PATH_MAX)
        return ENAMETOOLONG;
    for (int i = 0; (length = readlink(target, text, sizeof text - 1)) >= 0; i++) {
        text[length] = '\0';
        const char *slash = strrchr(target, '/');
        int folder = text[0] == '/' || slash == NULL ? 0 : (int)(slash - target) + 1;
        if (i == LINK_LIMIT)
            return ELOOP;
        if (snprintf(joined, sizeof joined, "%.*s%s", folder, target, text) >= PATH_MAX)
            return ENAMETOOLONG;
        strcpy(target, joined);
    }
    return errno == EINVAL || errno == ENOENT ? 0 : errno; // no link, or nothing at all
}

static const char *kind_of(mode_t mode)
{
    return S_ISDIR(mode)    ? "a folder"
           : S_ISCHR(mode)  ? "a character device"
           : S_ISBLK(mode)  ? "a block device"
           : S_ISFIFO(mode) ? "a pipe"
           : S_ISSOCK(mode) ? "a socket"
                            : "no regular file";
}

static bool refuse(const char *path, const char *why)
{
    return report("%s: cannot be written: %s", path, why);
}

// True when an existing file may be replaced. A rename asks the folder's permission alone, but who
// write-protects a file expects it to stay.
static bool may_replace(const char *path, mode_t mode)
{
    if (!S_ISREG(mode))
        return report("%s: cannot be written: it is %s: give the name of a file", path,
                      kind_of(mode));
    return access(path, W_OK) == 0 || refuse(path, strerror(errno));
}

static bool folder_writable(const char *path, const char *folder)
{
    char inside[PATH_MAX + 2];
    snprintf(inside, sizeof inside, "%s/.", folder);
    if (access(inside, W_OK | X_OK) == 0)
        return true;
    return report("%s: cannot be written: folder %s: %s: choose another", path, folder,
                  strerror(errno));
}

// The file that is meant by a path, and its folder. Returns false, reported, when a picture could
// not be written there.
static bool find_target(const char *path, char target[PATH_MAX], char folder[PATH_MAX])
{
    struct stat status;
    if (stat(path, &status) == 0) {
        if (!may_replace(path, status.st_mode))
            return false;
    } else if (errno != ENOENT || path[0] == '\0') {
        return refuse(path, strerror(errno));
    }
    int error = follow_links(path, target);
    if (error != 0)
        return refuse(path, strerror(error));
    if (target[strlen(target) - 1] == '/')
        return refuse(path, "a name that ends in / is a folder's: give the name of a file");
    char copy[PATH_MAX];
    snprintf(folder, PATH_MAX, "%s", dirname(strcpy(copy, target)));
    return folder_writable(path, folder);
}

bool image_check_target(const char *path)
{
    char target[PATH_MAX], folder[PATH_MAX];
    return find_target(path, target, folder);
}

// ---- Writing ----

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

// Create a file with a name that nothing has. mkstemp would give it to its owner alone, and the
// umask cannot be read without changing it.
static int create_beside(const char *folder, char name[PATH_MAX + 64])
{
    int file = -1;
    for (int i = 0; file < 0 && (i == 0 || (errno == EEXIST && i < 100)); i++) {
        snprintf(name, PATH_MAX + 64, "%s/.picture-%ld-%d.tmp", folder, (long)getpid(), i);
        file = open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    }
    return file;
}

// Write data beside the target and rename it over. Returns 0 or an errno; then nothing is left.
static int replace(const char *target, const char *folder, const char *data, size_t size)
{
    char name[PATH_MAX + 64];
    int file = create_beside(folder, name);
    if (file < 0)
        return errno;
    int error = write_and_close(file, data, size);
    if (error == 0 && rename(name, target) != 0)
        error = errno;
    if (error != 0)
        unlink(name);
    return error;
}

// As replace(), untouched by signals: one that ends the program waits until the file is whole, and
// the one of a file size limit, which would end it in the midst, becomes an error of write().
static int replace_undisturbed(const char *target, const char *folder, const char *data,
                               size_t size)
{
    struct sigaction ignore = {.sa_handler = SIG_IGN}, before;
    sigset_t ending, mask;
    sigemptyset(&ending);
    sigaddset(&ending, SIGINT);
    sigaddset(&ending, SIGTERM);
    sigaddset(&ending, SIGHUP);
    sigprocmask(SIG_BLOCK, &ending, &mask);
    sigaction(SIGXFSZ, &ignore, &before);
    int error = replace(target, folder, data, size);
    sigaction(SIGXFSZ, &before, NULL);
    sigprocmask(SIG_SETMASK, &mask, NULL);
    return error;
}

bool image_write_png(const struct image *image, const char *path)
{
    char target[PATH_MAX], folder[PATH_MAX];
    if (!find_target(path, target, folder))
        return false;
    // The fast one: a fifth of the time for a file that is a third larger.
    png_image png = {.version = PNG_IMAGE_VERSION,
                     .width = (png_uint_32)image->width,
                     .height = (png_uint_32)image->height,
                     .format = PNG_FORMAT_RGB,
                     .flags = PNG_IMAGE_FLAG_FAST,
                     .message = "not enough memory"};
    char *data = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&data, &size);
    bool encoded =
        stream != NULL && png_image_write_to_stdio(&png, stream, 0, image->pixel, 0, NULL) != 0;
    if (stream != NULL && fclose(stream) != 0)
        encoded = false;
    int error = encoded ? replace_undisturbed(target, folder, data, size) : 0;
    free(data);
    return (encoded && error == 0) || refuse(path, encoded ? strerror(error) : png.message);
}
