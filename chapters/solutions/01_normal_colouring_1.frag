// Solution to exercise 01.1: a torus instead of the orbit of balls.
//
// The chapter's own sceneDistance gets another name; everything else is the chapter's.
#include "main.glsl"
#define sceneDistance chapterDistance
#include "01_normal_colouring.frag"
#undef sceneDistance

// The signed distance to the points within a given distance of a horizontal circle, exact
// everywhere.
//   p         point, scene units
//   radius    of the circle, > 0, scene units
//   thickness radius of the tube, in (0, radius], scene units
//   formula   |(|(x, z)| - radius, y)| - thickness
float sdTorus(vec3 p, float radius, float thickness)
{
    return length(vec2(length(p.xz) - radius, p.y)) - thickness;
}

float sceneDistance(vec3 p)
{
    float frame = sdBoxFrame(p, vec3(0.8), 0.08);
    return min(min(frame, sdSphere(p, 0.52)), sdTorus(p, 1.5, 0.2));
}
