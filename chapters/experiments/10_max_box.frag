// Experiment of chapter 10: a rectangle by the larger coordinate, max(|x| - a, |y| - b). It has the same outline and the
// same inside, and is a lower bound outside: in front of a corner it is too small by up to the factor sqrt(1/2).
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
