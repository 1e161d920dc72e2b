// probe.h - the march of one ray: as the GPU computed it, and in words.
#ifndef PROBE_H
#define PROBE_H

#include <stdio.h>

#define PROBE_STEPS 2048 // rows that one probe can hold

// One row of a probe: what the march knew after evaluating the distance once.
struct probe_step {
    float t;           // distance along the ray, scene units
    float distance;    // the scene's distance there
    float position[3]; // scene units
};

enum probe_end { PROBE_NO_MARCH, PROBE_HIT, PROBE_PASSED, PROBE_GAVE_UP };

// The march of one pixel's first ray, as the GPU computed it.
struct probe {
    struct probe_step step[PROBE_STEPS];
    int steps;          // of the first march; the table holds at most PROBE_STEPS
    int all_steps;      // of all marches of the pixel: shadow rays included
    int evaluations;    // of the scene's distance, the normal's included
    enum probe_end end; // why the first march stopped
    float interval[2];  // where it was asked to look, scene units along the ray; 0, 0: not said
};

// The rows of a probe's table: one for each step of the first march, as far as the probe holds
// them.
int probe_rows(const struct probe *probe);

// Why the first march stopped: "hit", ...
const char *probe_outcome(const struct probe *probe);

// The table: what the march of one ray knew at each step, then a line that says why it ended and
// what the pixel cost.
void probe_print(const struct probe *probe, FILE *file);

#endif
