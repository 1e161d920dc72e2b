// For sky_table.c and `build/tests/measure sky`: the functions of sky_table.glsl, and the other methods of chapter 18's
// experiments. iTime selects the function, and iMouse.x is its argument. The output is clamped to [0, 1], so it
// contains the scaled logarithm of the result.
#include "main.glsl"
#define rayColour chapterRayColour
#include "18_sky_from_tables.frag"
#undef rayColour
#include "experiments/18_ways.glsl"

vec3 answer()
{
    vec2 k = floor(gl_FragCoord.xy), end = iResolution.xy - 1.0;
    float s = k.x / end.x, sine = -0.14 + 1.14 * s * s; // sine of the sun's height, from -8 degrees up
    vec3 sun = vec3(sqrt(1.0 - sine * sine), sine, 0.0);
    float y = k.y / end.y;
    y = min(y * y, 1.0);
    float level = sqrt(1.0 - y * y);
    vec3 direction = vec3(level * iMouse.x, y, level * sqrt(max(1.0 - iMouse.x * iMouse.x, 0.0)));
    if (iTime < 1.0)
        return skyByWay(direction, sun, encoded);
    if (iTime < 2.0)
        return tableSunlight(sun);
    if (iTime < 3.0)
        return tableAmbient(sun);
    if (iTime < 4.0) { // a sun from -17.5 degrees up, and a camera at the angle to it whose cosine is iMouse.x
        float y = -0.3 + 1.3 * s, read = meteredSky(meter, vec3(iMouse.x, 0.0, sqrt(1.0 - iMouse.x * iMouse.x)), vec3(sqrt(max(1.0 - y * y, 0.0)), y, 0.0));
        return vec3(read, exp2(adaptedStops(read)), exp2(skyBrightness(y)));
    }
    if (iTime < 5.0) { // 0 to 14 radii above the centre of a sun that is 20 degrees high; iMouse.x: radius
        vec3 at = vec3(cos(radians(20.0)), sin(radians(20.0)), 0.0);
        vec3 up = vec3(-at.y, at.x, 0.0);
        float x = 14.0 * s * s, angle = x * iMouse.x;
        return tableSun(halo, normalize(at * cos(angle) + up * sin(angle)), at, iMouse.x);
    }
    // The cosine plus 1, because the output cannot be negative, and the phase functions.
    float c = 2.0 * s - 1.0;
    return vec3(1.0 + c, phaseAir(c), phaseDust(c));
}

vec3 rayColour(Ray ray)
{
    return (log2(max(answer(), 0.0) + 1e-9) + 30.0) / 60.0;
}
