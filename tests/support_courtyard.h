// support_courtyard.h - chapters/courtyard.glsl once more, in double precision, by distances of its
// own.
#ifndef SUPPORT_COURTYARD_H
#define SUPPORT_COURTYARD_H

#include "support_mirror.h"

// The things of the court: steps, arcade and walls behind, roof, well, jars, box trees.
//   what  receives the name of the nearest; may be NULL
double courtyard_distance(struct d3 p, const char **what);

// Floor and side walls.
double courtyard_trough(struct d3 p);

// Where an eye's ray ends.
struct courtyard_place {
    bool open; // at the sky
    struct d3 p, normal, colour;
    double radius;    // of the pixel's footprint
    const char *what; // "paving", "side", or the nearest thing
};

struct courtyard_place courtyard_place(struct mirror_ray ray, double threshold, double spread,
                                       int max_steps);

#endif
