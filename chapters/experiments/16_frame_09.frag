// Experiment of chapter 16: a frame of chapter 09 in less time. The rays begin where the coarse
// pass ended. They are marched with marchCrossing, which ends where the distance to the city equals
// the threshold: at the same point, wherever the march began. The distance is that of city.glsl
// with fewer operations.
#include "main.glsl"
#include "cone.glsl"
#include "crossing.glsl"
#include "coarse.glsl"

Hit crossingFromCoarse(Ray ray, float tMin, float tMax, float threshold, float spread, int maxSteps)
{
    return marchCrossing(ray, max(tMin, coarseStart(ray)), tMax, threshold, spread, maxSteps);
}

#define marchCone crossingFromCoarse
#define sceneDistance chapterDistance
#include "09_sky_and_sunset.frag"
#undef sceneDistance
#undef marchCone

float coarseMargin(float t)
{
    return hitThreshold + 0.5 * footprint * pixelSpread() * t;
}

// cityDistance, written out: terms that its parts share are computed once, and a term that a
// tower's faces compute in the same way from x and from z is computed once, for the larger of the
// two.
float sceneDistance(vec3 p)
{
    vec2 cell = floor(p.xz * (1.0 / PERIOD) + 0.5);
    vec3 local = vec3(p.x - PERIOD * cell.x, p.y, p.z - PERIOD * cell.y), a = abs(local);
    float wide = max(a.x, a.z), up = local.y - 0.08;

    vec3 r = fract(cellRandom(ivec3(cell, 9)) * vec3(1.0, 256.0, 65536.0));
    vec3 corner = vec3(2.5, 4.0, 2.5) + floor(vec3(2.0 * r.y, 19.0 * r.x * r.x, 2.0 * r.z));
    float shaft = max(max(a.x - corner.x * BAY.x, a.z - corner.z * BAY.z), up - corner.y * BAY.y);
    float base = max(wide - 4.5 * BAY.x, up - floor(1.0 + 4.0 * r.z) * BAY.y);
    float wall = 0.5 * PERIOD - wide + GAP;

    float x = a.x - 2.1, square = local.z * local.z, over = local.y - 1.1; // x is measured from the lamp's foot
    float arm = x - clamp(x, 0.0, LAMP.x);
    vec3 bulb = vec3(x, local.yz) - LAMP;
    float post = sqrt(x * x + square + max(over, 0.0) * max(over, 0.0)) - 0.018;
    float lamp = min(sqrt(arm * arm + over * over + square) - 0.012, sqrt(dot(bulb, bulb)) - 0.045);

    // The squared horizontal distance from a tree's axis, and the height above or below the axis of
    // its crown.
    float across = x * x + (a.z - 1.5) * (a.z - 1.5), rise = local.y - clamp(local.y, 0.5, 1.0);
    float crown = 0.98 * (sqrt(across + rise * rise) - 0.3 + 0.2 * (local.y - rise));
    float trunk = max(sqrt(across) - 0.03, local.y - 0.6);
    return min(min(min(shaft, base), min(wall, post)), min(lamp, min(crown, trunk)));
}
