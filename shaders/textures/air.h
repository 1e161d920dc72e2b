// air.h - the light of a clear sky: sunlight that the air of a round Earth scatters, once or
// several times. The programs that paint the tables sky_sunward, sky_away, no_ozone_sunward,
// no_ozone_away, sun_halo and sky_meter use this header.
//
// Light is in the unit of the course's skies: 1 is 4,000 cd/m^2. The sun's light on a surface is
// given as the light that a white matt surface perpendicular to the sun's rays sends back. Colours
// are linear sRGB. The heights of the sun and of directions are angles, given by their sines.
#ifndef AIR_H
#define AIR_H

#include "air_path.h"

// The light that the air sends towards an eye at sea level. Multiply the first two kinds by
// phaseAir and phaseDust of shaders/sky_table.glsl, which depend on the scattering angle, and add
// all three.
struct air_light {
    double air[3];  // scattered once, by molecules
    double dust[3]; // scattered once, by dust and droplets
    double more[3]; // scattered more than once, by air, dust or the ground; not to be multiplied
                    // by a phase function
};

// The scattered light of a direction: the integral, along the direction, of the light scattered at
// each point, which is dimmed on its path to that point and from there to the eye; summed over 16
// wavelengths. The light that has been scattered before it arrives at a point comes from a grid,
// which takes a few seconds to compute, on the first call and whenever ozone changes. The grid
// contains four orders of scattering, by air, dust and a ground of albedo 0.15; the light of each
// order is assumed to arrive equally from all directions.
//   sun      sine of the sun's height, in [-1, 1]; the Earth casts its shadow on the air
//   view     sine of the direction's height, in [0, 1]
//   azimuth  cosine of the horizontal angle to the sun, in [-1, 1]: 1 towards the sun
//   ozone    amount of ozone; 1 is 300 Dobson units, 0 leaves it out
struct air_light air_scattered(double sun, double view, double azimuth, double ozone);

// The scattered light of each wavelength, as shares of the sunlight above the air: per steradian
// once air and dust have been multiplied by their phase functions, as in struct air_light.
struct air_shares {
    double air[AIR_WAVES], dust[AIR_WAVES], more[AIR_WAVES];
};
void air_shares(double sun, double view, double azimuth, double ozone, struct air_shares *shares);

// The sun's light on a surface perpendicular to its rays, after its path through the air, without
// refraction.
//   sun      sine of the sun's height; below 0 the result is 0
void air_sunlight(double sun, double colour[3]);

// ---- The tables ----

// A table has a column for each height of the sun and three storeys of rows, from the bottom: light
// scattered once by air, light scattered once by dust, and light scattered more than once. In each
// storey there is a row for each height of the direction. shaders/sky_table.glsl reads the tables.
enum { AIR_COLUMNS = 288, AIR_ROWS = 160 };

// k for the sun's height and k for the direction's height; and the sine of the lowest height of the
// sun in a table.
#define AIR_SUN_WIDTH  0.10
#define AIR_VIEW_WIDTH 0.06
#define AIR_LOWEST_SUN (-0.28)

// The light of a low sun is redder than a screen's red: its blue is slightly negative, which a
// colour of a picture cannot represent; and near 0 a screen distinguishes more values of blue
// than a byte has. So a fourth number, stored unchanged, contains the missing part of the blue, in
// units of AIR_FINE times the red's scale; the byte 128 adds nothing.
#define AIR_FINE 0.06

// The light that a table's number 1 represents: a smooth function of the sun's height and of the
// row, the same as in shaders/sky_table.glsl.
//   sun   sine of the sun's height
//   row   of the direction's height: air_drawn_out of the height's sine, 0 to 1
struct air_scale {
    double air[3], dust[3], more[3];
};
struct air_scale air_scale(double sun, double row);

// A table's colour at a point, and the blue that it lacks, for paint_texture.
//   azimuth  1 for the half of the sky that contains the sun, -1 for the other half
//   ozone    1, or 0 for air without ozone; the table then contains a quarter of the light
void air_table(double u, double v, double azimuth, double ozone, double value[4]);

// The table of the sun. It has a column for each distance from the sun's centre, from 0 to
// SUN_REACH radii of the sun; the distance grows as the square of the column's index. It has a row
// for each sine of the direction's height, from 0 to 1, stretched with k = SUN_ROW_WIDTH.
enum { SUN_COLUMNS = 64, SUN_ROWS = 64 };
#define SUN_REACH     12.0
#define SUN_ROW_WIDTH 0.15

// The disc and its halo at a point of the table, for paint_texture.
void air_sun_table(double u, double v, double value[3]);

#endif
