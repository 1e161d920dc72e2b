// support_city.h - the city of chapter 09 in double precision.
#ifndef SUPPORT_CITY_H
#define SUPPORT_CITY_H

#include "support_mirror.h"

// One tower: half sizes of shaft and base across, and how high each is, scene units.
struct city_tower {
    float random; // the block's number, as the shader's hash says
    double shaft_x, shaft_z, shaft_height, base, base_height;
};

struct city_tower city_tower_of(int x, int z);

// cellRandom of shaders/repetition.glsl, in the same integers.
float city_random(int x, int y, int z);

// The exact distance to the towers of the blocks around p, `reach` blocks to each side, by brute
// force: each tower is two boxes that go down without end.
double city_towers_brute(struct d3 p, int reach);

// The distance of lamps and trees, as the shader has it, in double.
double city_street(struct d3 p);

// The distance of the whole city, as the shader has it.
//   nearest  receives 0 for a tower, 1 for a lamp, 2 for a tree, 3 for the cap
double city_distance(struct d3 p, int *nearest);

extern const struct mirror_scene city_scene;

// Where the sun stands at an hour of the chapter's day.
struct d3 city_sun(double hour);

// The light of the sky in a direction of length 1, not below the horizon, without the sun's disc;
// with the chapter's haze, 0.05.
struct d3 city_sky(struct d3 direction, struct d3 sun);

// What a pixel shows at an hour, the parameters as the shader sets them. Lamps and trees are named,
// not coloured.
struct mirror_sample city_sample(const struct mirror_eye *eye, double hour);

#endif
