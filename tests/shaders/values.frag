#version 330 core
// For numeric.c: the library's functions of a number or of a position on the screen. Time selects
// the function; the pixel's coordinates determine its argument.

in float Time;
in vec2 FragCoord;
out vec4 FragColor;

#include "inputs.glsl"
#include "scene.glsl"
#include "bounds.glsl"
#include "camera.glsl"
#include "coverage.glsl"
#include "fresnel.glsl"
#include "lighting.glsl"
#include "ramp.glsl"

// Nothing here marches, but the library requires a scene.
float sceneDistance(vec3 p)
{
    return length(p);
}

void main()
{
    float number = floor(gl_FragCoord.x) + 1024.0 * floor(gl_FragCoord.y);
    FragColor = vec4(0.0);
    if (Time < 1.0) {
        // Linear light from below 0 to above 1, with dense samples around the knee of the curve.
        float light = number < 1024.0 ? number / 163840.0 : (number - 2048.0) / 8192.0;
        FragColor = vec4(light, encodeSRGB(vec3(light, 0.5, 2.0)));
    } else if (Time < 2.0) {
        FragColor = vec4(evenRamp(number / 1023.0), 1.0);
    } else if (Time < 3.0) {
        FragColor = vec4(perspectiveRay(FragCoord).direction, perspectiveRay(FragCoord).origin.x);
    } else if (Time < 4.0) {
        float angle = 0.006135923151542565 * number; // 1024 pixels are one turn
        vec3 toLight = vec3(sin(angle), cos(angle), 0.0);
        FragColor = vec4(angle, lambert(vec3(0.0, 1.0, 0.0), toLight), 0.0, 0.0);
    } else if (Time < 5.0) {
        float distance = 0.125 + 0.015625 * number;
        FragColor = vec4(distance, fallOff(distance, 6.0), 0.0, 0.0);
    } else if (Time < 6.0) {
        float facing = number / 1023.0;
        FragColor = vec4(facing, schlickShare(facing, 0.02), schlickShare(facing, 0.04), 0.0);
    } else if (Time < 7.0) {
        // The ends of two intervals are four digits of the number in base 5.
        vec4 ends = mod(floor(number / vec4(1.0, 5.0, 25.0, 125.0)), 5.0);
        FragColor = vec4(intervalUnion(ends.xy, ends.zw), 0.0, 0.0);
    } else {
        // Each row has a constant width, from 0 to 1.5, stripes of one of four widths, and positions in three periods.
        float row = floor(gl_FragCoord.y), x = mod(number, 1024.0) / 341.0 - 1.0, width = row / 10.0;
        FragColor = vec4(x, width, stripes(x, 0.025 + 0.25 * mod(row, 4.0), width), coverage(x, width));
    }
}
