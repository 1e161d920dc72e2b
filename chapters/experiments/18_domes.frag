// The whole sky as one sees it lying on one's back: the zenith in the middle, the horizon at the rim, the sun's side below.
// sheet=true: twelve hours; else the chapter's way and another one side by side; with encoded=true that one as light and as
// numbers.
#include "main.glsl"
#define rayColour chapterRayColour
#include "18_sky_from_tables.frag"
#undef rayColour
#include "experiments/18_ways.glsl"

uniform bool  sheet;     // true: twelve hours, from noon to night; false: on the right the chosen way
uniform float sunHeight; // 48 in [-18, 90] step 1, degrees: of the sun, where it is no sheet

// The heights of the sun on the sheet, degrees: from the upper left to the lower right.
const float HEIGHTS[12] = float[](48.0, 30.0, 15.0, 8.0, 4.0, 1.0, -1.0, -2.5, -4.0, -5.5, -7.0, -9.0);

vec3 rayColour(Ray ray)
{
    vec2 place = vec2(iPixel) + 0.5, size = sheet ? iResolution.xy / vec2(4.0, 3.0) : iResolution.xy / vec2(2.0, 1.0);
    vec2 cell = floor(place / size), at = (place - size * (cell + 0.5)) / (0.48 * min(size.x, size.y));
    float height = radians(sheet ? HEIGHTS[int(cell.x + 4.0 * (2.0 - cell.y))] : sunHeight);
    vec3 sun = vec3(0.0, sin(height), -cos(height));
    // Equal angles are equal lengths: the rim is 90 degrees from the middle.
    float r = min(length(at), 1.0), angle = 1.57079633 * r;
    vec2 way2 = at / max(length(at), 1e-6);
    vec3 direction = vec3(way2.x * sin(angle), cos(angle), way2.y * sin(angle));
    bool left = cell.x < 0.5;
    vec3 sky = sheet || left && !encoded ? tableSky(sunward, away, direction, sun) : skyByWay(direction, sun, encoded && !left);
    sky += tableSun(halo, direction, sun, radians(sunRadius));
    return developed(sky, sun) * (1.0 - smoothstep(0.985, 1.0, length(at)));
}
