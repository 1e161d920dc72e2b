#version 330 core
// For film.c: the functions of film.glsl. Time selects the function; iMouse contains some of its arguments, and the
// pixel's coordinates determine the others.

in float Time;
out vec4 FragColor;

uniform vec4 iMouse;

#include "film.glsl"

void main()
{
    int function = int(Time);
    vec2 number = floor(gl_FragCoord.xy);
    FragColor = vec4(0.0);
    if (function == 0) { // iMouse: focal length
        vec2 screen = 0.1 * number - vec2(2.0, 1.0);
        FragColor = vec4(screen, cosineFourth(screen, iMouse.x), 0.0);
    } else if (function == 1) { // iMouse: amount
        float v = (number.x - 64.0) / 256.0;
        FragColor = vec4(v, contrast(vec3(v), iMouse.x).r, exposed(vec3(0.3), v).g, 0.0);
    } else if (function == 2) { // iMouse: gamma, white; sixteen values per stop
        float x = exp2((number.x - 192.0) / 16.0);
        FragColor = vec4(x, filmCurve(vec3(x), iMouse.x, iMouse.y).g, filmCurve(vec3(0.18), iMouse.x, iMouse.y).r,
                         filmCurve(vec3(-x), iMouse.x, iMouse.y).b);
    } else if (function == 3) { // an orange light of increasing strength; iMouse: gamma, white
        vec3 light = vec3(1.0, 0.4, 0.05) * exp2(0.25 * number.x - 6.0);
        FragColor = vec4(number.y < 1.0 ? filmOfLargest(light, iMouse.x, iMouse.y)
                                        : filmCurve(light, iMouse.x, iMouse.y), light.r);
    } else
        FragColor = vec4(ditherStep(ivec2(number) - 8), 0.0, 0.0, 0.0);
}
