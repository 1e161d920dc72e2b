// For levels.c: what a pixel sees of a picture that it covers a part of, by the picture's levels.
//
// A pixel of 32 x 32 asks at a place of its own, the same in every run. iTime chooses how it reads: by
// the footprint's two sides, by a level, by footprintOn. iMouse is the sides in repeats of the picture or
// the level (x, y), a factor of the footprint (z), the sine of the angle between a ray and the floor (w).
#include "main.glsl"
#include "camera.glsl"
#include "texture.glsl"

uniform sampler2D granite; // "granite.png" sRGB repeat: the picture

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float sceneDistance(vec3 p)
{
    return p.y;
}

vec3 rayColour(Ray ray)
{
    ivec2 k = ivec2(gl_FragCoord.xy);
    vec2 at = (vec2((167 * k.x + 59 * k.y) % 512, (101 * k.x + 211 * k.y) % 512) + 0.375) / 512.0;
    vec2 sides = iMouse.z * iMouse.xy;
    if (iTime < 1.0)
        return textureGrad(granite, at, vec2(sides.x, 0.0), vec2(0.0, sides.y)).rgb;
    if (iTime < 2.0)
        return textureLod(granite, at, iMouse.x).rgb;
    vec3 direction = vec3(0.0, -iMouse.w, sqrt(1.0 - iMouse.w * iMouse.w));
    Footprint f = footprintOn(direction, vec3(0.0, 1.0, 0.0), sides.x);
    return textureFromAbove(granite, vec3(at.x, 0.0, at.y), f).rgb;
}
