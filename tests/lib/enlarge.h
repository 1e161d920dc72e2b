// enlarge.h - how well filters enlarge pictures of a lower resolution, and what the filters cost.
#ifndef TESTS_ENLARGE_H
#define TESTS_ENLARGE_H

#include "picture/enlarge.h"
#include "lib/compare.h"
#include "lib/gpu.h"

// A chapter's picture, to be drawn at 640x360.
struct enlarge_scene {
    const char *shader;
    struct camera camera;
};

enum { ENLARGE_SCENES = 5 };
extern const struct enlarge_scene enlarge_scenes[ENLARGE_SCENES];

// How much an enlarged picture differs from the picture at full resolution.
struct enlarge_error {
    struct image_difference difference;
    double rms; // root mean square difference over all channels, in [0, 255]
};

// Draw a target's picture through a filter, at a given size. Fails the test, or ends the program,
// if that is impossible. The caller frees the floats: 4 per pixel, bottom row first.
float *enlarge_numbers(enum enlarge_filter filter, const struct target *from, int width,
                       int height);

// Like enlarge_numbers, but with an enlarger that the caller closes with enlarge_close.
float *enlarge_numbers_with(struct enlarge *enlarge, enum enlarge_filter filter,
                            const struct target *from, int width, int height);

// Draw the scene at full resolution and with each side divided by divisor, enlarge the small
// picture with each filter, and compare the enlarged pictures with the full one.
//   error  receives the error of each filter
void enlarge_measure(const struct enlarge_scene *scene, double divisor,
                     struct enlarge_error error[ENLARGE_FILTERS]);

// Print errors and costs, for build/tests/measure. Returns an exit status.
int enlarge_print(void);

#endif
