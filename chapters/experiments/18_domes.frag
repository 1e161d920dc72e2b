// The whole sky as seen by somebody lying on the ground: the zenith at the centre, the horizon at the rim, and the
// sun's side at the bottom. With sheet=true, the sky is drawn for twelve heights of the sun. Otherwise it is drawn
// twice, side by side: by the chapter's method and by another method or, with encoded=true, by the other method as
// light and as encoded numbers.
#include "main.glsl"
#define rayColour chapterRayColour
#include "18_sky_from_tables.frag"
#undef rayColour
#include "experiments/18_ways.glsl"

uniform bool  sheet;     // true: twelve heights of the sun; false: two skies, the selected method on the right
uniform float sunHeight; // 48 in [-18, 90] step 1, degrees: height of the sun, with sheet=false

// The heights of the sun on the sheet, degrees, from the upper left to the lower right.
const float HEIGHTS[12] = float[](48.0, 30.0, 15.0, 8.0, 4.0, 1.0, -1.0, -2.5, -4.0, -5.5, -7.0, -9.0);

vec3 rayColour(Ray ray)
{
    vec2 pixel = vec2(iPixel) + 0.5, size = sheet ? iResolution.xy / vec2(4.0, 3.0) : iResolution.xy / vec2(2.0, 1.0);
    vec2 cell = floor(pixel / size), at = (pixel - size * (cell + 0.5)) / (0.48 * min(size.x, size.y));
    float height = radians(sheet ? HEIGHTS[int(cell.x + 4.0 * (2.0 - cell.y))] : sunHeight);
    vec3 sun = vec3(0.0, sin(height), -cos(height));
    // Equal angles become equal lengths: the rim is 90 degrees from the centre.
    float r = min(length(at), 1.0), angle = 1.57079633 * r;
    vec2 way2 = at / max(length(at), 1e-6);
    vec3 direction = vec3(way2.x * sin(angle), cos(angle), way2.y * sin(angle));
    bool left = cell.x < 0.5;
    vec3 sky = sheet || left && !encoded ? tableSky(sunward, away, direction, sun) : skyByWay(direction, sun, encoded && !left);
    sky += tableSun(halo, direction, sun, radians(sunRadius));
    return developed(sky, sun) * (1.0 - smoothstep(0.985, 1.0, length(at)));
}
