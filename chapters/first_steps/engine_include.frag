#version 330 core
// For exercise 4 of docs/engine.md: a scene whose distances come from a file of the course.
#include "../../shaders/primitives.glsl"

in vec2 FragCoord;
uniform vec3 CamPos, Ex, Ey, Ez;
uniform float focal = 1.5;
out vec4 FragColor;

float sceneDistance(vec3 p)
{
    return min(p.y, sdBoxFrame(p - vec3(0.0, 0.7, 0.0), vec3(0.7), 0.08));
}

void main()
{
    vec3 direction = normalize(FragCoord.x * Ex + FragCoord.y * Ey + focal * Ez);
    float t = 0.0, d = 1.0;
    for (int i = 0; i < 200 && d > 0.001 && t < 20.0; i++) {
        d = sceneDistance(CamPos + t * direction);
        t += d;
    }
    FragColor = vec4(vec3(0.9, 0.7, 0.4) * exp(-0.25 * t), 1.0);
}
