// Solution to exercise 15.4: an aperture of four straight blades.
#include "main.glsl"
#define pixelRay chapterPixelRay
#include "15_the_picture.frag"
#undef pixelRay

Ray pixelRay(vec2 screen)
{
    Ray ray = perspectiveRay(filteredScreen(screen, kernel, jitter, 0));
    vec2 point = 2.0 * sampleSquare(2) - 1.0;
    return lensRay(ray, iSamples > 1 ? point : vec2(0.0), aperture, focus);
}
