#version 330 core
// For gloss.c: highlights on a surface with the normal (0, 0, 1), for lights in all directions of the hemisphere.
//
// A pixel is a direction of light: its column is the rotation about the normal, its row the cosine of the angle to the
// normal. Time is the model; iMouse contains the cosine of the angle between the normal and the eye, the parameter, and
// the number of rows.

in float Time;
out vec4 FragColor;

uniform vec4 iMouse;

#include "gloss.glsl"

void main()
{
    float turn = 2.0 * GLOSS_PI * gl_FragCoord.x / 1024.0, c = gl_FragCoord.y / iMouse.z;
    vec3 toLight = vec3(sqrt(1.0 - c * c) * vec2(cos(turn), sin(turn)), c);
    vec3 toEye = vec3(sqrt(1.0 - iMouse.x * iMouse.x), 0.0, iMouse.x);
    vec3 normal = vec3(0.0, 0.0, 1.0);
    float gloss = Time < 0.5 ? ggxGloss(normal, toLight, toEye, iMouse.y)
                             : blinnPhongGloss(normal, toLight, toEye, iMouse.y);
    float behind = Time < 0.5 ? ggxGloss(normal, -toLight, toEye, iMouse.y) : 0.0;
    FragColor = vec4(gloss, behind, ggxDensity(c, iMouse.y * iMouse.y), halfway(toLight, toEye).z);
}
