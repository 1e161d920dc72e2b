// For sky.c: chapter 09's distance at pseudorandom points, and whether its sky is a valid colour. iTime selects the
// result: below 1, a point as a fraction of the sampled box; below 2, the distance there; below 3, the tree's distance
// at two points, and the distance between them; from 3 on, whether the sky is valid. All results are in [0, 1], so
// main() does not clamp them.
#include "main.glsl"
#define rayColour chapterRayColour
#include "09_sky_and_sunset.frag"
#undef rayColour
#include "random.glsl"

// True if every channel of the light is in [0, 1000), and thus finite.
bool isLight(vec3 light)
{
    return all(greaterThanEqual(light, vec3(0.0))) && all(lessThan(light, vec3(1000.0)));
}

vec3 rayColour(Ray ray)
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    seed = uint(pixel.x + 1024 * pixel.y) * 9781u + 17u;
    vec3 share = nextVector();
    vec3 p = vec3(24.0, 8.0, 24.0) * share + vec3(0.0, 8.0, 0.0);
    if (iTime < 1.0)
        return 0.5 + 0.5 * share;
    if (iTime < 2.0)
        return vec3(0.5 + sceneDistance(p) / 32.0);
    if (iTime < 3.0) {
        vec3 q = 1.5 * share + vec3(0.0, 0.8, 1.5), other = q + 0.1 * nextVector();
        return vec3(0.5 + treeDistance(q) / 16.0, 0.5 + treeDistance(other) / 16.0, distance(q, other));
    }
    vec3 direction = normalize(vec3(share.x, abs(share.y), share.z + 0.0001));
    vec3 sun = sunDirection(24.0 * float(pixel.y) / 256.0, LATITUDE, DECLINATION);
    return vec3(isLight(skyLight(direction, sun)), isLight(skyAmbient(sun, airDepth())),
                isLight(sunOrMoonLight(sun, airDepth())));
}
