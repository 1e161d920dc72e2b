// Experiment of chapter 14: a level floor beside four objects: a wall, a groove between two walls,
// a thin bar, and a ball that lies on the floor. In each field the point on the floor moves from
// left to right, and from bottom to top the object changes: the wall and the groove's walls get
// higher, the bar is raised, and the ball's radius grows. The rows show A, the openness in closed
// form; T, the estimate from five taps; and T - A, where blue is too dark and orange too light.
// Above each column the object is drawn in section.
#include "main.glsl"
#include "lighting.glsl"
#include "occlusion.glsl"
#include "plane.glsl"
#include "primitives.glsl"

uniform float reach;    // 1 in [0.1, 10] step *1.2, scene units: height of the last tap
uniform float strength; // 1 in [0, 2] step 0.05: how much a tap darkens

const float HALF_GROOVE = 0.6, BAR = 0.05;   // half the groove's width, the bar's radius, scene units
const vec2  MARGIN = vec2(0.24, 0.26), FIELD = (vec2(32.0 / 9.0, 2.0) - MARGIN) / vec2(4.0, 3.0); // sizes on the screen
const vec3  UP = vec3(0.0, 1.0, 0.0);
const vec3  INK = vec3(0.05, 0.06, 0.08);
const vec3  DARKER = vec3(0.03, 0.16, 0.50), LIGHTER = vec3(0.85, 0.32, 0.02);

int   thing; // 0 wall, 1 groove, 2 bar, 3 ball
float size;  // height of the walls or of the bar, or radius of the ball, scene units

Ray pixelRay(vec2 screen)
{
    return Ray(vec3(screen, 0.0), vec3(0.0, 0.0, -1.0));
}

// The distance to a wall on the left, whose foot is at x = 0. It is exact in front of the wall.
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

// The openness of the floor, in closed form.
float truth(float x)
{
    float left = openBeforeWall(HALF_GROOVE + x, size), right = openBeforeWall(HALF_GROOVE - x, size);
    // The share that the bar hides is the cosine of the angle between UP and the direction to the
    // bar, times the sine of half the angle that the bar subtends.
    float bar = 1.0 - BAR * size / (x * x + size * size);
    float ball = 1.0 - hiddenByBall(vec3(x, 0.0, 0.0), UP, size * UP, size);
    return thing == 0 ? openBeforeWall(x, size) : (thing == 1 ? left + right - 1.0 : (thing == 2 ? bar : ball));
}

// The letters of a row: A, T or T - A. Their centre is at 0, and they are 2 high.
float lettersDistance(vec2 q, int row)
{
    vec2 a = vec2(abs(q.x - (row == 2 ? 1.5 : 0.0)), q.y), t = vec2(abs(q.x + (row == 2 ? 1.5 : 0.0)), q.y);
    float letterA = min(sdSegment(a, vec2(0.0, 1.0), vec2(0.75, -1.0)), sdSegment(a, vec2(0.0, -0.3), vec2(0.5, -0.3)));
    float letterT = min(sdSegment(t, vec2(0.0, 1.0), vec2(0.75, 1.0)), sdSegment(t, vec2(0.0, 1.0), vec2(0.0, -1.0)));
    float minus = sdSegment(q, vec2(-0.35, 0.0), vec2(0.35, 0.0));
    return row == 0 ? letterA : (row == 1 ? letterT : min(min(letterA, letterT), minus));
}

vec3 rayColour(Ray ray)
{
    vec2 corner = vec2(ray.origin.x + 16.0 / 9.0, 1.0 - ray.origin.y) - MARGIN; // from the fields' upper left corner
    float column = corner.x / FIELD.x, row = corner.y / FIELD.y; // 4 columns and 3 rows
    float along = fract(column), grown = 1.0 - fract(row);
    thing = clamp(int(column), 0, 3);
    size = thing < 2 ? 0.05 + 1.5 * grown : (thing == 2 ? 0.1 + 0.9 * grown : 0.05 + 0.55 * grown);
    float x = thing == 0 ? 1.5 * along : (thing == 1 ? HALF_GROOVE : 1.2) * (2.0 * along - 1.0) * 0.999;
    float right = truth(x), quick = openByTaps(vec3(x, 0.0, 0.0), UP, reach, strength), off = quick - right;
    vec3 stone = mix(vec3(0.10, 0.11, 0.13), vec3(0.93, 0.90, 0.84), row < 1.0 ? right : quick);
    vec3 wrong = mix(vec3(0.9), off < 0.0 ? DARKER : LIGHTER, min(2.0 * abs(off), 1.0));
    vec2 edge = min(fract(vec2(column, row)), 1.0 - fract(vec2(column, row)));
    vec3 field = min(edge.x, edge.y) < 0.012 ? vec3(1.0) : (row < 2.0 ? stone : wrong);
    size = 0.24;
    float wide = thing == 0 ? 1.5 : (thing == 1 ? 2.0 * HALF_GROOVE : 2.4), scale = wide / FIELD.x;
    float section = sceneDistance(vec3(x, -scale * (corner.y + 0.05), 0.0)) / scale;
    float letters = 0.04 * lettersDistance(vec2(corner.x + 0.5 * MARGIN.x, (floor(row) + 0.5) * FIELD.y - corner.y) / 0.04, int(row));
    float drawn = corner.x < 0.0 ? letters : section;
    bool margin = corner.x < 0.0 || corner.y < 0.0, inked = max(corner.x, corner.y) > 0.0 && drawn < 0.008;
    return encodeSRGB(margin ? (inked ? INK : vec3(1.0)) : field);
}
