// air.h - the light of a clear sky, integrated independently to check the tables of chapter 18. One
// integration uses Gauss-Legendre quadrature in pieces, the C library's exponential and air up to
// 120 km; another follows random paths.
#ifndef TESTS_AIR_H
#define TESTS_AIR_H

// The light that arrives from a direction after one scattering, in the unit of the tables, 4,000
// cd/m^2. Values that a screen cannot show are not clamped.
//   sun, view, azimuth  as for air_scattered in shaders/textures/air.h
//   ozone               amount of ozone; 1 is 300 Dobson units, 0 is none
//   tall                the height of the air, km
void air_light_of(double sun, double view, double azimuth, double ozone, double tall,
                  double light[3]);

// The light of air_light_of plus the light that is scattered more than once. This second part comes
// from air_scattered itself; air_paths checks it.
void air_all_of(double sun, double view, double azimuth, double ozone, double light[3]);

// The light of the whole sky on a white horizontal surface: the mean of air_all_of over the
// directions, weighted by the sine of their height.
void air_ambient_of(double sun, double light[3]);

// The light from a direction, estimated with random paths. They are followed backwards from the eye
// through the air of a round Earth, scattered in random directions by the phase functions of air
// and dust until hardly any light is left, and lit by the sun at every scattering. The results are
// shares of the sunlight above the air, per steradian.
//   albedo  albedo of the ground, in [0, 1]
//   wave    index into air_waves
//   count   number of paths
struct air_paths {
    double once, more; // scattered once by the air; scattered more than once or by the ground
    double error;      // standard deviation of the estimate `more`
};
struct air_paths air_paths(double sun, double view, double azimuth, double albedo, int wave,
                           int count);

// Convert a colour in the tables' unit to luminance in cd/m^2, and to CIE 1931 chromaticity x, y.
double air_luminance(const double light[3]);
void air_chromaticity(const double light[3], double xy[2]);

#endif
