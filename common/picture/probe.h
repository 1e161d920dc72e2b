// probe.h - the march of one ray: as the GPU computed it, and in words.
#ifndef PROBE_H
#define PROBE_H

#include <stdbool.h>
#include <stdio.h>

#define PROBE_STEPS 2048 // that one probe can hold
#define PROBE_ROWS  3    // of the target that a probe's program draws, one column a step

// One row of a probe: what the march knew after evaluating the distance once.
struct probe_step {
    float t;           // distance along the ray, scene units
    float distance;    // the scene's distance there
    float position[3]; // scene units
    float threshold;   // below it the distance would have been a hit, scene units; 0: not said
    float place[2];    // of the position in the picture, pixels; (0, 0) its bottom left corner
    bool seen;         // it is before the camera, so that it has a place
};

enum probe_end { PROBE_NO_MARCH, PROBE_HIT, PROBE_PASSED, PROBE_GAVE_UP };

// The march of one pixel's first ray, as the GPU computed it.
struct probe {
    struct probe_step step[PROBE_STEPS];
    int steps;          // of the first march; the table holds at most PROBE_STEPS
    int all_steps;      // of all marches of the pixel: shadow rays and all others included
    int evaluations;    // of the scene's distance, the normal's included
    enum probe_end end; // why the first march stopped
    float interval[2];  // where it was asked to look, scene units along the ray; 0, 0: not said
    bool aside;         // the picture's camera looks at the ray from elsewhere than it starts
    bool recorded;      // false: a file with a main of its own, of which the colour alone is known
    unsigned char colour[3]; // of the pixel in the picture
};

// Take over what shaders/main.glsl draws for a probe, all but the colour and the places: in column
// k
//   row 0  t, distance, steps of the first march, why it ended
//   row 1  position x, y, z, threshold
//   row 2  steps of all marches, evaluations, where the first march was asked to look
//   values  PROBE_STEPS x PROBE_ROWS pixels of 4 floats, row 0 first
void probe_unpack(struct probe *probe, const float *values);

// The rows of a probe's table: one for each step of the first march, as far as the probe holds
// them.
int probe_rows(const struct probe *probe);

// Why the first march stopped: "hit", ...
const char *probe_outcome(const struct probe *probe);

// The table: what the march of one ray knew at each step, then a line that says why it ended, what
// the pixel cost and what colour it has.
void probe_print(const struct probe *probe, FILE *file);

#endif
