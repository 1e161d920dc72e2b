// Solution to exercise 08.2: the oblique view. The rays are parallel, but not perpendicular to the
// picture's plane. Planes parallel to the picture keep their shapes, and depth is drawn along
// slanting lines.
#include "main.glsl"
#define pixelRay chapterPixelRay
#include "08_orthographic_view.frag"
#undef pixelRay

uniform float shortening; // 0.5 in [0, 1] step 0.1: length in the picture of a unit of depth; 1 cavalier, 0.5 cabinet
uniform float slant;      // 45 in [0, 90] step 5, degrees: angle between the lines of depth and the horizontal

Ray pixelRay(vec2 screen)
{
    float angle = radians(slant);
    vec3 shift = shortening * (cos(angle) * iCameraRight + sin(angle) * iCameraUp);
    vec3 direction = iCameraForward - shift;
    Ray ray = orthographicRay(screen, framingDistance / focalLength);
    return Ray(ray.origin + framingDistance * shift, normalize(direction));
}
