// report_pictures.h - three pictures of the report, redrawn by the experiments 16_report_*.frag:
// build/tests/measure times them, and tests/pictures/report_pictures.c checks them against the
// figures.
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
    const char *setting[REPORT_SETTINGS]; // NAME=VALUE, or NULL if unused
    double engine; // time of the report's engine for the figure, in the unit of report_print
    // The first is the picture itself. Unused elements have the name NULL.
    struct report_variant variant[REPORT_VARIANTS];
};

// The boxes of figure 9, the pyramid of figure 10 and the city of figure 11.
extern const struct report_scene report_scenes[REPORT_SCENES];

// Load a scene.
//   variant  one of the scene's variants, or NULL for the picture itself
// Returns false after reporting the error.
bool report_load(struct renderer *renderer, const struct report_scene *scene,
                 const struct report_variant *variant);

// The inputs of a scene's picture from the viewpoint of the figure, with one sample per pixel.
struct renderer_inputs report_inputs(const struct report_scene *scene, int width, int height);

// Print the cost of each variant at 640x360, in units of tests/pictures/reference_scene.frag, next
// to the engine's cost. A cost is the process CPU time of the fastest of several frames, where all
// variants of a scene and the unit are drawn in turn. Returns an exit status.
int report_print(void);

#endif
