// For levels.c: the mean over the part of a picture that a pixel covers, as the levels give it. Each of the 32 x 32
// pixels reads the picture at a different point, which is the same in every run. iTime selects how the picture is read:
// with the footprint's two sides, at a level, or with footprintOn. iMouse contains the sides, in repeats of the
// picture, or the level (x, y), a factor of the footprint (z), and the sine of a ray's angle to the floor (w).
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
