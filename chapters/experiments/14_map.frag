// Experiment of chapter 14: a level floor beside four things: a wall, a groove between two walls, a thin bar, a ball that
// lies on it. In each field the floor's point moves from left to right, and from bottom to top the thing grows: the wall and
// the groove's walls in height, the bar upwards, the ball in radius. The rows: the share of the sky that is seen, in closed
// form; five taps; what is wrong with these: blue too dark, orange too light.
#include "main.glsl"
#include "lighting.glsl"
#include "occlusion.glsl"
#include "primitives.glsl"

uniform float reach;    // 1 in [0.1, 10] step *1.2, scene units: height of the last tap
uniform float strength; // 1 in [0, 2] step 0.05: how much a tap takes

const float HALF_GROOVE = 0.6, BAR = 0.05;   // half the groove's width, the bar's radius, scene units
const vec3  UP = vec3(0.0, 1.0, 0.0);
const vec3  DARKER = vec3(0.03, 0.16, 0.50), LIGHTER = vec3(0.85, 0.32, 0.02);

int   thing; // 0 wall, 1 groove, 2 bar, 3 ball
float size;  // of it, scene units

Ray pixelRay(vec2 screen)
{
    return Ray(vec3(screen, 0.0), vec3(0.0, 0.0, -1.0));
}

// A wall whose foot is at x = 0, to the left; exact in front of it.
float wallDistance(float x, float y)
{
    return length(vec2(x, max(y - size, 0.0)));
}

float sceneDistance(vec3 p)
{
    float groove = wallDistance(HALF_GROOVE - abs(p.x), p.y), bar = length(p.xy - size * UP.xy) - BAR;
    float hollow = thing == 0 ? wallDistance(p.x, p.y) : groove;
    float solid = thing == 2 ? bar : sdSphere(p - size * UP, size);
    return min(thing < 2 ? hollow : solid, p.y);
}

// The share of the sky that is seen from the floor, in closed form.
float truth(float x)
{
    float left = openBeforeWall(HALF_GROOVE + x, size), right = openBeforeWall(HALF_GROOVE - x, size);
    float bar = 1.0 - BAR * size / (x * x + size * size); // cosine of its angle, times the sine of half its width
    float ball = 1.0 - hiddenByBall(vec3(x, 0.0, 0.0), UP, size * UP, size);
    return thing == 0 ? openBeforeWall(x, size) : (thing == 1 ? left + right - 1.0 : (thing == 2 ? bar : ball));
}

vec3 rayColour(Ray ray)
{
    float column = (ray.origin.x + 16.0 / 9.0) * 9.0 / 8.0, row = 1.5 * (1.0 - ray.origin.y); // 4 and 3 of them
    float along = fract(column), grown = 1.0 - fract(row);
    thing = clamp(int(column), 0, 3);
    size = thing < 2 ? 0.05 + 1.5 * grown : (thing == 2 ? 0.1 + 0.9 * grown : 0.05 + 0.55 * grown);
    float x = thing == 0 ? 1.5 * along : (thing == 1 ? HALF_GROOVE : 1.2) * (2.0 * along - 1.0) * 0.999;
    float right = truth(x), quick = openByTaps(vec3(x, 0.0, 0.0), UP, reach, strength), off = quick - right;
    vec3 stone = mix(vec3(0.10, 0.11, 0.13), vec3(0.93, 0.90, 0.84), row < 1.0 ? right : quick);
    vec3 wrong = mix(vec3(0.9), off < 0.0 ? DARKER : LIGHTER, min(2.0 * abs(off), 1.0));
    vec2 edge = min(fract(vec2(column, row)), 1.0 - fract(vec2(column, row)));
    return encodeSRGB(min(edge.x, edge.y) < 0.012 ? vec3(1.0) : (row < 2.0 ? stone : wrong));
}
