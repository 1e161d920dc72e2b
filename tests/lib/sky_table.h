// sky_table.h - the sky of chapter 18, from the chapter's tables and from other methods, compared
// with an integral.
#ifndef TESTS_SKY_TABLE_H
#define TESTS_SKY_TABLE_H

#include <stdbool.h>

// The number of heights of the sun, from -8 to 90 degrees, and of the direction, from 0 to 90
// degrees.
enum { SKY_SUNS = 128, SKY_HEIGHTS = 48 };

// Load tests/shaders/sky_table.frag into the renderer. Returns false after reporting the error.
bool sky_table_open(void);

// The sine of the sun's height in a column.
double sky_table_sun(int column);

// The values of a function of tests/shaders/sky_table.frag: SKY_HEIGHTS rows of SKY_SUNS points of
// four numbers, which the caller frees.
//   way, encoded  as in chapters/experiments/18_ways.glsl
//   function      0 for the sky; the shader lists the others
//   number        the shader's iMouse.x: for the sky, the cosine of the horizontal angle to the sun
float *sky_table_read(int way, int function, double number, bool encoded);

// Errors of the sky in steps of 1/255, with the light exposed according to domeStops, clamped to
// [0, 1] and encoded.
struct sky_table_error {
    double mean, most;
    double by_day;      // the largest error while the sun is at least 5 degrees high
    double over;        // the share of directions in which a channel is off by more than 1
    double sun, height; // heights of the sun and of the direction with the largest error, degrees
};
struct sky_table_error sky_table_error(int way, double azimuth, bool encoded);

// The light on level ground from the clear sky and the sun, in lux, for a height of the sun in
// degrees.
// Source: P. M. Janiczek, J. A. DeYoung, 'Computer programs for sun and moon illuminance', U.S.
// Naval Observatory circular 171 (1987), a fit to measurements, from 90 degrees to -18.
double sky_measured_lux(double degrees);

// The light on level ground from the integral, in lux, divided into single and multiple scattering
// in the sky, the sun, and the night sky of chapter 18.
struct sky_lux {
    double once, more, sun, night;
};
struct sky_lux sky_lux(double degrees);

// Print the errors of all methods, the light on level ground next to measured values, the colour of
// the zenith, and the bytes of the tables. Returns the program's exit status.
int sky_table_print(void);

#endif
