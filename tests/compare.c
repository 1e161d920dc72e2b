// compare [--words | --part WxH+X+Y] A.png B.png [DIFFERENCE.png] - are two pictures the same one?
// With
// --part that part of both, X and Y from the top left.
//
// Prints the two numbers that decide, the largest difference, how many pixels differ at all, and
// the place that differs most, in pixels as --probe counts them; with --words a sentence for a
// student. Exit status: 0 within tolerance, 1 outside, 2 when it could not compare.
#include <stdio.h>
#include <string.h>

#include "../common/report.h"
#include "support_compare.h"

enum { SAME = 0, DIFFERENT = 1, NOT_COMPARED = 2 };

// Cut a picture down to the part that is asked for, where any is. Returns false, reported.
static bool cut(struct image *image, const char *text)
{
    int width, height, left, top;
    struct image part = {0};
    if (text == NULL)
        return true;
    if (sscanf(text, "%dx%d+%d+%d", &width, &height, &left, &top) != 4 || width < 1 || height < 1 ||
        left < 0 || top < 0 || width > image->width - left || height > image->height - top)
        return report("--part %s: no part of a picture of %dx%d", text, image->width,
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

int main(int argc, char **argv)
{
    bool words = argc > 1 && strcmp(argv[1], "--words") == 0;
    argv += words;
    argc -= words;
    const char *part = argc > 2 && strcmp(argv[1], "--part") == 0 ? argv[2] : NULL;
    argv += part != NULL ? 2 : 0;
    argc -= part != NULL ? 2 : 0;
    if (argc != 3 && argc != 4) {
        fprintf(stderr, "usage: compare [--words | --part WxH+X+Y] A.png B.png [DIFFERENCE.png]\n");
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
