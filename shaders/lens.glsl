// lens.glsl - a thin lens in place of a pinhole: one distance is sharp.
#include "samples.glsl"
#include "soft_shadow.glsl"

// The place of this sample on a disc, in its radii, so that all samples of a pixel cover it evenly; its middle
// with one sample.
//   dimension  of sampleSquare
vec2 sampleDisc(int dimension)
{
    return iSamples > 1 ? discPoint(sampleSquare(dimension)) : vec2(0.0);
}

// The ray through a point of the lens that meets the ray through its middle where that is in focus.
//   ray      through the middle of the lens, from perspectiveRay
//   place    on the lens, in its radii: in the unit disc, from discPoint; (0, 0) returns ray
//   radius   of the aperture, scene units, >= 0
//   focus    distance of the plane in focus, along the view direction, scene units, > 0
//   formula  with P the ray's point on that plane and A the place on the lens: from A towards P. A thin lens
//            sends all light of P that it catches to one point of the film
Ray lensRay(Ray ray, vec2 place, float radius, float focus)
{
    vec3 inFocus = ray.direction * (focus / dot(ray.direction, iCameraForward));
    vec3 aside = radius * (place.x * iCameraRight + place.y * iCameraUp);
    return Ray(ray.origin + aside, normalize(inFocus - aside));
}

// How large a point becomes: the diameter of its circle of confusion on the screen, half screen heights.
//   depth    of the point along the view direction, scene units, > 0
//   radius, focus  as of lensRay
//   focalLength    half screen heights, > 0
//   formula  2 radius focalLength |1 / focus - 1 / depth|. Exact
float circleOfConfusion(float depth, float radius, float focus, float focalLength)
{
    return 2.0 * radius * focalLength * abs(1.0 / focus - 1.0 / depth);
}

// The radius of an aperture that is given as photographers do.
//   stop         the number after f/, > 0
//   focalLength  half screen heights
//   halfFilm     half the height of the film, scene units: 0.012 for 24 x 36 mm if a unit is a metre
//   formula      focalLength halfFilm / (2 stop): an aperture f/N is as wide as the N-th part of the focal
//                length
float apertureRadius(float stop, float focalLength, float halfFilm)
{
    return 0.5 * focalLength * halfFilm / stop;
}
