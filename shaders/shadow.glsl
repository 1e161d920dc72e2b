// shadow.glsl - does the light reach a point?
#include "march.glsl"

// The ray from a little above the surface towards the light.
//   p        point found by a march, scene units
//   normal   of the surface there, length 1
//   toLight  direction of the light, length 1
//   offset   scene units; more than the march's threshold divided by the length of the gradient, otherwise
//            the shadow ray's march ends at once on the surface that the ray leaves
// Source: report, section 1.5.2, where the offset is missing.
Ray shadowRay(vec3 p, vec3 normal, vec3 toLight, float offset)
{
    return Ray(p + offset * normal, toLight);
}

// How far a shadow ray needs to search: not at all if the surface faces away from the light, because Lambert's
// law then gives 0 anyway.
//   normal, toLight  of any length: only the sign of their dot product matters
//   far      scene units, >= 0: to the lamp, or to where the scene ends
//   returns  far if dot(normal, toLight) > 0, otherwise 0, with which lightReaching and coneReaching take no
//            step
float shadowReach(vec3 normal, vec3 toLight, float far)
{
    return dot(normal, toLight) > 0.0 ? far : 0.0;
}

// The share of the light that arrives: 0 if the scene blocks the ray, otherwise 1.
//   ray        from shadowRay
//   distance   how far to search, scene units: to the lamp and no farther, or an object behind the
//              lamp would cast a shadow; 0 or less costs nothing and returns 1
//   threshold, maxSteps  of the march
float lightReaching(Ray ray, float distance, float threshold, int maxSteps)
{
    return march(ray, 0.0, distance, threshold, maxSteps).found ? 0.0 : 1.0;
}
