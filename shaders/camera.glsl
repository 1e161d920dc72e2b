// camera.glsl - from a point on the screen to a ray: the perspective view.
#include "inputs.glsl"
#include "scene.glsl"

uniform float focalLength; // 2 in [0.3, 10] step *1.05, half screen heights: from the eye to the screen

// The ray from the eye through a point on the screen. The screen is perpendicular to the view direction,
// focalLength in front of the eye.
//   screen   y from -1 to 1, x from -aspect to aspect
//   formula  direction = normalize(x right + y up + focalLength forward)
// The report writes - FL e_z, with e_z opposite to the view, which mirrors the picture: see
// docs/01_normal_colouring.md.
Ray perspectiveRay(vec2 screen)
{
    vec3 direction = screen.x * iCameraRight + screen.y * iCameraUp + focalLength * iCameraForward;
    return Ray(iCameraPosition, normalize(direction));
}
