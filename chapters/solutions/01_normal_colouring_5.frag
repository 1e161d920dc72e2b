// Solution to exercise 01.5: a fisheye lens. The distance from the centre of the screen is
// proportional to the angle from the view direction.
//
// The chapter's pixelRay is renamed and not used; everything else is as in the chapter.
#include "main.glsl"
#define pixelRay chapterRay
#include "01_normal_colouring.frag"
#undef pixelRay

uniform float fieldOfView; // 180 in [10, 360] step 10, degrees: angle from the bottom of the picture to its top

Ray pixelRay(vec2 screen)
{
    float size = length(screen);
    float angle = 0.5 * radians(fieldOfView) * size;
    vec2 aside = size > 0.0 ? screen / size : vec2(0.0);
    vec3 direction = cos(angle) * iCameraForward +
                     sin(angle) * (aside.x * iCameraRight + aside.y * iCameraUp);
    return Ray(iCameraPosition, direction);
}
