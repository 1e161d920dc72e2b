// Experiment of chapter 10: a rectangle whose distance is the larger coordinate,
// max(|x| - hx, |y| - hy). The outline and the values inside are those of the exact distance.
// Outside, the larger coordinate is a lower bound: in front of a corner it is too small, at worst
// by a factor of sqrt(1/2).
#include "main.glsl"
#include "plane.glsl"

float largerCoordinate(vec2 p, vec2 halfSize);

#define sdRectangle largerCoordinate
#include "10_distance_in_the_plane.frag"
#undef sdRectangle

float largerCoordinate(vec2 p, vec2 halfSize)
{
    vec2 q = abs(p) - halfSize;
    return max(q.x, q.y);
}
