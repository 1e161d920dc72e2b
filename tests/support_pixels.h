// support_pixels.h - pixels of a chapter's picture against colours computed in double precision.
#ifndef SUPPORT_PIXELS_H
#define SUPPORT_PIXELS_H

#include <stddef.h>

#include "support_gpu.h"
#include "support_mirror.h"

// A pixel of a picture of 640x360, 0,0 bottom left, and what stands there, so that the choice keeps
// covering the scene.
struct pixel {
    const char *picture;
    int x, y;
    const char
        *what; // the part, then '+' lit, '-' turned away (or unlit by any lamp), '#' in shadow
};

struct pixel_list {
    const struct pixel *pixel;
    int count;
    double tolerance; // the largest difference of a channel, of 1
};

// Draw a picture and hold its pixels, those of the list that name it, at least five, against the
// colours that picture->sample computes. A cmocka test: it fails where a colour is off by more than
// the tolerance, or where a pixel or one within two pixels of it shows something else.
void pixels_check(const struct mirror_picture *picture, const struct pixel_list *list);

// The same of the picture that a chapter draws without options: the colours of the list are right
// within 0.1 of 255.
void pixels_check_chapter(const char *stem,
                          struct mirror_sample (*sample)(const struct mirror_eye *eye),
                          const struct pixel *pixel, size_t count);

#endif
