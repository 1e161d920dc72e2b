// probe.h - the march of one ray, as the GPU computed it and as text.
#ifndef PROBE_H
#define PROBE_H

#include <stdbool.h>
#include <stdio.h>

#define PROBE_STEPS 2048 // maximum number of steps that a probe records
#define PROBE_ROWS  3    // rows of the target that a probe's program draws, one column per step

// One step of a probe: a position on the ray, and the scene's distance there.
struct probe_step {
    float t;           // distance along the ray, scene units
    float distance;    // the scene's distance at this position
    float position[3]; // scene units
    float threshold;   // a smaller distance would be a hit, scene units; 0 if unknown
    float pixel[2];    // position in the picture, pixels from the picture's bottom left corner
    bool seen;         // the step is in front of the camera, so that pixel is defined
};

enum probe_end { PROBE_NO_MARCH, PROBE_HIT, PROBE_PASSED, PROBE_GAVE_UP };

// The march of one pixel's first ray, as the GPU computed it.
struct probe {
    struct probe_step step[PROBE_STEPS];
    int steps;          // number of steps of the first march; step contains at most PROBE_STEPS
    int all_steps;      // number of steps of all marches of the pixel, including shadow rays
    int evaluations;    // evaluations of the scene's distance, including those for normals
    enum probe_end end; // why the first march stopped
    float interval[2];  // interval of the first march, scene units along the ray; 0, 0 if unknown
    bool pinned;        // the ray's camera or lens is not the picture's
    bool recorded;      // false outside the course's dialect, where only the colour is known
    unsigned char colour[3]; // the pixel's colour
};

// Unpack the table that shaders/main.glsl draws for a probe, which contains everything except the
// colour and the positions in the picture. Column k, for step k, contains:
//   row 0  t, distance, steps of the first march, how that march ended
//   row 1  position x, y, z, threshold
//   row 2  steps of all marches, evaluations, interval of the first march
//   values  PROBE_STEPS x PROBE_ROWS pixels of 4 floats, row 0 first
void probe_unpack(struct probe *probe, const float *values);

// Return the number of steps of the first march that the probe contains.
int probe_rows(const struct probe *probe);

// Return why the first march stopped, such as "hit".
const char *probe_outcome(const struct probe *probe);

// Print the table of the march, then a line with its outcome, the cost of the pixel and its colour.
void probe_print(const struct probe *probe, FILE *file);

#endif
