// Solution to exercise 08.1: perspective to the left of the middle, parallel rays to the right of
// it.
#include "main.glsl"
#define pixelRay chapterPixelRay
#include "08_orthographic_view.frag"
#undef pixelRay

Ray pixelRay(vec2 screen)
{
    if (screen.x < 0.0)
        return perspectiveRay(screen);
    return orthographicRay(screen, framingDistance / focalLength);
}
