// checkers.glsl - squares in two colours, averaged over the footprint of a pixel.
#include "inputs.glsl"

// The smallest rectangle, with its sides along the pattern's axes, that contains the footprint of a pixel on a plane.
struct Footprint {
    vec2 middle; // centre of the rectangle, in units of the pattern
    vec2 width;  // sides of the rectangle, > 0
};

// The footprint of a pixel on the plane through a point, found from the intersections of the plane with the rays
// through the four corners of the pixel. It is exact if the surface is a plane.
//   p          point of the plane seen in the middle of the pixel, scene units
//   direction  of the ray through that middle, length 1
//   normal     of the plane, length 1
//   halfPixel  half the side of the pixel at p, perpendicular to the view direction, scene units, > 0
//   bend       how much the direction changes from p to a point beside p, per scene unit: 1 / distance
//              from the eye for rays that meet at the eye, 0 for parallel rays
//   axes       the pattern's two axes in the plane, each of length 1 / (scene units per unit of the pattern); a point
//              has the pattern coordinates p * axes
//   formula    corner = p + e - d dot(normal, e) / dot(normal, d), where e = halfPixel (+-right +-up) leads from p
//              to a corner of the pixel, and d = direction + bend e
// If the ray through a corner passes above the horizon, there is no rectangle: the width is 1e6, and the pattern
// becomes its mean.
Footprint planeFootprint(vec3 p, vec3 direction, vec3 normal, float halfPixel, float bend, mat2x3 axes)
{
    vec2 right = halfPixel * (iCameraRight * axes), up = halfPixel * (iCameraUp * axes), along = direction * axes;
    float rightRise = halfPixel * dot(normal, iCameraRight), upRise = halfPixel * dot(normal, iCameraUp);
    float down = dot(normal, direction), least = 1.0;
    vec2 low = vec2(1e6), high = vec2(-1e6);
    for (int i = 0; i < 4; i++) {
        float x = i % 2 == 0 ? -1.0 : 1.0, y = i < 2 ? -1.0 : 1.0;
        vec2 e = x * right + y * up;
        float rise = x * rightRise + y * upRise, falls = down + bend * rise;
        vec2 corner = e - (along + bend * e) * (rise / falls);
        least = min(least, falls / down);
        low = min(low, corner);
        high = max(high, corner);
    }
    bool whole = least > 0.0;
    return Footprint(p * axes + (whole ? 0.5 * (low + high) : vec2(0.0)), whole ? max(high - low, 1e-4) : vec2(1e6));
}

// The share of a rectangle that squares of the first colour cover. These are the squares with an even
// floor(x) + floor(y).
//   middle, width  the rectangle, in sides of a square; widths > 0, not much less than 1e-4 of |middle|,
//                  because a float cannot represent the position more precisely
//   formula  1/2 + 1/2 X Y, where X is the mean of s(x), which is 1 where floor(x) is even and -1 elsewhere:
//            X = (S(x + w/2) - S(x - w/2)) / w, S(x) = 1 - |mod(x, 2) - 1| the integral of s; Y likewise. This is
//            exact: over a rectangle, the mean of a product of functions of x and of y is the product of their means
// Source: I. Quilez, 'Box-filtering of procedural patterns', in the form of the workshop's checkers.
float checkers(vec2 middle, vec2 width)
{
    vec2 after = abs(mod(middle + 0.5 * width, 2.0) - 1.0);
    vec2 before = abs(mod(middle - 0.5 * width, 2.0) - 1.0);
    vec2 mean = (before - after) / width;
    return 0.5 + 0.5 * mean.x * mean.y;
}
