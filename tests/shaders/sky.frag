#version 330 core
// For sky.c: the functions of sky.glsl. Time selects the function; iMouse contains some of its
// arguments, and the pixel's coordinates determine the others.

in float Time;
out vec4 FragColor;

uniform vec4 iMouse;

#include "sky.glsl"

void main()
{
    float number = floor(gl_FragCoord.x) + 1024.0 * floor(gl_FragCoord.y);
    if (Time < 1.0) {
        float height = (number - 512.0) / 511.0; // sine of the height, from just below -1 to 1
        vec3 through = transmittance(RAYLEIGH, airMass(height));
        FragColor = vec4(height, airMass(height), through.x, through.z);
    } else if (Time < 2.0) { // iMouse: haze
        float view = 1.0 + 37.0 * floor(gl_FragCoord.y) / 63.0;
        float sun = view + (number < 32768.0 ? 0.04 : 1.0) * 0.02 * (floor(gl_FragCoord.x) - 512.0);
        sun = clamp(sun, 1.0, 38.0);
        vec3 light = scatteredLight(RAYLEIGH + iMouse.x, view, sun);
        FragColor = vec4(view, sun, light.x, light.z);
    } else if (Time < 3.0) { // iMouse: latitude, declination
        FragColor = vec4(sunDirection(number * 0.0234375, iMouse.x, iMouse.y), number * 0.0234375);
    } else if (Time < 4.0) { // iMouse: the sun's height, degrees; heights of the direction, to the right, and angles to the sun, upwards
        vec2 turn = radians(vec2(90.0, 180.0) / vec2(1023.0, 31.0)) * floor(gl_FragCoord.xy);
        vec3 sun = vec3(0.0, sin(radians(iMouse.x)), cos(radians(iMouse.x)));
        vec3 direction = vec3(cos(turn.x) * sin(turn.y), sin(turn.x), cos(turn.x) * cos(turn.y));
        FragColor = vec4(earthShadow(direction, sun), turn, 0.0);
    } else {
        float angle = number * 0.003;
        vec3 away = vec3(sin(angle), 0.0, cos(angle));
        FragColor = vec4(glow(away, vec3(0.0, 0.0, 1.0), 0.8), disc(away, vec3(0.0, 0.0, 1.0), 0.5), angle, 0.0);
    }
}
