// Experiment of chapter 07: the report's figures 6 and 8. One ball, or one frame with its ball, is
// repeated along one, two or three axes, up to 1000 times in each direction; the colour shows the
// normal.
#include "main.glsl"
#include "cone.glsl"     // perspectiveRay, pixelSpread
#include "crossing.glsl" // marchCrossing: ends at nearly the same point, whatever the steps are
#include "normal.glsl"
#include "primitives.glsl"
#include "lighting.glsl"
#include "repetition.glsl"

uniform int   axes;        // 3 in [1, 3]: 1 along z, 2 along z and x, 3 along z, x and y
uniform int   last;        // 1000 in [0, 1000]: only the cells from -last to last contain a copy
uniform bool  framed;      // false: a frame around every ball
uniform float period;      // 2.5 in [2, 10] step 0.25, scene units: width of a cell
uniform float fogDistance; // 14 in [4, 80] step 1, scene units: where 1/e of the light is left in the mist

const float FAR = 60.0;
const vec3  SKY = vec3(0.006, 0.016, 0.045);
const vec3  HORIZON = vec3(0.055, 0.11, 0.15);

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float sceneDistance(vec3 p)
{
    float end = float(last);
    p.z = opRepeatLimited(p.z, period, -end, end);
    p.x = axes > 1 ? opRepeatLimited(p.x, period, -end, end) : p.x;
    p.y = axes > 2 ? opRepeatLimited(p.y, period, -end, end) : p.y;
    float ball = sdSphere(p, 0.45);
    return framed ? min(ball, sdBoxFrame(p, vec3(0.8), 0.07)) : ball;
}

vec3 rayColour(Ray ray)
{
    Hit hit = marchCrossing(ray, 0.0, FAR, 0.001, pixelSpread(), 256);
    vec3 normal = normalAt(ray.origin + hit.t * ray.direction, 0.001 + pixelSpread() * hit.t);
    float clear = hit.found ? exp(-hit.t / fogDistance) : 0.0;
    vec3 sky = mix(HORIZON, SKY, smoothstep(-0.3, 0.6, ray.direction.y));
    vec3 colour = 0.5 * normal + 0.5;
    return encodeSRGB(mix(sky, colour * colour, clear));
}
