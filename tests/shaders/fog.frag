#version 330 core
// For fog.c: the functions of fog.glsl. Time selects the function; iMouse contains some of its arguments, and the
// pixel's coordinates determine the others.

in float Time;
out vec4 FragColor;

uniform vec4 iMouse;

#include "fog.glsl"

void main()
{
    int function = int(Time);
    vec2 number = floor(gl_FragCoord.xy);
    FragColor = vec4(0.0);
    if (function == 0) {
        float x = number.x < 1.0 ? 0.0 : exp2((number.x - 400.0) / 20.0);
        FragColor = vec4(x, meanDecay(x), 0.0, 0.0);
    } else if (function == 1) { // iMouse: height, density, scale; climb from -1 to 1, often near 0
        float side = number.x < 32.0 ? -1.0 : 1.0, size = exp2(-mod(number.x, 32.0));
        float climb = number.x < 1.0 ? 0.0 : side * size, t = exp2(0.5 * number.y - 4.0);
        FragColor = vec4(climb, t, fogDepth(iMouse.x, climb, t, iMouse.y, iMouse.z), 0.0);
    } else if (function == 2) {
        float climb = exp2(-0.25 * number.x);
        FragColor = vec4(climb, skyFogDepth(iMouse.x, climb, iMouse.y, iMouse.z), 0.0, 0.0);
    } else if (function == 3) {
        float side = number.x < 32.0 ? -1.0 : 1.0, size = exp2(-0.5 * mod(number.x, 32.0));
        float climb = number.x < 1.0 ? 0.0 : side * size, t = 6.0;
        float depth = fogDepth(iMouse.x, climb, t, iMouse.y, iMouse.z) * number.y / 31.0;
        FragColor = vec4(climb, depth, inverseFogDepth(iMouse.x, climb, depth, iMouse.y, iMouse.z), 0.0);
    } else if (function == 4) { // iMouse: light, fog, density; along a horizontal ray
        float t = 0.05 * number.x;
        vec3 light = throughFog(vec3(iMouse.x), vec3(iMouse.y), fogDepth(0.3, 0.0, t, iMouse.z, 2.0));
        FragColor = vec4(t, light);
    } else if (function == 6) { // past a lamp; iMouse: start of the ray relative to the lamp, length of the ray
        float turn = 0.1 * number.x;
        vec3 direction = normalize(vec3(sin(turn), 0.2, cos(turn)));
        FragColor = vec4(direction, lampInFog(iMouse.xyz, direction, iMouse.w, 0.05));
    } else if (function == 7) { // across a beam along the x axis, x from its lamp; off in widths of the beam
        float x = 1.0 + number.x, width = 0.1 + 0.02 * x, off = 0.25 * number.y;
        FragColor = vec4(width, off, beamInFog(vec3(x, off * width, -5.0), vec3(0.0, 0.0, 1.0), vec3(1.0, 0.0, 0.0), vec2(0.1, 0.02), iMouse.x, iMouse.y), 0.0);
    } else { // above and below the horizon, from a height of 1.6; the sky's light is 9, the ground's 0
        float climb = 1e-4 * (number.x + 0.5);
        float above = skyFogDepth(1.6, climb, 0.02, 3.0), below = fogDepth(1.6, -climb, 1.6 / climb, 0.02, 3.0);
        vec3 fog = fogLight(vec3(0.0, 0.0, 1.0), vec3(0.0, 0.0, 1.0), vec3(0.25), vec3(0.5), 0.7);
        FragColor = vec4(climb, throughFog(vec3(9.0), fog, above).x, throughFog(vec3(0.0), fog, below).x, fog.x);
    }
}
