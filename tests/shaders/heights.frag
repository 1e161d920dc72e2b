// For texturing.c: heightOnSlide of a picture of heights, at the centre of a texel for each of 64 x 64 pixels. iTime is
// the axis, and the colour is the height; if iTime is 3 more than the axis, the colour is the gradient. iMouse.x is the
// reach in texels. A gradient of g per repeat of the picture is shown as 1/2 + g / 4096.
#include "main.glsl"
#include "camera.glsl"
#include "texture.glsl"

uniform sampler2D heights; // "cloth_height.png" linear repeat: the picture

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
    vec2 at = (vec2((167 * k.x + 59 * k.y) % 512, (101 * k.x + 211 * k.y) % 512) + 0.5) / 512.0;
    int axis = int(iTime) % 3;
    vec3 p = axis == 0 ? vec3(0.3, at.y, at.x) : (axis == 1 ? vec3(at.x, 0.3, at.y) : vec3(at, 0.3));
    Slide slide = slideAlong(p, Footprint(vec3(0.0), vec3(0.0)), axis);
    vec4 height = heightOnSlide(heights, slide, axis, iMouse.x / 512.0, iTime > 2.5);
    return iTime > 2.5 ? 0.5 + height.yzw / 4096.0 : vec3(height.x);
}
