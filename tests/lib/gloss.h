// gloss.h - the two models of shaders/gloss.glsl in double precision, and the share of the incoming
// light that a surface sends back in each model.
#ifndef TESTS_GLOSS_H
#define TESTS_GLOSS_H

#include "lib/mirror.h"

// A highlight, per steradian, on a surface with the normal (0, 0, 1).
typedef double gloss_model(struct d3 to_light, struct d3 to_eye, double parameter);

double gloss_ggx(struct d3 to_light, struct d3 to_eye, double roughness);
double gloss_blinn_phong(struct d3 to_light, struct d3 to_eye, double exponent);
// Blinn-Phong with the usual factor (n + 8) / (8 pi), and without a factor.
double gloss_usual(struct d3 to_light, struct d3 to_eye, double exponent);
double gloss_bare(struct d3 to_light, struct d3 to_eye, double exponent);

// The exponent whose highlight is about as wide as that of GGX with this roughness:
// 2 / roughness^4 - 2.
double gloss_exponent(double roughness);

// The direction to an eye whose angle to the normal has this cosine.
struct d3 gloss_eye(double cosine);

// The directional albedo: the light that a surface sends to the eye under a sky of radiance 1. By
// reciprocity, it is also the share of the light from the eye's direction that the surface sends
// back. It is summed over 384 x 384 half vectors, which are distributed like a highlight of this
// roughness.
double gloss_albedo(gloss_model *model, double parameter, double roughness, double cosine);

// The mean of the directional albedo over all directions of the eye, each weighted by its cosine:
// the share of a whole sky's light that the surface sends back.
double gloss_mean_albedo(gloss_model *model, double parameter, double roughness);

#endif
