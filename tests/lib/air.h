// air.h - the light of a clear sky by an integration of its own, for the tables of chapter
// 18: Gauss's rule in pieces, with the exponential of the library, up to 120 km; and by chance.
#ifndef TESTS_AIR_H
#define TESTS_AIR_H

// The light that comes once scattered from a direction, in the unit of the tables, 4,000 cd/m^2;
// what a screen cannot show is not cut off.
//   sun, view, azimuth  as of air_scattered in shaders/textures/air.h
//   ozone               1, or 0 for none
//   tall                how high the air reaches, km
void air_light_of(double sun, double view, double azimuth, double ozone, double tall,
                  double light[3]);

// The same with the light that is scattered more than once, which is the program's own: air_paths
// checks it.
void air_all_of(double sun, double view, double azimuth, double ozone, double light[3]);

// The light of all the sky on a level white surface: the mean of air_all_of over the directions,
// weighted by the sine of their height.
void air_ambient_of(double sun, double light[3]);

// The light of a direction by chance: paths followed backwards from the eye through the air of a
// round Earth, each scattered in random directions by the true laws of air and dust until hardly
// anything is left, and lit by the sun at every turn. In shares of the sunlight above the air, per
// steradian.
//   albedo  of the ground, in [0, 1]
//   wave    of air_waves
//   count   of paths
struct air_paths {
    double once, more; // scattered once, and more than once
    double error;      // of more, a standard deviation
};
struct air_paths air_paths(double sun, double view, double azimuth, double albedo, int wave,
                           int count);

// Of a colour in the tables' unit: cd/m^2, and the chromaticity x, y of 1931.
double air_luminance(const double light[3]);
void air_chromaticity(const double light[3], double xy[2]);

#endif
