// Solution to exercise 23.1: the cells of the grid, as a chequered pattern on the clay.
//
// A macro replaces the chapter's call to gradientNoise with a call to cellPattern.
#include "main.glsl"
#include "noise.glsl"
#include "stored.glsl"

// 3 and -3 in alternate cells.
//   p  nine times a point of the cube
vec4 cellPattern(vec3 p)
{
    ivec3 cell = ivec3(floor((0.5 + 0.5 * p / 9.0) * float(STORED_SIDE - 1)));
    return vec4((cell.x + cell.y + cell.z) % 2 == 0 ? 3.0 : -3.0, 0.0, 0.0, 0.0);
}

#define gradientNoise cellPattern
#include "23_stored_distances.frag"
