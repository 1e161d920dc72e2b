#version 330 core
// For occlusion.c: the functions of occlusion.glsl and thickness.glsl. Time selects the function; iMouse contains some
// of its arguments, and the pixel's coordinates determine the others.

in float Time;
out vec4 FragColor;

#include "combine.glsl"
#include "occlusion.glsl"
#include "primitives.glsl"
#include "thickness.glsl"

const vec3 UP = vec3(0.0, 1.0, 0.0);

int  scene; // 0 a floor, 1 a ball of radius 1, 2 a floor in front of a wall at x = 0, 3 a floor and a ball, 4 two balls
vec4 ball;

float sceneDistance(vec3 p)
{
    float wall = length(vec2(p.x, max(p.y - 0.4, 0.0)));
    float lying = sdSphere(p - ball.xyz, ball.w);
    float two = opUnion(sdSphere(p - vec3(0.6, 0.0, 0.0), 1.0), sdSphere(p + vec3(0.6, 0.0, 0.0), 1.0));
    float solid = scene == 1 ? length(p) - 1.0 : two;
    return scene == 0 ? p.y : (scene == 2 ? min(wall, p.y) : (scene == 3 ? min(lying, p.y) : solid));
}

void main()
{
    int function = int(Time);
    float number = floor(gl_FragCoord.x), row = floor(gl_FragCoord.y);
    iPixel = ivec2(gl_FragCoord.xy);
    FragColor = vec4(0.0);
    scene = int(iMouse.w);
    if (function == 0) {
        // A ball of radius iMouse.x at the distance iMouse.y, at all angles from the normal.
        float angle = PI * number / 64.0;
        vec3 centre = iMouse.y * vec3(0.6 * sin(angle), cos(angle), 0.8 * sin(angle));
        FragColor = vec4(centre, hiddenByBall(vec3(0.0), UP, centre, iMouse.x));
    } else if (function == 1) {
        vec3 normal = vec3(sin(0.1 * number), cos(0.1 * number), 0.0);
        FragColor = vec4(openBeforeWall(0.1 * number, iMouse.x), normal.xy, openOverGround(normal));
    } else if (function == 2) {
        vec3 direction = cosineDirection(iMouse.xyz, (vec2(number, row) + 0.5) / 256.0);
        FragColor = vec4(direction, dot(direction, iMouse.xyz));
    } else if (function == 3) {
        // iMouse.z x iMouse.z rays, with different random numbers in every pixel, from a point at the distance iMouse.x
        // from the foot of a ball of radius iMouse.y.
        ball = vec4(0.0, iMouse.y, 0.0, iMouse.y);
        FragColor = vec4(skyReaching(vec3(iMouse.x, 0.0, 0.0), UP, 1e-4, 50.0, int(iMouse.z), 1e-5, 400, 0));
    } else if (function == 4) {
        // Taps at points of the floor or of the ball; iMouse: reach, strength.
        float turn = 0.1 * number;
        vec3 normal = scene == 1 ? vec3(cos(turn), 0.0, sin(turn)) : UP;
        vec3 tapped = scene == 1 ? normal : vec3(0.02 + 0.05 * number, 0.0, 0.3 * number);
        FragColor = vec4(tapped.x, openByTaps(tapped, normal, iMouse.x, iMouse.y), tapHeight(0, iMouse.x), tapHeight(4, iMouse.x));
    } else if (function == 5) {
        FragColor = vec4(skyAndBounces(number / 255.0, iMouse.xyz, int(iMouse.w)), number / 255.0);
    } else if (function == 6) {
        // Paths inside from a point near the surface, in a fan of directions in x and z; iMouse: x and z of the point,
        // largest length.
        float turn = 0.05 * number;
        Ray ray = Ray(vec3(iMouse.x, 0.0, iMouse.y), vec3(cos(turn), 0.0, sin(turn)));
        FragColor = vec4(ray.direction.xz, thicknessAlong(ray, iMouse.z, 1e-5, 400), 0.0);
    } else {
        FragColor = vec4(lightThrough(0.01 * number, iMouse.xyz), 0.01 * number);
    }
}
