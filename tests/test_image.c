// Unit tests of common/image.c: pictures written, refused, read and compared.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <dirent.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <png.h>

#include "../common/image.h"

enum { NOBODY = 65534 };

static struct {
    char folder[64];  // of this test alone
    char target[128]; // a file in it that is not there yet
    char link[128], other[128];
    int standard_error; // kept while listening
    char heard[8192];   // what was reported
    uint32_t random;
} test;

// ---- Helpers
// -------------------------------------------------------------------------------------

static int make_folder(void **state)
{
    (void)state;
    strcpy(test.folder, "/tmp/test_image.XXXXXX");
    if (mkdtemp(test.folder) == NULL)
        return -1;
    snprintf(test.target, sizeof test.target, "%s/picture.png", test.folder);
    snprintf(test.link, sizeof test.link, "%s/link.png", test.folder);
    snprintf(test.other, sizeof test.other, "%s/other.png", test.folder);
    test.random = 12345;
    return 0;
}

// Count what lies in the folder, or remove it as well.
static int count_files(bool clear)
{
    int count = 0;
    DIR *directory = opendir(test.folder);
    for (struct dirent *entry; directory != NULL && (entry = readdir(directory)) != NULL;) {
        char path[PATH_MAX];
        if (strcmp(entry->d_name, ".") == 0 || strcmp(entry->d_name, "..") == 0)
            continue;
        count++;
        snprintf(path, sizeof path, "%s/%s", test.folder, entry->d_name);
        if (clear)
            remove(path);
    }
    if (directory != NULL)
        closedir(directory);
    return count;
}

static int remove_folder(void **state)
{
    (void)state;
    count_files(true);
    return rmdir(test.folder);
}

// Keep standard error for a while, to look at what is reported.
static void listen_to_reports(void)
{
    char path[] = "/tmp/test_image_heard.XXXXXX";
    int file = mkstemp(path);
    unlink(path);
    test.standard_error = dup(STDERR_FILENO);
    dup2(file, STDERR_FILENO);
    close(file);
}

static void stop_listening(void)
{
    lseek(STDERR_FILENO, 0, SEEK_SET);
    ssize_t length = read(STDERR_FILENO, test.heard, sizeof test.heard - 1);
    test.heard[length > 0 ? length : 0] = '\0';
    dup2(test.standard_error, STDERR_FILENO);
    close(test.standard_error);
}

static void assert_near(double value, double expected, double tolerance)
{
    if (fabs(value - expected) > tolerance)
        fail_msg("%.17g is not %.17g", value, expected);
}

// The call after listen_to_reports() must have failed with one line that holds a text.
static bool refused(bool done, const char *text)
{
    stop_listening();
    const char *end = strchr(test.heard, '\n');
    bool good = !done && end != NULL && end[1] == '\0' && strstr(test.heard, text) != NULL;
    if (!good)
        print_message("# expected '%s', heard '%s'\n", text, test.heard);
    return good;
}

static unsigned char random_byte(void)
{
    test.random = test.random * 1664525u + 1013904223u;
    return (unsigned char)(test.random >> 24);
}

static struct image random_image(int width, int height)
{
    struct image image;
    assert_true(image_create(&image, width, height));
    for (size_t i = 0; i < 3 * (size_t)width * (size_t)height; i++)
        image.pixel[i] = random_byte();
    return image;
}

// Differs from its neighbours by a little, as pictures do.
static struct image smooth_image(int width, int height)
{
    struct image image;
    assert_true(image_create(&image, width, height));
    for (int i = 0; i < width * height; i++)
        for (int c = 0; c < 3; c++)
            image.pixel[3 * i + c] = (unsigned char)(120.0 + 60.0 * sin(0.11 * (i % width) + c) +
                                                     50.0 * cos(0.07 * (i / width)));
    return image;
}

static struct image copy_of(const struct image *image)
{
    struct image copy;
    assert_true(image_create(&copy, image->width, image->height));
    memcpy(copy.pixel, image->pixel, 3 * (size_t)image->width * (size_t)image->height);
    return copy;
}

static void assert_file_holds(const char *path, const struct image *expected)
{
    struct image image;
    assert_true(image_read_png(&image, path));
    assert_int_equal(image.width, expected->width);
    assert_int_equal(image.height, expected->height);
    assert_memory_equal(image.pixel, expected->pixel,
                        3 * (size_t)image.width * (size_t)image.height);
    image_free(&image);
}

static size_t read_bytes(const char *path, unsigned char *bytes, size_t size)
{
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    size_t length = fread(bytes, 1, size, file);
    fclose(file);
    return length;
}

static void write_bytes(const char *path, const unsigned char *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, size, file), size);
    fclose(file);
}

static void assert_not_written(const char *path, const char *text)
{
    struct image image = random_image(4, 4);
    int files = count_files(false);
    listen_to_reports();
    assert_true(refused(image_check_target(path), text));
    listen_to_reports();
    assert_true(refused(image_write_png(&image, path), text));
    assert_int_equal(count_files(false), files);
    image_free(&image);
}

// ---- Creating
// ------------------------------------------------------------------------------------

static void a_new_picture_is_black(void **state)
{
    (void)state;
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

static void sizes_out_of_range_are_refused(void **state)
{
    (void)state;
    static const int sizes[][2] = {{0, 1}, {1, 0}, {-5, 5}, {16385, 1}, {1, 16385}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct image image;
        listen_to_reports();
        assert_true(refused(image_create(&image, sizes[i][0], sizes[i][1]), "1 to 16384"));
        assert_null(image.pixel);
    }
    struct image widest;
    assert_true(image_create(&widest, 16384, 1));
    image_free(&widest);
}

// ---- Writing
// -------------------------------------------------------------------------------------

static void random_pixels_come_back(void **state)
{
    (void)state;
    static const int sizes[][2] = {{1, 1}, {1, 7}, {64, 1}, {37, 23}, {16384, 2}, {640, 360}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct image image = random_image(sizes[i][0], sizes[i][1]);
        assert_true(image_check_target(test.target));
        assert_int_equal(count_files(false), i == 0 ? 0 : 1);
        assert_true(image_write_png(&image, test.target));
        assert_file_holds(test.target, &image);
        assert_int_equal(count_files(false), 1);
        image_free(&image);
    }
}

static void the_file_is_an_srgb_png_for_everybody(void **state)
{
    (void)state;
    struct image image = random_image(5, 5);
    unsigned char bytes[1024];
    struct stat status;
    mode_t mask = umask(027);
    assert_true(image_write_png(&image, test.target));
    umask(mask);
    assert_int_equal(stat(test.target, &status), 0);
    assert_int_equal(status.st_mode & 0777, 0640);
    read_bytes(test.target, bytes, sizeof bytes);
    assert_memory_equal(bytes + 37, "sRGB", 4); // after the signature (8) and IHDR (25 + 4)
    assert_int_equal(bytes[24], 8);             // bits
    assert_int_equal(bytes[25], 2);             // colours, no palette, no transparency
    image_free(&image);
}

static void a_name_without_folder_means_the_current_one(void **state)
{
    (void)state;
    char before[PATH_MAX];
    struct image image = random_image(4, 4);
    assert_non_null(getcwd(before, sizeof before));
    assert_int_equal(chdir(test.folder), 0);
    bool done = image_check_target("here.png") && image_write_png(&image, "here.png");
    assert_int_equal(chdir(before), 0);
    assert_true(done);
    assert_int_equal(count_files(false), 1);
    image_free(&image);
}

static void folders_that_are_missing_are_refused(void **state)
{
    (void)state;
    char path[256], too_long[PATH_MAX + 16];
    snprintf(path, sizeof path, "%s/missing/picture.png", test.folder);
    assert_not_written(path, "missing: No such file or directory");
    struct image image = random_image(4, 4);
    assert_true(image_write_png(&image, test.target));
    snprintf(path, sizeof path, "%s/below.png", test.target);
    assert_not_written(path, "Not a directory");
    assert_file_holds(test.target, &image);
    memset(too_long, 'a', sizeof too_long - 1);
    too_long[sizeof too_long - 1] = '\0';
    assert_not_written(too_long, "File name too long");
    image_free(&image);
}

static void targets_that_are_no_files_are_refused(void **state)
{
    (void)state;
    struct stat before, after;
    char path[256];
    assert_int_equal(stat("/dev/null", &before), 0);
    assert_not_written("/dev/null", "it is a character device");
    assert_int_equal(symlink("/dev/null", test.link), 0);
    assert_not_written(test.link, "it is a character device");
    assert_int_equal(stat("/dev/null", &after), 0);
    assert_true(S_ISCHR(after.st_mode) && after.st_ino == before.st_ino);
    assert_int_equal(mkfifo(test.other, 0600), 0);
    assert_not_written(test.other, "it is a pipe");
    assert_not_written(test.folder, "it is a folder");
    snprintf(path, sizeof path, "%s/", test.folder);
    assert_not_written(path, "it is a folder");
    snprintf(path, sizeof path, "%s/new/", test.folder);
    assert_not_written(path, "a name that ends in /");
    assert_not_written("", "No such file");
}

static void links_are_followed(void **state)
{
    (void)state;
    struct image old = random_image(4, 4), new = random_image(6, 5);
    struct stat status;
    assert_true(image_write_png(&old, test.target));
    assert_int_equal(symlink("picture.png", test.link), 0);
    assert_int_equal(symlink(test.link, test.other), 0);
    assert_true(image_check_target(test.other));
    assert_true(image_write_png(&new, test.other));
    assert_file_holds(test.target, &new);
    assert_true(lstat(test.link, &status) == 0 && S_ISLNK(status.st_mode));
    assert_true(lstat(test.other, &status) == 0 && S_ISLNK(status.st_mode));
    assert_int_equal(count_files(false), 3);
    image_free(&old);
    image_free(&new);
}

static void dangling_links_get_their_target(void **state)
{
    (void)state;
    struct image image = random_image(4, 4);
    struct stat status;
    assert_int_equal(symlink("picture.png", test.link), 0);
    assert_true(image_check_target(test.link));
    assert_int_equal(count_files(false), 1);
    assert_true(image_write_png(&image, test.link));
    assert_true(lstat(test.link, &status) == 0 && S_ISLNK(status.st_mode));
    assert_true(lstat(test.target, &status) == 0 && S_ISREG(status.st_mode));
    image_free(&image);
    assert_int_equal(symlink("other.png", test.other), 0);
    assert_not_written(test.other, "symbolic links");
}

static void a_full_disk_leaves_the_old_file(void **state)
{
    (void)state;
    struct image old = random_image(8, 8), new = random_image(64, 64);
    struct rlimit limit, before;
    assert_true(image_write_png(&old, test.target));
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &before), 0);
    limit = before;
    limit.rlim_cur = 4096;
    listen_to_reports();
    setrlimit(RLIMIT_FSIZE, &limit);
    bool done = image_write_png(&new, test.target);
    setrlimit(RLIMIT_FSIZE, &before);
    assert_true(refused(done, "File too large"));
    assert_file_holds(test.target, &old);
    assert_int_equal(count_files(false), 1);
    image_free(&old);
    image_free(&new);
}

// In a child without root's rights, which no permission stops: the target must be refused.
static int refused_as_nobody(void)
{
    fflush(NULL);
    pid_t child = fork();
    if (child == 0) {
        if (geteuid() == 0 && (setgid(NOBODY) != 0 || setuid(NOBODY) != 0))
            _exit(2);
        struct image image;
        listen_to_reports();
        bool done = image_check_target(test.target);
        bool checked = refused(done, "Permission denied");
        listen_to_reports();
        done = image_create(&image, 2, 2) && image_write_png(&image, test.target);
        _exit(refused(done, "Permission denied") && checked ? 0 : 1);
    }
    int status = -1;
    waitpid(child, &status, 0);
    return status;
}

static void what_is_protected_stays(void **state)
{
    (void)state;
    struct image image = random_image(4, 4);
    assert_int_equal(chmod(test.folder, 0555), 0);
    assert_int_equal(refused_as_nobody(), 0);
    assert_int_equal(chmod(test.folder, 0777), 0);
    assert_true(image_write_png(&image, test.target));
    assert_int_equal(chmod(test.target, 0444), 0);
    assert_int_equal(refused_as_nobody(), 0);
    assert_file_holds(test.target, &image);
    assert_int_equal(count_files(false), 1);
    image_free(&image);
}

// ---- Reading
// -------------------------------------------------------------------------------------

static void what_is_no_png_is_refused(void **state)
{
    (void)state;
    struct image image;
    listen_to_reports();
    assert_true(refused(image_read_png(&image, test.target), "No such file"));
    write_bytes(test.target, (const unsigned char *)"", 0);
    listen_to_reports();
    assert_true(refused(image_read_png(&image, test.target), "cannot be read"));
    write_bytes(test.target, (const unsigned char *)"P6 1 1 255 and more text", 24);
    listen_to_reports();
    assert_true(refused(image_read_png(&image, test.target), "Not a PNG file"));
    listen_to_reports();
    assert_true(refused(image_read_png(&image, test.folder), "Is a directory"));
    assert_null(image.pixel);
}

static void every_truncated_file_is_refused(void **state)
{
    (void)state;
    unsigned char bytes[2048];
    struct image image = random_image(9, 9), read;
    assert_true(image_write_png(&image, test.target));
    size_t size = read_bytes(test.target, bytes, sizeof bytes);
    assert_true(size > 200 && size < sizeof bytes);
    for (size_t i = 0; i < size; i++) {
        write_bytes(test.target, bytes, i);
        listen_to_reports();
        assert_true(refused(image_read_png(&read, test.target), "cannot be read"));
        assert_null(read.pixel);
    }
    image_free(&image);
}

// A changed byte may escape (in a name of a chunk that is skipped, say), but the picture may not
// change.
static void every_changed_byte_is_harmless(void **state)
{
    (void)state;
    unsigned char bytes[2048];
    struct image image = random_image(9, 9), read;
    assert_true(image_write_png(&image, test.target));
    size_t size = read_bytes(test.target, bytes, sizeof bytes), caught = 0;
    for (size_t i = 0; i < size; i++) {
        bytes[i] ^= 0x55;
        write_bytes(test.target, bytes, size);
        bytes[i] ^= 0x55;
        listen_to_reports();
        bool done = image_read_png(&read, test.target);
        stop_listening();
        caught += !done;
        if (done)
            assert_memory_equal(read.pixel, image.pixel, 3 * 9 * 9);
        image_free(&read);
    }
    assert_true(caught > size * 9 / 10);
    image_free(&image);
}

static void write_kind(png_uint_32 format, int width, int height, const void *pixels,
                       const void *colours, png_uint_32 colour_count)
{
    png_image kind = {.version = PNG_IMAGE_VERSION,
                      .width = (png_uint_32)width,
                      .height = (png_uint_32)height,
                      .format = format,
                      .colormap_entries = colour_count};
    assert_true(png_image_write_to_file(&kind, test.target, 0, pixels, 0, colours));
}

static void every_kind_of_png_becomes_rgb(void **state)
{
    (void)state;
    static const unsigned char with_alpha[] = {1, 2, 3, 128, 200, 100, 50, 0};
    static const unsigned char grey[] = {7, 250}, numbers[] = {1, 0};
    static const unsigned char colours[] = {9, 8, 7, 60, 50, 40};
    static const uint16_t deep[] = {0, 65535, 0, 65535, 0, 65535};
    static const unsigned char expected[][6] = {{1, 2, 3, 200, 100, 50},
                                                {7, 7, 7, 250, 250, 250},
                                                {60, 50, 40, 9, 8, 7},
                                                {0, 255, 0, 255, 0, 255}};
    for (int i = 0; i < 4; i++) {
        struct image image;
        if (i == 0)
            write_kind(PNG_FORMAT_RGBA, 2, 1, with_alpha, NULL, 0);
        else if (i == 1)
            write_kind(PNG_FORMAT_GRAY, 2, 1, grey, NULL, 0);
        else if (i == 2)
            write_kind(PNG_FORMAT_RGB_COLORMAP, 2, 1, numbers, colours, 2);
        else
            write_kind(PNG_FORMAT_FLAG_LINEAR | PNG_FORMAT_FLAG_COLOR, 2, 1, deep, NULL, 0);
        assert_true(image_read_png(&image, test.target));
        assert_memory_equal(image.pixel, expected[i], 6);
        image_free(&image);
    }
}

static void pictures_too_large_are_refused(void **state)
{
    (void)state;
    struct image image;
    unsigned char *row = calloc(16385, 1);
    assert_non_null(row);
    write_kind(PNG_FORMAT_GRAY, 16385, 1, row, NULL, 0);
    free(row);
    listen_to_reports();
    assert_true(refused(image_read_png(&image, test.target), "longer than 16384"));
    assert_null(image.pixel);
}

// ---- Comparing
// -----------------------------------------------------------------------------------

static void identical_pictures_do_not_differ(void **state)
{
    (void)state;
    struct image a = smooth_image(203, 101), b = copy_of(&a);
    struct image_difference difference;
    assert_true(image_compare(&a, &b, &difference));
    assert_true(difference.f2 == 0.0 && difference.b8 == 0.0);
    assert_int_equal(difference.largest, 0);
    assert_int_equal(difference.differs, 0);
    assert_true(image_same(&difference));
    image_free(&a);
    image_free(&b);
}

// The numbers of one pixel that is off by 64 in green, in a full block and in the corner block,
// which is 3x5 pixels where the size is 203x101 = (25 * 8 + 3) x (12 * 8 + 5).
static void one_pixel_counts_as_defined(void **state)
{
    (void)state;
    const double blocks = 26.0 * 13.0;
    struct image a = smooth_image(203, 101), b = copy_of(&a);
    struct image_difference difference;
    unsigned char *first = &b.pixel[1], *last = &b.pixel[3 * (203 * 101 - 1) + 1];
    *first = (unsigned char)(*first ^ 64);
    assert_true(image_compare(&a, &b, &difference));
    assert_near(difference.f2, 1.0 / (203.0 * 101.0), 1e-15);
    assert_near(difference.b8, 64.0 / 64.0 / sqrt(blocks), 1e-12);
    assert_int_equal(difference.largest, 64);
    assert_int_equal(difference.differs, 1);
    assert_true(image_same(&difference));
    *first = (unsigned char)(*first ^ 64);
    *last = (unsigned char)(*last ^ 64);
    assert_true(image_compare(&a, &b, &difference));
    assert_near(difference.b8, 64.0 / 15.0 / sqrt(blocks), 1e-12);
    image_free(&a);
    image_free(&b);
}

static void two_is_tolerated_and_three_is_not(void **state)
{
    (void)state;
    struct image a = smooth_image(64, 64), b = copy_of(&a);
    struct image_difference difference;
    b.pixel[300] = (unsigned char)(a.pixel[300] + 2);
    assert_true(image_compare(&a, &b, &difference));
    assert_true(difference.f2 == 0.0 && difference.differs == 1);
    b.pixel[300] = (unsigned char)(a.pixel[300] - 3);
    assert_true(image_compare(&a, &b, &difference));
    assert_near(difference.f2, 1.0 / 4096.0, 1e-15);
    image_free(&a);
    image_free(&b);
}

static void a_shift_by_one_pixel_is_caught(void **state)
{
    (void)state;
    struct image a = smooth_image(640, 360), b = copy_of(&a);
    struct image_difference difference;
    memmove(b.pixel + 3, a.pixel, 3 * (640 * 360 - 1));
    assert_true(image_compare(&a, &b, &difference));
    assert_true(difference.f2 > 0.1);
    assert_false(image_same(&difference));
    image_free(&a);
    image_free(&b);
}

static void a_little_more_everywhere_is_caught(void **state)
{
    (void)state;
    struct image a = smooth_image(203, 101), b = copy_of(&a);
    struct image_difference difference;
    for (int i = 2; i < 3 * 203 * 101; i += 3)
        b.pixel[i] = (unsigned char)(b.pixel[i] + 1);
    assert_true(image_compare(&a, &b, &difference));
    assert_true(difference.f2 == 0.0);
    assert_near(difference.b8, 1.0, 1e-12);
    assert_false(image_same(&difference));
    image_free(&a);
    image_free(&b);
}

static void both_numbers_decide(void **state)
{
    (void)state;
    struct image_difference difference = {.f2 = 0.0005, .b8 = 0.15};
    assert_true(image_same(&difference));
    difference.f2 = 0.00051;
    assert_false(image_same(&difference));
    difference = (struct image_difference){.b8 = 0.151};
    assert_false(image_same(&difference));
}

static void different_sizes_are_not_compared(void **state)
{
    (void)state;
    struct image a = smooth_image(8, 6), b = smooth_image(6, 8), picture = {0};
    struct image_difference difference;
    listen_to_reports();
    assert_true(refused(image_compare(&a, &b, &difference), "8x6 and 6x8"));
    listen_to_reports();
    assert_true(refused(image_difference_picture(&a, &b, &picture), "8x6 and 6x8"));
    image_free(&a);
    image_free(&b);
}

static void the_difference_can_be_seen(void **state)
{
    (void)state;
    static const unsigned char before[] = {10, 20, 255, 0, 100, 100};
    static const unsigned char after[] = {10, 21, 0, 255, 90, 131};
    static const unsigned char expected[] = {128, 132, 0, 255, 88, 252};
    struct image a, b, picture;
    assert_true(image_create(&a, 2, 1) && image_create(&b, 2, 1));
    memcpy(a.pixel, before, sizeof before);
    memcpy(b.pixel, after, sizeof after);
    assert_true(image_difference_picture(&a, &b, &picture));
    assert_memory_equal(picture.pixel, expected, sizeof expected);
    image_free(&a);
    image_free(&b);
    image_free(&picture);
}

#define IN_FOLDER(name) cmocka_unit_test_setup_teardown(name, make_folder, remove_folder)

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_new_picture_is_black),
        cmocka_unit_test(sizes_out_of_range_are_refused),
        IN_FOLDER(random_pixels_come_back),
        IN_FOLDER(the_file_is_an_srgb_png_for_everybody),
        IN_FOLDER(a_name_without_folder_means_the_current_one),
        IN_FOLDER(folders_that_are_missing_are_refused),
        IN_FOLDER(targets_that_are_no_files_are_refused),
        IN_FOLDER(links_are_followed),
        IN_FOLDER(dangling_links_get_their_target),
        IN_FOLDER(a_full_disk_leaves_the_old_file),
        IN_FOLDER(what_is_protected_stays),
        IN_FOLDER(what_is_no_png_is_refused),
        IN_FOLDER(every_truncated_file_is_refused),
        IN_FOLDER(every_changed_byte_is_harmless),
        IN_FOLDER(every_kind_of_png_becomes_rgb),
        IN_FOLDER(pictures_too_large_are_refused),
        cmocka_unit_test(identical_pictures_do_not_differ),
        cmocka_unit_test(one_pixel_counts_as_defined),
        cmocka_unit_test(two_is_tolerated_and_three_is_not),
        cmocka_unit_test(a_shift_by_one_pixel_is_caught),
        cmocka_unit_test(a_little_more_everywhere_is_caught),
        cmocka_unit_test(both_numbers_decide),
        cmocka_unit_test(different_sizes_are_not_compared),
        cmocka_unit_test(the_difference_can_be_seen),
    };
    return cmocka_run_group_tests_name("image", tests, NULL, NULL);
}
