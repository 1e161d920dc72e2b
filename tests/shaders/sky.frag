#version 330 core
// For test_sky.c: the sky's functions. Time chooses the function; x is the pixel's number.

in float Time;
out vec4 FragColor;

uniform vec4 iMouse;

#include "sky.glsl"

void main()
{
    float number = floor(gl_FragCoord.x) + 1024.0 * floor(gl_FragCoord.y);
    if (Time < 1.0) {
        float height = (number - 512.0) / 511.0; // sine, from just below -1 to 1
        vec3 through = transmittance(RAYLEIGH, airMass(height));
        FragColor = vec4(height, airMass(height), through.x, through.z);
    } else if (Time < 2.0) { // iMouse.x: haze
        float view = 1.0 + 37.0 * floor(gl_FragCoord.y) / 63.0;
        float sun = view + (number < 32768.0 ? 0.04 : 1.0) * 0.02 * (floor(gl_FragCoord.x) - 512.0);
        sun = clamp(sun, 1.0, 38.0);
        vec3 light = scatteredLight(RAYLEIGH + iMouse.x, view, sun);
        FragColor = vec4(view, sun, light.x, light.z);
    } else if (Time < 3.0) { // iMouse.xy: latitude, declination
        FragColor = vec4(sunDirection(number * 0.0234375, iMouse.x, iMouse.y), number * 0.0234375);
    } else if (Time < 4.0) {
        float angle = number * 0.003;
        vec3 away = vec3(sin(angle), 0.0, cos(angle));
        FragColor = vec4(glow(away, vec3(0.0, 0.0, 1.0), 0.8), disc(away, vec3(0.0, 0.0, 1.0), 0.5), angle, 0.0);
    } else { // iMouse.xy: hour, haze; 32 heights for each of 256 directions
        float turn = 0.0245 * floor(number / 32.0), height = mod(number, 32.0) / 31.0;
        vec3 direction = vec3(sqrt(1.0 - height * height) * vec2(cos(turn), sin(turn)), height).xzy;
        vec3 sun = sunDirection(iMouse.x, 43.6, 2.0);
        FragColor = vec4(sunlitSky(direction, sun, RAYLEIGH + iMouse.y) + nightSky(direction, sun), 0.0);
    }
}
