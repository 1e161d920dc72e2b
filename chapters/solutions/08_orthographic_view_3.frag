// Solution to exercise 08.3: a fish-eye. The angle between the ray and the axis of the view is
// proportional to the distance from the centre of the picture, so even 180 degrees are possible.
#include "main.glsl"
#define pixelRay chapterPixelRay
#include "08_orthographic_view.frag"
#undef pixelRay

uniform float halfAngle; // 90 in [10, 180] step 5, degrees: angle at the picture's upper edge

Ray pixelRay(vec2 screen)
{
    float radius = length(screen);
    float angle = radians(halfAngle) * radius;
    vec3 across = (screen.x * iCameraRight + screen.y * iCameraUp) / max(radius, 0.000001);
    return Ray(iCameraPosition, cos(angle) * iCameraForward + sin(angle) * across);
}
