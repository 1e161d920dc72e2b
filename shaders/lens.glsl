// lens.glsl - a thin lens instead of a pinhole: only one distance is in focus.
#include "samples.glsl"
#include "soft_shadow.glsl"

// The point of this sample on a disc of radius 1. The samples of a pixel cover the disc evenly; a single sample
// lies at its centre.
//   dimension  as for sampleSquare
vec2 sampleDisc(int dimension)
{
    return iSamples > 1 ? discPoint(sampleSquare(dimension)) : vec2(0.0);
}

// The ray through a point of the lens that meets the ray through the lens's centre where the latter is in focus.
//   ray      through the centre of the lens, from perspectiveRay
//   point    point of the lens, in radii of the aperture: in the unit disc, from discPoint; (0, 0) returns ray
//   radius   of the aperture, scene units, >= 0
//   focus    distance of the plane in focus, along the view direction, scene units, > 0
//   formula  from A towards P, where P is the point of ray on the plane in focus and A the point of the lens. A thin
//            lens sends all light that it receives from P to one point of the film
Ray lensRay(Ray ray, vec2 point, float radius, float focus)
{
    vec3 inFocus = ray.direction * (focus / dot(ray.direction, iCameraForward));
    vec3 aside = radius * (point.x * iCameraRight + point.y * iCameraUp);
    return Ray(ray.origin + aside, normalize(inFocus - aside));
}

// How large a point becomes: the diameter of its circle of confusion on the screen, in half screen heights.
//   depth    of the point along the view direction, scene units, > 0
//   radius, focus  as for lensRay
//   focalLength    half screen heights, > 0
//   formula  2 radius focalLength |1 / focus - 1 / depth|, which is exact
float circleOfConfusion(float depth, float radius, float focus, float focalLength)
{
    return 2.0 * radius * focalLength * abs(1.0 / focus - 1.0 / depth);
}

// The radius of an aperture given as an f-number.
//   stop         the number after f/, > 0
//   focalLength  half screen heights
//   halfFilm     half the height of the film, scene units: 0.012 for 24 x 36 mm if a unit is a metre
//   formula      focalLength halfFilm / (2 stop): the diameter of an aperture f/N is the focal length divided
//                by N
float apertureRadius(float stop, float focalLength, float halfFilm)
{
    return 0.5 * focalLength * halfFilm / stop;
}
