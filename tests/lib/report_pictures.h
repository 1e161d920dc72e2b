// report_pictures.h - three pictures of the report, redrawn by the experiments 16_report_*.frag:
// build/tests/measure times them, and test_report checks them against the figures.
#ifndef TESTS_REPORT_PICTURES_H
#define TESTS_REPORT_PICTURES_H

#include "lib/gpu.h"

// A picture without one method, to show what that method gains.
struct report_variant {
    const char *name;
    const char *setting; // NAME=VALUE, or NULL if nothing is left out
};

enum { REPORT_SCENES = 3, REPORT_SETTINGS = 2, REPORT_VARIANTS = 5 };

struct report_scene {
    const char *name, *shader;
    struct camera camera;
    const char *setting[REPORT_SETTINGS]; // NAME=VALUE or NULL
    double engine;                        // time of the report's engine for the figure, units
    struct report_variant
        variant[REPORT_VARIANTS]; // the first is the picture itself; the last name is NULL
};

// The boxes of figure 9, the pyramid of figure 10, the city of figure 11.
extern const struct report_scene report_scenes[REPORT_SCENES];

// Load a scene.
//   variant  one of its variants, or NULL for the picture itself
// Returns false after reporting the error.
bool report_load(struct renderer *renderer, const struct report_scene *scene,
                 const struct report_variant *variant);

// Its picture from the viewpoint of the figure, one sample.
struct renderer_inputs report_inputs(const struct report_scene *scene, int width, int height);

// Print what each costs at 640x360, in units of tests/pictures/reference_scene.frag, next to the
// engine's cost: process CPU time, the shortest of several frames, with all shaders of a scene and
// the unit in turn. Returns an exit status.
int report_print(void);

#endif
