#version 330 core
// For night.c: the functions of night.glsl. Time selects the function; iMouse contains some of its arguments, and the
// pixel's coordinates determine the others.

in float Time;
out vec4 FragColor;

uniform vec4 iMouse;

#include "sky.glsl"
#include "night.glsl"

// The direction, in the stars' frame, of a pixel of a 128 x 128 picture. The centre of the picture is a fixed point of
// the sky, while the stars turn about the pole.
//   look  width of a pixel; the z coordinate of the fixed point, and its rotation; the rotation of the stars
vec3 patchDirection(vec4 look)
{
    vec2 screen = (gl_FragCoord.xy - 64.0) * look.x;
    vec3 ahead = vec3(sqrt(1.0 - look.y * look.y) * vec2(cos(look.z), sin(look.z)), look.y);
    vec3 right = normalize(cross(ahead, vec3(0.31, 0.17, 0.93))), up = cross(right, ahead);
    vec3 d = normalize(screen.x * right + screen.y * up + ahead);
    float c = cos(look.w), s = sin(look.w);
    return vec3(c * d.x + s * d.y, c * d.y - s * d.x, d.z);
}

void main()
{
    float number = floor(gl_FragCoord.x) + 1024.0 * floor(gl_FragCoord.y);
    if (Time < 1.0) { // iMouse: width, and how far from the pole the points reach: 2 for the whole sphere
        float z = 1.0 - iMouse.y * (number + 0.5) / 65536.0, turn = 6.2831853 * fract(number * 0.6180340);
        vec3 direction = vec3(sqrt(1.0 - z * z) * vec2(cos(turn), sin(turn)), z);
        FragColor = vec4(direction, 1e9 * starLight(direction, iMouse.x).g);
    } else if (Time < 2.0) {
        vec3 direction = patchDirection(iMouse);
        FragColor = vec4(direction, 1e9 * starLight(direction, iMouse.x).g);
    } else if (Time < 3.0) { // the same as for Time 1, in all colour channels
        FragColor = vec4(1e9 * starLight(patchDirection(iMouse), iMouse.x), 0.0);
    } else if (Time < 4.0) { // iMouse: latitude; one direction in the stars' frame, for hours from -12 to 36
        float hour = number * 48.0 / 1023.0 - 12.0;
        FragColor = vec4(skyTurn(hour, iMouse.x) * vec3(0.36, 0.48, 0.8), hour);
    } else if (Time < 5.0) { // iMouse: hour, latitude, declination; ages from -3 to 33
        float age = number * 36.0 / 1023.0 - 3.0;
        FragColor = vec4(moonDirection(iMouse.x, iMouse.y, iMouse.z, age), age);
    } else if (Time < 6.0) {
        // With iMouse.x > 0, the sun is as many degrees below the horizon as the index of the pixel. Otherwise the sine
        // of its height runs from -1 to 1.
        float height = iMouse.x > 0.0 ? -sin(radians(number)) : (number - 512.0) / 512.0;
        FragColor = vec4(height, 1e6 * zenithLight(height), faintestSeen(zenithLight(height)), 0.0);
    } else if (Time < 7.0) {
        float x = number / 511.5 - 1.0;
        FragColor = vec4(x, moonShare(x), 1e6 * moonlight(x).g, 1e6 * airglow(x).g);
    } else { // iMouse: hour, latitude, declination, age; which of 1024 x 1024 points are on the disc, and which are lit
        vec3 moon = moonDirection(iMouse.x, iMouse.y, iMouse.z, iMouse.w);
        vec3 toSun = moonFrame(moon, iMouse.y) * sunDirection(iMouse.x, iMouse.y, iMouse.z);
        vec2 point = gl_FragCoord.xy / 512.0 - 1.0;
        float rest = 1.0 - dot(point, point);
        bool lit = rest > 0.0 && dot(vec3(point, sqrt(max(rest, 0.0))), toSun) > 0.0;
        FragColor = vec4(rest > 0.0, lit, moonShare(toSun.z), toSun.z);
    }
}
