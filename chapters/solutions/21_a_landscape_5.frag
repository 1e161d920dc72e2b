// Solution to exercise 21.5: a steep island with its own bound.
#include "main.glsl"
#include "valley.glsl"

const vec2  ISLAND = vec2(7.0, 14.0); // right and ahead of the eye
const float ISLAND_SLOPE = 1.3;       // 1.54 * 4.2 / 5
const float ISLAND_RADIUS = 2.0;      // radius of the part above the water

// A hill on the bottom of the lake: height (x), gradient (yz).
vec3 island(vec2 q)
{
    return hill(q - ISLAND, vec2(5.0), 4.2) - vec3(3.0, 0.0, 0.0);
}

// The gap between p and the island closes no faster than the slope allows. Above the water, the
// island has no point outside the radius.
float islandDistance(vec3 p, int count)
{
    vec2 q = inValley(p.xz);
    float land = landDistance(p, count), gap = p.y - island(q).x;
    overLand = min(overLand, gap);
    return min(land, max(gap / (way.x + ISLAND_SLOPE * way.y), length(q - ISLAND) - ISLAND_RADIUS));
}

vec4 islandAt(vec2 q, float count)
{
    vec4 land = landAt(q, count);
    vec3 own = island(q);
    return own.x > land.x ? vec4(own, land.w) : land;
}

#define landDistance islandDistance
#define landAt islandAt
#include "21_a_landscape.frag"
