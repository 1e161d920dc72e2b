// compare A.png B.png [DIFFERENCE.png] - are two pictures the same one?
//
// Prints the two numbers that decide, the largest difference, how many pixels differ at all, and
// the place that differs most, in pixels as --probe counts them. Exit status: 0 within tolerance, 1
// outside, 2 when it could not compare.
#include <stdio.h>

#include "support_compare.h"

enum { SAME = 0, DIFFERENT = 1, NOT_COMPARED = 2 };

static int compare(const struct image *a, const struct image *b, const char *picture)
{
    struct image_difference difference;
    if (!image_compare(a, b, &difference))
        return NOT_COMPARED;
    printf("F2 %.4f %% B8 %.3f largest %d", 100.0 * difference.f2, difference.b8,
           difference.largest);
    if (difference.differs > 0)
        printf(" differ %zu most at %d,%d", difference.differs, difference.x, difference.y);
    printf("\n");
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
    if (argc != 3 && argc != 4) {
        fprintf(stderr, "usage: %s A.png B.png [DIFFERENCE.png]\n", argv[0]);
        return NOT_COMPARED;
    }
    struct image a = {0}, b = {0};
    int status = NOT_COMPARED;
    if (image_read_png(&a, argv[1]) && image_read_png(&b, argv[2]))
        status = compare(&a, &b, argc == 4 ? argv[3] : NULL);
    image_free(&a);
    image_free(&b);
    return status;
}
