// compare [--words | --part WxH+X+Y] A.png B.png [DIFFERENCE.png] - compares two pictures. With
// --part, compares only that part of both pictures, whose top left corner is X pixels from the left
// and Y from the top. compare --pack A.png B.png - stores A as B, compressed as far as is worth it.
// If B already has these pixels, the file is left as it is. compare --subtract A.png B.png C.png -
// stores A - B as C in the same way. compare --add B.png C.png A.png - writes B + C.
//
// Prints the two numbers that decide, F2 and B8 (lib/compare.h), the largest difference, the number
// of pixels that differ at all, and the position in the compared part that differs most, in pixels
// as --probe counts them. With --words, prints a sentence for a student instead. DIFFERENCE
// receives a picture of the differences. Exit status: 0 if the pictures are the same
// within the tolerance (--pack: A was stored), 1 if they are not (--pack: B was left as it is), 2
// if the pictures could not be compared or stored.
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <png.h>

#include "platform.h"
#include "report.h"
#include "lib/compare.h"

enum { SAME = 0, DIFFERENT = 1, NOT_COMPARED = 2 };

// Crop a picture to the requested part, if there is one. Returns false after reporting the error.
static bool cut(struct image *image, const char *text)
{
    int width, height, left, top;
    struct image part = {0};
    if (text == NULL)
        return true;
    if (sscanf(text, "%dx%d+%d+%d", &width, &height, &left, &top) != 4 || width < 1 || height < 1 ||
        left < 0 || top < 0 || width > image->width - left || height > image->height - top)
        return report("--part %s: not WxH+X+Y within a picture of %dx%d", text, image->width,
                      image->height);
    if (!image_create(&part, width, height))
        return false;
    for (int y = 0; y < height; y++)
        memcpy(part.pixel + 3 * (size_t)y * (size_t)width,
               image->pixel + 3 * ((size_t)(top + y) * (size_t)image->width + (size_t)left),
               3 * (size_t)width);
    image_free(image);
    *image = part;
    return true;
}

static int compare(const struct image *a, const struct image *b, bool words, const char *picture)
{
    struct image_difference difference;
    if (!image_compare(a, b, &difference))
        return NOT_COMPARED;
    char sentence[256];
    if (words)
        puts(image_difference_words(&difference, sentence));
    else
        image_print_difference(&difference);
    if (picture != NULL) {
        struct image shown = {0};
        bool written = image_difference_picture(a, b, &shown) && image_write_png(&shown, picture);
        image_free(&shown);
        if (!written)
            return NOT_COMPARED;
    }
    return image_same(&difference) ? SAME : DIFFERENT;
}

// Write a picture with almost the highest compression, and let libpng select the filter of each
// row. The file has 25 % fewer bytes than one from image_write_png, but takes many times as long.
// Level 9 would take twice as long again, for 1 % fewer bytes.
static bool encode(const struct image *image, FILE *stream)
{
    png_struct *png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_info *info = png != NULL ? png_create_info_struct(png) : NULL;
    if (info == NULL || setjmp(png_jmpbuf(png))) {
        png_destroy_write_struct(&png, &info);
        return false;
    }
    png_init_io(png, stream);
    png_set_compression_level(png, 8);
    png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_ALL_FILTERS);
    png_set_IHDR(png, info, (png_uint_32)image->width, (png_uint_32)image->height, 8,
                 PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, info);
    for (int y = 0; y < image->height; y++)
        png_write_row(png, image->pixel + 3 * (size_t)y * (size_t)image->width);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return true;
}

static bool has_pixels(const char *path, const struct image *image)
{
    struct image_bytes stored;
    char why[IMAGE_WHY];
    size_t pixels = (size_t)image->width * (size_t)image->height;
    if (!image_read_bytes(&stored, path, 3, pixels, why))
        return false;
    bool same = stored.width == image->width && stored.height == image->height &&
                memcmp(stored.value, image->pixel, 3 * pixels) == 0;
    free(stored.value);
    return same;
}

static int pack(const struct image *image, const char *to)
{
    char target[PLATFORM_PATH], why[PLATFORM_WHY], *data = NULL;
    size_t size = 0;
    bool same = has_pixels(to, image), stored = false;
    if (!same && !platform_target(to, target, why)) {
        report("%s: cannot be written: %s", to, why);
    } else if (!same) {
        FILE *stream = platform_open_text(&data, &size);
        bool encoded = stream != NULL && encode(image, stream);
        if (stream != NULL && !platform_close_text(stream))
            encoded = false;
        int error = encoded ? platform_replace(target, data, size) : 0;
        stored = encoded && error == 0;
        if (!stored)
            report("%s: cannot be written: %s", to,
                   encoded ? platform_why(error) : "not enough memory");
    }
    free(data);
    return same ? DIFFERENT : stored ? SAME : NOT_COMPARED;
}

// Make what a picture has more than another of the same size, and below it what it has less. Their
// sum with the other picture stays within a byte even if another driver draws that one slightly
// differently, while a difference modulo 256 could turn white into black.
static bool subtract(const struct image *a, const struct image *b, struct image *added)
{
    size_t bytes = 3 * (size_t)a->width * (size_t)a->height;
    if (a->width != b->width || a->height != b->height) {
        report("a picture of %dx%d and one of %dx%d cannot be subtracted", a->width, a->height,
               b->width, b->height);
        return false;
    }
    if (!image_create(added, a->width, 2 * a->height))
        return false;
    for (size_t i = 0; i < bytes; i++) {
        int more = a->pixel[i] - b->pixel[i];
        added->pixel[i + (more < 0 ? bytes : 0)] = (unsigned char)abs(more);
    }
    return true;
}

// Add the result of subtract to a picture.
static bool add(struct image *picture, const struct image *added)
{
    size_t bytes = 3 * (size_t)picture->width * (size_t)picture->height;
    if (added->width != picture->width || added->height != 2 * picture->height)
        return report("a picture of %dx%d and one of %dx%d cannot be added", picture->width,
                      picture->height, added->width, added->height);
    for (size_t i = 0; i < bytes; i++) {
        int sum = picture->pixel[i] + added->pixel[i] - added->pixel[i + bytes];
        picture->pixel[i] = (unsigned char)(sum < 0 ? 0 : sum > 255 ? 255 : sum);
    }
    return true;
}

// Carry out --pack, --subtract or --add.
static int store(int argc, char **argv)
{
    struct image a = {0}, b = {0}, added = {0};
    int status = NOT_COMPARED;
    if (image_read_png(&a, argv[2]) && (argc == 4 || image_read_png(&b, argv[3]))) {
        if (strcmp(argv[1], "--pack") == 0)
            status = pack(&a, argv[3]);
        else if (strcmp(argv[1], "--subtract") == 0 && subtract(&a, &b, &added))
            status = pack(&added, argv[4]);
        else if (strcmp(argv[1], "--add") == 0 && add(&a, &b) && image_write_png(&a, argv[4]))
            status = SAME;
    }
    image_free(&a);
    image_free(&b);
    image_free(&added);
    return status;
}

int main(int argc, char **argv)
{
    if ((argc == 4 && strcmp(argv[1], "--pack") == 0) ||
        (argc == 5 && (strcmp(argv[1], "--subtract") == 0 || strcmp(argv[1], "--add") == 0)))
        return store(argc, argv);
    bool words = argc > 1 && strcmp(argv[1], "--words") == 0;
    argv += words;
    argc -= words;
    const char *part = argc > 2 && strcmp(argv[1], "--part") == 0 ? argv[2] : NULL;
    argv += part != NULL ? 2 : 0;
    argc -= part != NULL ? 2 : 0;
    if (argc != 3 && argc != 4) {
        fprintf(stderr, "usage: compare [--words | --part WxH+X+Y] A.png B.png [DIFFERENCE.png]\n"
                        "       compare --pack A.png B.png\n"
                        "       compare --subtract A.png B.png C.png\n"
                        "       compare --add B.png C.png A.png\n");
        return NOT_COMPARED;
    }
    struct image a = {0}, b = {0};
    int status = NOT_COMPARED;
    if (image_read_png(&a, argv[1]) && image_read_png(&b, argv[2]) && cut(&a, part) &&
        cut(&b, part))
        status = compare(&a, &b, words, argc == 4 ? argv[3] : NULL);
    image_free(&a);
    image_free(&b);
    return status;
}
