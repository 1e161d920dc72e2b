// shadow.glsl - does the light reach a point?
#include "march.glsl"

// Where a shadow ray starts and goes: from a little above the surface towards the light.
//   p        point found by a march, scene units
//   normal   of the surface there, length 1
//   toLight  direction of the light, length 1
//   offset   scene units; more than the march's threshold over the length of the gradient, or the
//            ray starts as a hit on its own surface
// Source: report, section 1.5.2, where the offset is missing.
Ray shadowRay(vec3 p, vec3 normal, vec3 toLight, float offset)
{
    return Ray(p + offset * normal, toLight);
}

// How far a shadow ray is to look: not at all where the surface turns its back on the light, for there
// Lambert's law has already said 0.
//   normal, toLight  of any length: the sign of their product counts
//   far      scene units, >= 0: to the lamp, or to where nothing stands any more
//   returns  far where dot(normal, toLight) > 0, else 0, for which lightReaching and coneReaching march
//            nothing
float shadowReach(vec3 normal, vec3 toLight, float far)
{
    return dot(normal, toLight) > 0.0 ? far : 0.0;
}

// The share of the light that arrives: 0 when the scene stands in the way, else 1.
//   ray        from shadowRay
//   distance   how far to look, scene units: to the lamp and no farther, or an object behind the
//              lamp would cast a shadow; 0 or less is free and returns 1
//   threshold, maxSteps  of the march
float lightReaching(Ray ray, float distance, float threshold, int maxSteps)
{
    return march(ray, 0.0, distance, threshold, maxSteps).found ? 0.0 : 1.0;
}
