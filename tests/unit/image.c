// image.c - tests image.c and image_write.c of common/picture: pictures are created and written,
// and files that cannot be written are refused. image_read.c tests reading, and image_compare.c
// tests comparing.
#include "lib/test.h"

#include <limits.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <sys/wait.h>
#include <unistd.h>

#include "picture/image.h"
#include "platform.h"
#include "lib/image.h"
#include "lib/scratch.h"
#include "lib/system.h"

enum { NOBODY = 65534, OPENS = 50 };

// Replaces the system's write with a function that writes at most write_most bytes per call. The
// parameters are named as in Debian's header, because clang-tidy objects to other names.
static size_t write_most = SIZE_MAX;

ssize_t write(int __fd, const void *__buf, size_t __n)
{
    struct iovec part = {.iov_base = (void *)(uintptr_t)__buf,
                         .iov_len = __n < write_most ? __n : write_most};
    return writev(__fd, &part, 1);
}

static void assert_not_written(const struct picture_folder *in, const char *path, const char *text)
{
    struct image image = picture_random(4, 4);
    int files = picture_folder_count(in);
    capture_begin();
    assert_true(picture_refused(image_check_target(path), text));
    capture_begin();
    assert_true(picture_refused(image_write_png(&image, path), text));
    assert_int_equal(picture_folder_count(in), files);
    image_free(&image);
}

TEST(a_new_picture_is_black)
{
    struct image image;
    assert_true(image_create(&image, 3, 2));
    assert_int_equal(image.width, 3);
    assert_int_equal(image.height, 2);
    for (int i = 0; i < 18; i++)
        assert_int_equal(image.pixel[i], 0);
    image_free(&image);
    assert_null(image.pixel);
    image_free(&image);
}

TEST(sizes_out_of_range_are_refused)
{
    static const int sizes[][2] = {{0, 1}, {1, 0}, {-5, 5}, {16385, 1}, {1, 16385}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct image image;
        capture_begin();
        assert_true(picture_refused(image_create(&image, sizes[i][0], sizes[i][1]), "1 to 16384"));
        assert_null(image.pixel);
    }
    struct image widest;
    assert_true(image_create(&widest, 16384, 1));
    image_free(&widest);
}

#define IN_FOLDER(name) TEST_WITH(name, picture_folder_make, picture_folder_remove)

IN_FOLDER(random_pixels_come_back)
{
    const struct picture_folder *in = *state;
    static const int sizes[][2] = {{1, 1}, {1, 7}, {64, 1}, {37, 23}, {16384, 2}, {640, 360}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct image image = picture_random(sizes[i][0], sizes[i][1]);
        assert_true(image_check_target(in->target));
        assert_int_equal(picture_folder_count(in), i == 0 ? 0 : 1);
        assert_true(image_write_png(&image, in->target));
        picture_assert_stored(in->target, &image);
        assert_int_equal(picture_folder_count(in), 1);
        image_free(&image);
    }
}

IN_FOLDER(the_file_is_an_srgb_png_with_permissions_from_umask)
{
    const struct picture_folder *in = *state;
    struct image image = picture_random(5, 5);
    unsigned char bytes[1024];
    struct stat status;
    mode_t mask = umask(027);
    assert_true(image_write_png(&image, in->target));
    umask(mask);
    assert_int_equal(stat(in->target, &status), 0);
    assert_int_equal(status.st_mode & 0777, 0640);
    picture_bytes(in->target, bytes, sizeof bytes);
    assert_memory_equal(bytes + 37, "sRGB", 4); // after signature (8), IHDR (25) and length (4)
    assert_int_equal(bytes[24], 8);             // bits per channel
    assert_int_equal(bytes[25], 2);             // RGB without a palette or an alpha channel
    image_free(&image);
}

IN_FOLDER(a_name_without_folder_means_the_current_one)
{
    const struct picture_folder *in = *state;
    char before[PATH_MAX];
    struct image image = picture_random(4, 4);
    assert_non_null(getcwd(before, sizeof before));
    assert_int_equal(chdir(in->folder), 0);
    bool done = image_check_target("here.png") && image_write_png(&image, "here.png");
    assert_int_equal(chdir(before), 0);
    assert_true(done);
    assert_int_equal(picture_folder_count(in), 1);
    image_free(&image);
}

IN_FOLDER(folders_that_are_missing_are_refused)
{
    const struct picture_folder *in = *state;
    char too_long[PATH_MAX + 16];
    assert_not_written(in, scratch_path("missing/picture.png"),
                       "missing: No such file or directory");
    struct image image = picture_random(4, 4);
    assert_true(image_write_png(&image, in->target));
    assert_not_written(in, scratch_path("picture.png/below.png"), "Not a directory");
    picture_assert_stored(in->target, &image);
    memset(too_long, 'a', sizeof too_long - 1);
    too_long[sizeof too_long - 1] = '\0';
    assert_not_written(in, too_long, "File name too long");
    image_free(&image);
}

IN_FOLDER(targets_that_are_not_regular_files_are_refused)
{
    const struct picture_folder *in = *state;
    struct stat before, after;
    assert_int_equal(stat("/dev/null", &before), 0);
    assert_not_written(in, "/dev/null", "it is a character device");
    assert_int_equal(symlink("/dev/null", in->link), 0);
    assert_not_written(in, in->link, "it is a character device");
    assert_int_equal(stat("/dev/null", &after), 0);
    assert_true(S_ISCHR(after.st_mode) && after.st_ino == before.st_ino);
    assert_int_equal(mkfifo(in->other, 0600), 0);
    assert_not_written(in, in->other, "it is a pipe");
    assert_not_written(in, in->folder, "it is a folder");
    assert_not_written(in, scratch_path(""), "it is a folder");
    assert_not_written(in, scratch_path("new/"), "a name that ends in /");
    assert_not_written(in, "", "No such file");
}

IN_FOLDER(links_are_followed)
{
    const struct picture_folder *in = *state;
    struct image old = picture_random(4, 4), new = picture_random(6, 5);
    struct stat status;
    assert_true(image_write_png(&old, in->target));
    assert_int_equal(symlink("picture.png", in->link), 0);
    assert_int_equal(symlink(in->link, in->other), 0);
    assert_true(image_check_target(in->other));
    assert_true(image_write_png(&new, in->other));
    picture_assert_stored(in->target, &new);
    assert_true(lstat(in->link, &status) == 0 && S_ISLNK(status.st_mode));
    assert_true(lstat(in->other, &status) == 0 && S_ISLNK(status.st_mode));
    assert_int_equal(picture_folder_count(in), 3);
    image_free(&old);
    image_free(&new);
}

IN_FOLDER(dangling_links_get_their_target)
{
    const struct picture_folder *in = *state;
    struct image image = picture_random(4, 4);
    struct stat status;
    assert_int_equal(symlink("picture.png", in->link), 0);
    assert_true(image_check_target(in->link));
    assert_int_equal(picture_folder_count(in), 1);
    assert_true(image_write_png(&image, in->link));
    assert_true(lstat(in->link, &status) == 0 && S_ISLNK(status.st_mode));
    assert_true(lstat(in->target, &status) == 0 && S_ISREG(status.st_mode));
    image_free(&image);
    assert_int_equal(symlink("other.png", in->other), 0);
    assert_not_written(in, in->other, "symbolic links");
}

IN_FOLDER(a_short_write_is_continued)
{
    const struct picture_folder *in = *state;
    struct image image = picture_random(37, 23);
    write_most = 1000; // the file has more than 2,500 bytes
    bool done = image_write_png(&image, in->target);
    write_most = SIZE_MAX;
    assert_true(done);
    unsigned char whole[8192], parts[8192];
    size_t size = picture_bytes(in->target, parts, sizeof parts);
    assert_true(image_write_png(&image, in->target));
    assert_int_equal(picture_bytes(in->target, whole, sizeof whole), size);
    assert_true(size > 2500 && size < sizeof whole);
    assert_memory_equal(parts, whole, size);
    image_free(&image);
}

IN_FOLDER(writing_leaves_no_file_open)
{
    const struct picture_folder *in = *state;
    struct image image = picture_random(8, 8);
    int before = system_open_files();
    for (int i = 0; i < OPENS; i++)
        assert_true(image_check_target(in->target) && image_write_png(&image, in->target));
    assert_int_equal(system_open_files(), before);
    // A write that fails because the file exceeds its size limit leaves no file open either.
    struct rlimit limit, unlimited;
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &unlimited), 0);
    limit = unlimited;
    limit.rlim_cur = 16;
    for (int i = 0; i < OPENS; i++) {
        setrlimit(RLIMIT_FSIZE, &limit);
        write_most = 16; // the first part is written, and the second exceeds the limit
        bool done = platform_replace(in->target, "more than 16 bytes", 18) == 0;
        write_most = SIZE_MAX;
        setrlimit(RLIMIT_FSIZE, &unlimited);
        assert_false(done);
    }
    assert_int_equal(system_open_files(), before);
    image_free(&image);
}

IN_FOLDER(a_full_disk_leaves_the_old_file)
{
    const struct picture_folder *in = *state;
    struct image old = picture_random(8, 8), new = picture_random(64, 64);
    struct rlimit limit, before;
    assert_true(image_write_png(&old, in->target));
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    limit = before;
    limit.rlim_cur = 4096;
    capture_begin();
    setrlimit(RLIMIT_FSIZE, &limit);
    bool done = image_write_png(&new, in->target);
    setrlimit(RLIMIT_FSIZE, &before);
    assert_true(picture_refused(done, "File too large"));
    picture_assert_stored(in->target, &old);
    assert_int_equal(picture_folder_count(in), 1);
    image_free(&old);
    image_free(&new);
}

// Check that the target is refused. The check is made in a child process without root's rights,
// because permissions do not restrict root. Returns the child's status, which is 0 if the target is
// refused.
static int refused_as_nobody(const struct picture_folder *in)
{
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        if (geteuid() == 0 && (setgid(NOBODY) != 0 || setuid(NOBODY) != 0))
            _exit(2);
        struct image image;
        capture_begin();
        bool done = image_check_target(in->target);
        bool checked = picture_refused(done, "Permission denied");
        capture_begin();
        done = image_create(&image, 2, 2) && image_write_png(&image, in->target);
        _exit(picture_refused(done, "Permission denied") && checked ? 0 : 1);
    }
    int status = -1;
    waitpid(child, &status, 0);
    return status;
}

IN_FOLDER(protected_files_stay)
{
    const struct picture_folder *in = *state;
    struct image image = picture_random(4, 4);
    assert_int_equal(chmod(in->folder, 0555), 0);
    assert_int_equal(refused_as_nobody(in), 0);
    assert_int_equal(chmod(in->folder, 0777), 0);
    assert_true(image_write_png(&image, in->target));
    assert_int_equal(chmod(in->target, 0444), 0);
    assert_int_equal(refused_as_nobody(in), 0);
    picture_assert_stored(in->target, &image);
    assert_int_equal(picture_folder_count(in), 1);
    image_free(&image);
}

TESTS(NULL, NULL)
