// Solution to exercise 01.1: a torus instead of the orbit of balls.
//
// The chapter's sceneDistance is renamed; everything else is as in the chapter.
#include "main.glsl"
#define sceneDistance chapterDistance
#include "01_normal_colouring.frag"
#undef sceneDistance

// The signed distance to a torus around the y axis, exact everywhere.
//   p         point, scene units
//   radius    from the centre to the middle of the tube, > 0, scene units
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
