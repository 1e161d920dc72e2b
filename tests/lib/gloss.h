// gloss.h - the two models of shaders/gloss.glsl in double precision, and how much of the
// light that a surface receives each sends back.
#ifndef TESTS_GLOSS_H
#define TESTS_GLOSS_H

#include "lib/mirror.h"

// A highlight, per steradian, on a surface with the normal (0, 0, 1).
typedef double gloss_model(struct d3 to_light, struct d3 to_eye, double parameter);

double gloss_ggx(struct d3 to_light, struct d3 to_eye, double roughness);
double gloss_blinn_phong(struct d3 to_light, struct d3 to_eye, double exponent);
// With the usual factor (n + 8) / (8 pi), and with none.
double gloss_usual(struct d3 to_light, struct d3 to_eye, double exponent);
double gloss_bare(struct d3 to_light, struct d3 to_eye, double exponent);

// The exponent whose highlight is about as wide as that of a roughness: 2 / roughness^4 - 2.
double gloss_exponent(double roughness);

// The way to an eye under an angle with this cosine to the normal.
struct d3 gloss_eye(double cosine);

// The directional albedo: what a surface sends to the eye under a sky of 1 everywhere; by
// reciprocity also the share of light from there that it sends back. Over 256 x 256 halves of the
// way between, chosen where a highlight of this roughness is.
double gloss_albedo(gloss_model *model, double parameter, double roughness, double cosine);

// The same over all ways of the eye, each with its cosine: the share of a whole sky's light.
double gloss_mean_albedo(gloss_model *model, double parameter, double roughness);

#endif
