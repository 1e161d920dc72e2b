// Solution to exercise 10.5: the ring of the still life has a square cross-section, which rests on
// a corner. The square does not reach the axis, so the distance is exact.
#include "transform.glsl"
#include "plane.glsl"
#include "solids.glsl"

// A ring around the y axis.
//   radius      from the axis to the centre of the square, scene units
//   halfHeight  from the centre to a corner
float squareRing(vec3 p, float radius, float halfHeight)
{
    vec2 q = opRevolve(p, radius);
    return sdRectangle(0.70710678 * vec2(q.x + q.y, q.y - q.x), vec2(0.70710678 * halfHeight));
}

#define sdTorus squareRing
#include "experiments/10_solids.frag"
