// Solution to exercise 19.2: a moon that crosses the shadow of the Earth.
#include "main.glsl"
#include "night.glsl"

// The centre of the shadow lies opposite the sun; at the distance of the moon, the radius of the
// shadow is 2.65 radii of the moon.
vec3 eclipsedFace(sampler2D face, vec2 point, float width, vec3 toSun, float relief)
{
    vec3 light = moonFace(face, point, width, toSun, relief);
    vec2 middle = moonPoint(-toSun, radians(0.259));
    float lit = smoothstep(2.55, 2.75, length(point - middle));
    return light * mix(vec3(0.02, 0.005, 0.0025), vec3(1.0), lit);
}

#define moonFace eclipsedFace
#include "19_moon_and_stars.frag"
