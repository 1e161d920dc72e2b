// glass.h - light through glass in double precision, computed with angles where the shaders use
// vectors.
#ifndef TESTS_GLASS_H
#define TESTS_GLASS_H

#include "lib/mirror.h"

// The reflected share, from Fresnel's formulas with the sines and tangents of both angles. The
// library uses a different formula.
//   facing  cosine of the angle on the side from which light comes
//   eta     refractive index on that side divided by that on the other side
double glass_fresnel(double facing, double eta);
double glass_schlick(double facing, double straight);

// The refracted direction, from the angle of refraction. Returns false for total reflection.
//   normal  on the side from which light comes
bool glass_refract(struct d3 direction, struct d3 normal, double eta, struct d3 *bent);

static inline struct d3 glass_reflect(struct d3 direction, struct d3 normal)
{
    return d3_sub(direction, d3_times(2.0 * d3_dot(direction, normal), normal));
}

typedef double (*glass_distance)(struct d3 p);

// The function marchSide of shaders/glass.glsl. t receives the end of the march. Returns false if
// the march finds no surface.
bool glass_march(glass_distance distance, struct mirror_ray ray, double side,
                 const double from_to[2], double threshold, int max_steps, double *t);

// The function leavingRay of shaders/glass.glsl.
struct mirror_ray glass_leaving(struct d3 p, struct d3 normal, struct d3 direction, double offset);

// The refractive index from Cauchy's formula, for a wavelength in micrometres.
double glass_index(double a, double b, double wavelength);

// The colour of a wavelength in micrometres, in the screen's primaries, from the fit of Wyman,
// Sloan and Shirley to the CIE's curves. Negative channels count as 0, and each channel is divided
// by its mean over the wavelengths from 0.40 to 0.70.
void glass_wave_colour(double wavelength, double colour[3]);

// The deflection, in radians, of a ray that meets a drop at a distance of radius * offset from the
// drop's axis. For one reflection, the deflection is in [0, pi].
//   mirrored  the number of reflections inside the drop
double glass_drop_turn(double offset, double index, int mirrored);

// The light that chapter 17's picture, 640x360, lacks in a white world if each ray may meet at most
// a given number of surfaces.
struct glass_rest {
    double pixels; // share of the pixels of glass that lack more than 1/255
    double mean;   // missing light, averaged over the pixels of glass
};

// Draw the picture and measure the missing light. Fails the test, or ends the program, if the
// picture cannot be drawn.
struct glass_rest glass_furnace(int surfaces);

// Print tables of reflected shares, of Schlick's error, of each wavelength's indices and angles,
// and of dark pixels. Returns an exit status.
int glass_print(void);

#endif
