#version 330 core
// For projection.c: the rays through a position on the screen in each of the three projections.
// Time selects the projection, and origins or directions; iMouse.x is the framing distance.

in float Time;
in vec2 FragCoord;
out vec4 FragColor;

#include "orthographic.glsl"

// Nothing here marches, but the library requires a scene.
float sceneDistance(vec3 p)
{
    return length(p);
}

void main()
{
    Ray ray = projectionRay(FragCoord, iMouse.x);
    if (Time >= 4.0)
        ray = orthographicRay(FragCoord, iMouse.x / focalLength);
    else if (Time >= 2.0)
        ray = perspectiveRay(FragCoord);
    FragColor = vec4(mod(Time, 2.0) < 1.0 ? ray.origin : ray.direction, 1.0);
}
