// Solution to exercise 19.1: the lines of a star chart, one for each hour of right ascension and
// one for each 15 degrees of declination.
#include "main.glsl"
#include "cone.glsl"
#include "night.glsl"
#include "coverage.glsl"

// The share of a pixel that is covered by lines at every 15 degrees of an angle. The distance of
// the angle from the nearest line is computed from its sine, because a driver's atan may be
// inexact.
//   along  cosine and sine of the angle, not both 0
//   width  of the pixel, radians
float lineAt(vec2 along, float width)
{
    float line = NIGHT_PI / 12.0 * round(atan(along.y, along.x) * 12.0 / NIGHT_PI);
    return coverage(0.5 - abs(along.y * cos(line) - along.x * sin(line)) / width, 1.0);
}

vec3 chartLight(vec3 direction)
{
    float width = 2.0 * pixelSpread(), level = length(direction.xy), across = max(level, 0.02);
    vec2 hour = level > 0.0 ? direction.xy / level : vec2(1.0, 0.0);
    float meridians = lineAt(hour, width / across), parallels = lineAt(vec2(level, direction.z), width);
    return milkyWay(direction) + max(meridians, parallels) * vec3(2e-7, 6e-7, 8e-7);
}

#define milkyWay chartLight
#include "19_moon_and_stars.frag"
