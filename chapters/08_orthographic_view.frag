// 08 Orthographic view: parallel rays, and a waterfall that only they can see run.

#include "main.glsl"         // main(): asks for pixelRay, then for rayColour
#include "orthographic.glsl" // projectionRay
#include "march.glsl"        // march
#include "normal.glsl"       // normalAt
#include "lighting.glsl"     // lambert, encodeSRGB
#include "shadow.glsl"       // shadowRay, lightReaching
#include "bounds.glsl"       // boxInterval

uniform float framingDistance; // 9.5 in [1, 40] step 0.5, scene units: from the camera to the plane where nothing moves
uniform bool  shadows;         // true: ask whether the sun is in sight
uniform int   maxSteps;        // 128 in [1, 512]: steps before a ray is given up
uniform float hitThreshold;    // 0.001 in [0.0001, 0.2] step *2, scene units: distance that counts as a hit

const vec3 LOW = vec3(-1.3, -0.4, -4.8); // opposite corners of a box that holds the scene
const vec3 HIGH = vec3(6.3, 3.55, 2.8);

// Scene units. The middle of the plinth is the origin of the loop and of the frames.
const vec2  MIDDLE = vec2(2.5, -1.0); // x and z
const float PLINTH = 3.75;            // half its side
const vec2  LOOP = vec2(2.5, 2.0);    // half sides of the rectangle along which the channel runs
const float WALL = 0.5;               // half the channel's width, and the tower's
const float WATER = 0.32;             // half the water's width
const float TOP = 0.5;                // of the channel's walls, over the plinth
const float CLIMB = 3.0;              // of the tower over them
const float DEEP = 0.1;               // the water under the top of its walls
const float FRAME = 0.55;             // half a frame's side
const float BEAM = 0.15;              // thickness of its beams
const float CORNER = 3.15;            // the frames' place on the plinth's diagonal

const vec3 TO_SUN = vec3(-0.615, 0.755, 0.228); // length 1
const vec3 SUN_COLOUR = vec3(1.30, 0.95, 0.60);
const vec3 SKY_COLOUR = vec3(0.13, 0.17, 0.24);

Ray pixelRay(vec2 screen)
{
    return projectionRay(screen, framingDistance);
}

// How far p is aside of the channel's middle line, a rectangle: by the larger coordinate, not by the
// length, so that corners stay square.
float besideLoop(vec3 p)
{
    vec2 q = abs(p.xz - MIDDLE) - LOOP;
    return abs(max(q.x, q.y));
}

// Walls around a bed of water. From the third side on, behind the tower, there is no channel.
float channelDistance(vec3 p)
{
    float beside = besideLoop(p);
    float bed = max(beside - WATER, TOP - DEEP - p.y);
    float ends = min(2.5 - p.x, 0.5 - p.z);
    return max(max(beside - WALL, p.y - TOP), max(ends, -bed));
}

// The tower at the origin. On its top the water turns from the side of x to that of z.
float towerDistance(vec3 p)
{
    float bed = max(abs(min(p.x, p.z)) - WATER, TOP + CLIMB - DEEP - p.y);
    return max(max(abs(p.x), abs(p.z)) - WALL, max(p.y - TOP - CLIMB, -bed));
}

// Two equal frames, one the mirror image of the other in the plinth's other diagonal. A box frame is
// what is left of a cube where at most one coordinate is far from its face.
float frameDistance(vec3 p)
{
    vec2 q = p.xz - MIDDLE;
    vec3 a = abs(vec3(min(q.x, q.y) + CORNER, p.y - FRAME, max(q.x, q.y) - CORNER));
    float larger = max(a.x, a.y);
    float middle = max(min(a.x, a.y), min(larger, a.z));
    return max(max(larger, a.z) - FRAME, FRAME - BEAM - middle);
}

float sceneDistance(vec3 p)
{
    vec2 q = abs(p.xz - MIDDLE) - PLINTH;
    float plinth = max(max(q.x, q.y), p.y);
    float scene = min(min(plinth, channelDistance(p)), min(towerDistance(p), frameDistance(p)));
    return scene;
}

// Bright lines that the water carries along.
float foam(float along, float aside)
{
    float lane = floor(12.0 * aside);
    float line = fract(0.5 * along - 0.4 * iTime + 0.37 * lane * lane);
    return smoothstep(0.75, 0.9, line) * smoothstep(1.0, 0.9, line);
}

vec3 colourAt(vec3 p)
{
    vec2 q = p.xz - MIDDLE;
    bool tower = max(abs(p.x), abs(p.z)) < WALL + 0.02;
    bool falling = tower && p.z > WALL - 0.02;
    float beside = falling ? p.x : (tower ? abs(min(p.x, p.z)) : besideLoop(p));
    float along = falling ? -p.y : (tower ? -0.5 - p.x : (abs(q.x) - LOOP.x > abs(q.y) - LOOP.y ? -q.y : sign(q.y) * q.x));
    float surface = TOP - DEEP + (tower ? CLIMB : 0.0);
    bool water = abs(beside) < WATER && p.y < surface + 0.02 && (falling || p.y > surface - 0.02);
    vec3 tile = mod(floor(p.x) + floor(p.z), 2.0) > 0.5 ? vec3(0.70, 0.52, 0.42) : vec3(0.56, 0.36, 0.31);
    vec3 colour = p.y > 0.02 ? vec3(0.86, 0.78, 0.67) : tile;
    colour = water ? vec3(0.03, 0.26, 0.38) + 0.25 * foam(along, beside) : colour;
    return frameDistance(p) < 0.02 ? vec3(0.72, 0.20, 0.11) : colour;
}

float sunlight(vec3 p, vec3 normal)
{
    Ray ray = shadowRay(p, normal, TO_SUN, 20.0 * hitThreshold);
    bool asked = shadows && dot(normal, TO_SUN) > 0.0;
    float far = asked ? boxInterval(ray, LOW, HIGH).y : 0.0;
    return lambert(normal, TO_SUN) * lightReaching(ray, far, hitThreshold, maxSteps);
}

// A painting at the pixel's own place: parallel rays all see the same point of a sky.
vec3 backdrop()
{
    vec2 screen = screenPosition(gl_FragCoord.xy + iPixelOffset);
    vec3 air = mix(vec3(0.11, 0.21, 0.24), vec3(0.012, 0.04, 0.08), smoothstep(-1.0, 1.0, screen.y));
    return mix(vec3(0.85, 0.48, 0.22), air, smoothstep(0.285, 0.295, distance(screen, vec2(1.0, 0.45))));
}

vec3 rayColour(Ray ray)
{
    vec2 interval = boxInterval(ray, LOW, HIGH);
    Hit hit = march(ray, interval.x, interval.y, hitThreshold, maxSteps);
    vec3 light = backdrop();
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction;
        vec3 normal = normalAt(p, hitThreshold);
        vec3 sky = SKY_COLOUR * (0.7 + 0.3 * normal.y);
        light = colourAt(p) * (sky + SUN_COLOUR * sunlight(p, normal));
    }
    return encodeSRGB(light);
}
