#version 330 core
// For soft_shadow.c: the functions of soft_shadow.glsl. Time selects the function; iMouse contains
// some of its arguments, and the pixel's coordinates determine the others.

in float Time;
out vec4 FragColor;

#include "soft_shadow.glsl"
#include "primitives.glsl"

// The centre and the radius of the ball in front of the lamp.
vec4 ball;

float sceneDistance(vec3 p)
{
    return sdSphere(p - ball.xyz, ball.w);
}

const vec3 TO_LIGHT = vec3(0.48, 0.6, -0.64);
const vec3 P = vec3(0.4, -0.3, 0.2); // the point that sees the lamp; ball and edge are relative to it

// A ball whose outline passes the lamp's centre at a distance of `clear`, in radii of the lamp.
//   iMouse: spread; radius and distance of the ball
vec4 ballAt(float clear)
{
    vec3 aside = normalize(cross(TO_LIGHT, vec3(1.0, 0.0, 0.0)));
    float angle = asin(iMouse.y / iMouse.z) + atan(clear * iMouse.x);
    return vec4(iMouse.z * (cos(angle) * TO_LIGHT + sin(angle) * aside), iMouse.y);
}

void main()
{
    int function = int(Time);
    float number = floor(gl_FragCoord.x);
    iPixel = ivec2(gl_FragCoord.xy);
    FragColor = vec4(0.0);
    if (function == 0) {
        float clear = (number - 640.0) / 512.0;
        FragColor = vec4(clear, discBesideEdge(clear), 0.0, 0.0);
    } else if (function == 1) {
        float clear = max(-1.25, -iMouse.x) + 2.6 * number / 512.0;
        FragColor = vec4(clear, discBesideDisc(clear, iMouse.x), 0.0, 0.0);
    } else if (function == 2) {
        float clear = (number - 32.0) / 24.0;
        ball = ballAt(clear);
        FragColor = vec4(ball.xyz, lampBesideBall(P, TO_LIGHT, iMouse.x, P + ball.xyz, ball.w));
    } else if (function == 3) {
        // A slanting edge at a distance of 3 that passes the lamp's centre at a distance of
        // iMouse.y, in radii of the lamp.
        vec3 aside = normalize(cross(TO_LIGHT, vec3(0.0, 1.0, 0.0)));
        vec3 across = cross(TO_LIGHT, aside);
        vec3 onEdge = 3.0 * (TO_LIGHT - iMouse.y * iMouse.x * aside) + 0.7 * across;
        vec3 along = across + (0.1 * number - 1.5) * (TO_LIGHT - iMouse.y * iMouse.x * aside);
        FragColor = vec4(along, lampBesideEdge(P, TO_LIGHT, iMouse.x, P + onEdge, along));
    } else if (function == 4) {
        vec2 square = vec2(number, floor(gl_FragCoord.y)) / 255.0;
        FragColor = vec4(square, discPoint(square));
    } else if (function == 5) {
        float turn = 0.1 * number, height = sin(7.0 * number);
        vec3 toLight = vec3(sqrt(1.0 - height * height) * vec2(cos(turn), sin(turn)), height).xzy;
        if (number < 6.0) { // along a coordinate axis, in both directions
            toLight = vec3(0.0);
            toLight[int(number) % 3] = number < 3.0 ? 1.0 : -1.0;
        }
        vec2 point = discPoint(vec2(0.25, fract(0.37 * number)));
        vec3 direction = lampDirection(toLight, iMouse.x, point);
        FragColor = vec4(length(direction), dot(direction, toLight), length(cross(direction, toLight)), 0.0);
    } else if (function == 6) {
        // iMouse.w x iMouse.w rays, with different random numbers in every pixel.
        ball = ballAt(0.3);
        Ray ray = Ray(vec3(0.0), TO_LIGHT);
        FragColor = vec4(lampReaching(ray, 9.0, iMouse.x, int(iMouse.w), 1e-5, 256, 0), ball.xyz);
    } else {
        // Both bounds of clearanceAlong, from different starts; the ball's position along the ray and beside it.
        ball = ballAt(0.02 + 0.02 * number);
        Ray ray = Ray(vec3(0.0), TO_LIGHT);
        float start = 0.05 + 0.01 * floor(gl_FragCoord.y), along = dot(ball.xyz, TO_LIGHT);
        Clearance clearance = clearanceAlong(ray, start, 9.0, 1e-5, 256);
        FragColor = vec4(clearance.most, clearance.least, along, length(ball.xyz - along * TO_LIGHT));
    }
}
