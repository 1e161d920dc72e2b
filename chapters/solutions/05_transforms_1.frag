// Solution to exercise 05.1: the ring turns about its own axis, once in 20 seconds. The new
// rotation is the rightmost factor, so it is applied first, before the ring is laid on the water.
#include "main.glsl"
#define pixelRay chapterPixelRay
#include "05_transforms.frag"
#undef pixelRay

uniform float turnTime; // 20 in [1, 120] step 1, seconds: one turn of the ring

Ray pixelRay(vec2 screen)
{
    Ray ray = chapterPixelRay(screen);
    now.ring.turn = now.ring.turn * rotationZ(radians(360.0 * iTime / turnTime));
    return ray;
}
