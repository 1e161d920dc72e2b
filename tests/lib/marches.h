// marches.h - the marches of chapters/experiments/16_marches.glsl in eleven scenes: the cost and
// the errors of each.
#ifndef TESTS_MARCHES_H
#define TESTS_MARCHES_H

#include "lib/gpu.h"
#include "lib/mirror.h"

enum march_kind {
    MARCH_PLAIN,
    MARCH_RELAXED,
    MARCH_ENHANCED,
    MARCH_SEGMENT,
    MARCH_OVERSTEP,
    MARCH_CONE,
    MARCH_COARSE,
    MARCH_KINDS,               // the number of marches that are compared
    MARCH_TIGHT = MARCH_KINDS, // the plain march with the smallest threshold, used as the truth
};

// The values of MARCH in GLSL, and the names of the marches in a table.
extern const char *const march_macros[MARCH_KINDS + 1];
extern const char *const march_names[MARCH_KINDS];

struct march_scene {
    const char *name;
    const char *stem;   // the chapter, whose camera is used, except in the last four scenes
    const char *before; // GLSL before the marches
    const char *source; // the included file: a chapter or an experiment
    // GLSL after the included file: coarseMargin if the chapter has none; NULL for an experiment.
    const char *after;
    const char *restore; // GLSL that resets variables of the scene that later rays have changed
    const char *setting; // a parameter's value, as NAME=VALUE; may be NULL
    // True if the scene bounds the slope along a segment, so the segment march differs from the
    // plain one.
    bool knows_fall;
    bool lipschitz; // the distance is 1-Lipschitz, so the least number of evaluations is known
};

enum { MARCH_SCENES = 11, MARCH_STRESS = 7 }; // the scenes from 7 on are those of 16_stress.frag
extern const struct march_scene march_scenes[MARCH_SCENES];

// Load a scene with a march into a renderer. Returns false after reporting the error. march_inputs
// returns the inputs of the scene's picture.
bool march_load(struct renderer *renderer, const struct march_scene *scene, enum march_kind kind);
struct renderer_inputs march_inputs(const struct march_scene *scene, int width, int height);

// What a march found, for each pixel.
struct march_picture {
    int width, height;
    int *evaluations;
    double *t;
    bool *found;
    double shared; // evaluations of the coarse pass, per pixel
};

// Draw a scene and read back what its march found. Free the result with march_free. Fails the test,
// or ends the program, if that is impossible.
struct march_picture march_draw(struct renderer *renderer, const struct march_scene *scene,
                                int width, int height);
void march_free(struct march_picture *picture);

struct march_costs {
    double evaluations; // the mean number per pixel, including the coarse pass
    double lockstep;  // the largest number of evaluations in a block of 8 x 8 pixels, averaged over
                      // the blocks and divided by the mean number of evaluations
    int false_hits;   // pixels that find a surface although there is none in the truth
    int false_misses; // pixels that miss a surface of the truth, or find a surface more than the
                      // threshold behind it
};

struct march_costs march_costs_of(const struct march_picture *picture,
                                  const struct march_picture *truth, double threshold);

// The evaluations of the rays that shaders/cover.glsl examines, divided by the fewest that would be
// enough for the plain march.
//   fewest  the result of march_fewest
double march_over_bound(const struct march_picture *picture, const int *fewest);

// The fewest evaluations that would be enough for the plain march, for each pixel that
// shaders/cover.glsl examines; -1 for the others. The caller frees the result.
int *march_fewest(struct renderer *renderer, const struct march_scene *scene, int width,
                  int height);

// A march in double precision, without a coarse pass, through a scene of 16_stress.frag.
//   stress  the scene, 0 to 3, as STRESS in the shader
//   spread  growth of the threshold along the ray, for MARCH_CONE
struct mirror_march march_in_double(int stress, enum march_kind kind, struct mirror_ray ray,
                                    double far, double threshold, double spread);

// The distance from p to a scene of 16_stress.frag.
double march_stress_distance(int stress, struct d3 p);

// Print both tables of docs/benchmark.md that compare the marches. Returns an exit status.
int marches_print(void);

#endif
