// marches.h - the marches of chapters/experiments/16_marches.glsl in eleven scenes: what each costs
// and where it errs.
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
    MARCH_KINDS,               // those that are compared
    MARCH_TIGHT = MARCH_KINDS, // the plain march with the smallest threshold, which gives the truth
};

// The value of MARCH in GLSL, and what a table calls it.
extern const char *const march_macros[MARCH_KINDS + 1];
extern const char *const march_names[MARCH_KINDS];

struct march_scene {
    const char *name;
    const char *stem;   // of the chapter whose camera it has
    const char *before; // GLSL in front of the marches
    const char *source; // what is included: a chapter or an experiment
    const char
        *after; // GLSL behind it: coarseMargin where the chapter has none; NULL for a complete file
    const char *restore; // GLSL that resets what later rays have changed in the scene
    const char *setting; // NAME=VALUE, or NULL
    bool knows_fall; // it bounds the slope along a segment, so the segment march differs from the
                     // plain one
    bool lipschitz;  // its distance is 1-Lipschitz, so the least number of evaluations is known
};

enum { MARCH_SCENES = 11, MARCH_STRESS = 7 }; // the last four are those of 16_stress.frag
extern const struct march_scene march_scenes[MARCH_SCENES];

// Load a scene with a march into a renderer, and the inputs of its picture. Returns false after
// reporting the error.
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
    double evaluations; // per pixel, including the coarse pass
    double lockstep;    // the mean over blocks of 8 x 8 pixels of the largest number, over the mean
    int false_hits;     // pixels that find something where the truth is nothing
    int false_misses;   // pixels that find nothing, or only what is more than the threshold behind
                        // the truth
};

struct march_costs march_costs_of(const struct march_picture *picture,
                                  const struct march_picture *truth, double threshold);

// Evaluations per ray over the fewest that would be enough for the plain march, over the rays of
// shaders/cover.glsl.
//   fewest  from march_fewest: for each pixel the fewest, or -1
double march_over_bound(const struct march_picture *picture, const int *fewest);

// For each pixel that shaders/cover.glsl examines, the fewest evaluations for the plain march; -1
// elsewhere. The caller frees it.
int *march_fewest(struct renderer *renderer, const struct march_scene *scene, int width,
                  int height);

// The march in double precision through scene STRESS of 16_stress.frag, 0 to 3, without coarse
// pass.
//   spread  of MARCH_CONE
struct mirror_march march_in_double(int stress, enum march_kind kind, struct mirror_ray ray,
                                    double far, double threshold, double spread);

// The distance of that scene.
double march_stress_distance(int stress, struct d3 p);

// Print both tables of docs/benchmark.md. Returns an exit status.
int marches_print(void);

#endif
