// orthographic.glsl - the parallel view, and the transition to it from the perspective view.
#include "camera.glsl"

uniform float orthographic; // 1 in [0, 1] step 0.05: 0 the perspective view, 1 the orthographic one

// The ray of a parallel view: all rays have the camera's direction, and each starts at a different point of the
// camera's plane.
//   screen      y from -1 to 1, x from -aspect to aspect
//   halfHeight  half the height of the area that the picture shows, scene units, > 0
//   formula     origin = position + halfHeight (x right + y up), direction = forward
// The report (section 2.3) leaves halfHeight out, so its picture is always 2 scene units high, whatever the scene.
Ray orthographicRay(vec2 screen, float halfHeight)
{
    vec3 across = screen.x * iCameraRight + screen.y * iCameraUp;
    return Ray(iCameraPosition + halfHeight * across, iCameraForward);
}

// The ray of a view between the perspective and the parallel view: the perspective view of an eye that has moved
// back to framingDistance / (1 - u) while its focal length grew in proportion, u = orthographic. Points of the framing
// plane, perpendicular to the view at framingDistance from the camera, keep their positions in the picture.
//   screen           y from -1 to 1, x from -aspect to aspect
//   framingDistance  from the camera's plane to the framing plane along the view, scene units, > 0
//   formula          with v = x right + y up and s = framingDistance / focalLength
//                    origin = position + u s v, direction = normalize((1 - u) v + focalLength forward)
// All rays start on the camera's plane, so nothing behind this plane is in the picture. With u = 0 the ray is that of
// perspectiveRay, and with u = 1 that of orthographicRay with the half height s.
Ray projectionRay(vec2 screen, float framingDistance)
{
    vec3 across = screen.x * iCameraRight + screen.y * iCameraUp;
    float halfHeight = framingDistance / focalLength;
    vec3 origin = iCameraPosition + orthographic * halfHeight * across;
    return Ray(origin, normalize((1.0 - orthographic) * across + focalLength * iCameraForward));
}
