// Experiment of chapter 01: the sign of e_x in the report (sections 1.3.1 and 1.3.2), which mirrors
// the picture.
//
// The chapter's pixelRay is renamed and not used; everything else is as in the chapter.
#include "main.glsl"
#define pixelRay rightPixelRay
#include "01_normal_colouring.frag"
#undef pixelRay

// With e_z opposite to the view direction, the report takes e_x = normalize(e_z x (0, 1, 0)),
// e_y = e_x x e_z and direction = x e_x + y e_y - FL e_z. This e_x points to the left:
// det[e_x, e_y, e_z] = -1.
Ray pixelRay(vec2 screen)
{
    vec3 ez = -iCameraForward;
    vec3 ex = normalize(cross(ez, vec3(0.0, 1.0, 0.0)));
    vec3 ey = cross(ex, ez);
    return Ray(iCameraPosition, normalize(screen.x * ex + screen.y * ey - focalLength * ez));
}
