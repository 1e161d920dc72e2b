// Solution to exercise 15.5: a tilted plane in focus. Its distance differs from ray to ray.
#include "main.glsl"
#define pixelRay chapterPixelRay
#include "15_the_picture.frag"
#undef pixelRay

Ray pixelRay(vec2 screen)
{
    Ray ray = perspectiveRay(filteredScreen(screen, kernel, jitter, 0));
    vec3 normal = normalize(iCameraForward - iCameraRight);            // at 45 degrees to the view
    float t = focus * dot(iCameraForward, normal) / max(dot(ray.direction, normal), 0.01);
    return lensRay(ray, sampleDisc(2), aperture, t * dot(ray.direction, iCameraForward));
}
