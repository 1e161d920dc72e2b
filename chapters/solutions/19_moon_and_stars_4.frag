// Solution to exercise 19.4: crystals of ice produce a ring around the moon.
#include "main.glsl"
#include "sky.glsl"

uniform float ring; // 0.2 in [0, 0.5] step 0.02: brightness of the ring, as a share of the light around the moon

// Two faces of a crystal form an angle of 60 degrees, and no ray through them is deflected by less
// than 2 asin(n / 2) - 60 degrees. The angle beyond this is computed from the sine of its half,
// because a driver's asin may be inexact.
vec3 ringedGlow(vec3 direction, vec3 moon, float g)
{
    float sine = 0.5 * min(distance(direction, moon), 2.0), cosine = sqrt(1.0 - sine * sine);
    vec3 s = 0.5 * vec3(1.307, 1.311, 1.317), c = sqrt(1.0 - s * s);
    vec3 leastSine = 0.8660254 * s - 0.5 * c, leastCosine = 0.8660254 * c + 0.5 * s; // asin(n / 2) - 30 degrees
    vec3 beyond = 2.0 * (sine * leastCosine - cosine * leastSine);
    vec3 edge = smoothstep(vec3(-radians(0.5)), vec3(0.0), beyond) * exp(-max(beyond, 0.0) / radians(4.0));
    return glow(direction, moon, g) + ring * edge;
}

#define glow ringedGlow
#include "19_moon_and_stars.frag"
