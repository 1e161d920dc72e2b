// Experiment of chapter 08: the report's orthographic view (section 2.3). A ray starts at the
// position of its pixel on the screen, camera + x e_x + y e_y, and follows e_z. There is no scale
// factor.
//
// A macro renames the chapter's pixelRay, which is not used; everything else is as in the chapter.
#include "main.glsl"
#define pixelRay chapterPixelRay
#include "08_orthographic_view.frag"
#undef pixelRay

uniform bool opposite; // false: e_z opposite to the view, as in section 1.3.1, instead of along it

Ray pixelRay(vec2 screen)
{
    vec3 ez = opposite ? -iCameraForward : iCameraForward;
    vec3 ex = normalize(cross(ez, vec3(0.0, 1.0, 0.0)));
    vec3 ey = cross(ex, ez);
    return Ray(iCameraPosition + screen.x * ex + screen.y * ey, ez);
}
