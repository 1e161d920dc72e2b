// Solution to exercise 08.2: the oblique view. The rays are parallel, but not perpendicular to the
// picture's plane. Planes perpendicular to the axis keep their shapes, and depth is drawn along a
// slanting line.
#include "main.glsl"
#define pixelRay chapterPixelRay
#include "08_orthographic_view.frag"
#undef pixelRay

uniform float shortening; // 0.5 in [0, 1] step 0.1: length in the picture of a unit along the axis; 1 cavalier, 0.5 cabinet
uniform float slant;      // 45 in [0, 90] step 5, degrees: angle of that line to the horizontal

Ray pixelRay(vec2 screen)
{
    float angle = radians(slant);
    vec3 shift = shortening * (cos(angle) * iCameraRight + sin(angle) * iCameraUp);
    vec3 direction = iCameraForward - shift;
    Ray ray = orthographicRay(screen, framingDistance / focalLength);
    return Ray(ray.origin + framingDistance * shift, normalize(direction));
}
