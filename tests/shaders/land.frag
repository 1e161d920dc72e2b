#version 330 core
// For land.c: functions of land.glsl and water.glsl. Time selects the function; iMouse contains some of its arguments,
// and the pixel's coordinates determine the others.

in float Time;
out vec4 FragColor;

uniform vec4 iMouse;

#include "land.glsl"
#include "water.glsl"

float sceneDistance(vec3 p)
{
    return p.y;
}

void main()
{
    int function = int(Time);
    vec2 number = floor(gl_FragCoord.xy);
    FragColor = vec4(0.0);
    if (function == 0) { // noise and its gradient, at points that floats represent exactly
        FragColor = vec4(groundNoise(iMouse.xy + vec2(number) / 16.0), 0.0);
    } else if (function == 1) {
        FragColor = vec4(ridged(groundNoise(iMouse.xy + vec2(number) / 16.0)), 0.0);
    } else if (function == 2) { // iMouse: radii, height
        FragColor = vec4(hill(number / 16.0 - 4.0, iMouse.xy, iMouse.z), 0.0);
    } else if (function == 3) { // gap, slope and wayToClose; iMouse: growth, 1 for gaps below the ground
        vec3 v = vec3((1.0 - 2.0 * iMouse.y) * exp2(0.25 * number.x - 8.0), exp2(0.5 * number.y - 3.0), iMouse.x);
        FragColor = vec4(v.x, v.y, wayToClose(v.x, v.y, v.z), 0.0);
    } else if (function == 4) { // four waves at one point; iMouse: x and z of the footprint's two axes
        Footprint f = Footprint(vec3(iMouse.x, 0.0, iMouse.y), vec3(iMouse.z, 0.0, iMouse.w));
        vec2 p = number / 8.0;
        Water w = fourWaves(p, f, vec4(1.0, -2.0, 3.0, 0.5), vec4(0.5, 1.5, -1.0, 2.0), vec4(0.1, 0.2, 0.05, 0.15), vec4(0.0, 1.0, 2.0, 3.0));
        FragColor = vec4(w.slope, w.variance, 0.0);
    } else { // iMouse: sine of the light's height, azimuth, variance; the eye's azimuth grows with x, its height with y
        float turn = 6.2831853 * (number.x + 0.5) / 256.0, up = (number.y + 0.5) / 256.0;
        vec3 eye = vec3(sqrt(1.0 - up * up) * vec2(cos(turn), sin(turn)), up).xzy;
        vec3 toLight = vec3(sqrt(1.0 - iMouse.x * iMouse.x) * vec2(cos(iMouse.y), sin(iMouse.y)), iMouse.x).xzy;
        FragColor = vec4(glitter(-eye, toLight, Water(vec2(0.0), iMouse.z), vec3(1.0)), up);
    }
}
