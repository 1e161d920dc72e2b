// Solution of exercise 19.4: crystals of ice draw a ring round the moon.
#include "main.glsl"
#include "sky.glsl"

uniform float ring; // 0.2 in [0, 0.5] step 0.02: how bright the ring is, as a share of the light round the moon

// Two faces of a crystal stand at 60 degrees, and no ray is bent by less than 2 asin(n / 2) - 60 degrees.
vec3 ringedGlow(vec3 direction, vec3 moon, float g)
{
    float angle = 2.0 * asin(0.5 * min(distance(direction, moon), 2.0));
    vec3 least = 2.0 * asin(0.5 * vec3(1.307, 1.311, 1.317)) - radians(60.0), beyond = angle - least;
    vec3 edge = smoothstep(vec3(-radians(0.5)), vec3(0.0), beyond) * exp(-max(beyond, 0.0) / radians(4.0));
    return glow(direction, moon, g) + ring * edge;
}

#define glow ringedGlow
#include "19_moon_and_stars.frag"
