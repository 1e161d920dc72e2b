#version 330 core
// For hue.c: the library's colours of a hue. Time selects the function; the pixel's coordinates
// give the index of the case.

in float Time;
out vec4 FragColor;

#include "hue.glsl"

void main()
{
    int number = int(gl_FragCoord.x) + 1024 * int(gl_FragCoord.y);
    if (Time < 1.0) {
        float hue = 0.1 * float(number); // the 3600 hues, and some more
        FragColor = vec4(hue, hueToRGB(hue));
    } else if (Time < 2.0) {
        float hue = 0.5 * float(number - 2048); // several turns, in both directions
        FragColor = vec4(hue, hueToRGB(hue));
    } else {
        float saturation = float(number / 720 % 3) / 2.0, value = float(number % 5) / 4.0;
        FragColor = vec4(hsvToRGB(0.5 * float(number % 720), saturation, value), 1.0);
    }
}
