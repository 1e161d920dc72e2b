// Solution of exercise 19.1: the lines of a star chart, each hour of right ascension and each 15 degrees of declination.
#include "main.glsl"
#include "cone.glsl"
#include "night.glsl"
#include "coverage.glsl"

// A line every whole number, 1 where the pixel is wholly covered; thin where its width is.
float lineAt(float x, float width)
{
    return coverage(0.5 * width - abs(x - round(x)), width);
}

vec3 chartLight(vec3 direction)
{
    float width = 2.0 * pixelSpread(), across = max(length(direction.xy), 0.02);
    float hour = atan(direction.y, direction.x) * 12.0 / NIGHT_PI, parallel = asin(direction.z) * 12.0 / NIGHT_PI;
    float meridians = lineAt(hour, width * 12.0 / NIGHT_PI / across), parallels = lineAt(parallel, width * 12.0 / NIGHT_PI);
    return milkyWay(direction) + max(meridians, parallels) * vec3(2e-7, 6e-7, 8e-7);
}

#define milkyWay chartLight
#include "19_moon_and_stars.frag"
