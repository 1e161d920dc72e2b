// Solution to exercise 08.4: reversed perspective, with u greater than 1. The rays meet at a point
// in front of the camera, and farther objects are larger.
#include "main.glsl"
#define pixelRay chapterPixelRay
#include "08_orthographic_view.frag"
#undef pixelRay

uniform float beyond; // 1.3 in [1, 1.6] step 0.05: u, which is 0 for perspective rays and 1 for parallel rays

Ray pixelRay(vec2 screen)
{
    vec3 across = screen.x * iCameraRight + screen.y * iCameraUp;
    vec3 origin = iCameraPosition + beyond * framingDistance / focalLength * across;
    return Ray(origin, normalize((1.0 - beyond) * across + focalLength * iCameraForward));
}
