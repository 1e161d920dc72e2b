// 08 Orthographic view: a waterfall that seems to feed itself, as long as the rays are parallel.

#include "main.glsl"         // main(): calls pixelRay, then rayColour
#include "orthographic.glsl" // projectionRay
#include "march.glsl"        // march
#include "normal.glsl"       // normalAt
#include "lighting.glsl"     // lambert, encodeSRGB
#include "shadow.glsl"       // shadowRay, shadowReach, lightReaching
#include "bounds.glsl"       // boxInterval

uniform float framingDistance; // 9.5 in [1, 40] step 0.5, scene units: from the camera's plane to the plane that keeps its size
uniform int   maxSteps;        // 128 in [1, 512]: steps after which a ray is abandoned
uniform float hitThreshold;    // 0.001 in [0.0001, 0.016] step *2, scene units: distance that counts as a hit

const vec3  LOW = vec3(-1.3, -0.4, -4.8); // opposite corners of a box around the scene
const vec3  HIGH = vec3(6.3, 3.55, 2.8);  // the lower face of the box cuts off the objects, which have no undersides
const float SHADOW_OFFSET = 0.02;         // height above the surface at which a shadow ray starts

// The measurements of the scene, in scene units.
const vec2  MIDDLE = vec2(2.5, -1.0); // x and z of the plinth's centre
const float PLINTH = 3.75;            // half the side of the plinth
const vec2  LOOP = vec2(2.5, 2.0);    // half sides of the rectangle along which the channel runs
const float WALL = 0.5;               // half the width of the channel and of the tower
const float WATER = 0.32;             // half the width of the water
const float TOP = 0.5;                // height of the channel's walls above the plinth
const float CLIMB = 3.0;              // height of the tower above the channel's walls
const float DEEP = 0.1;               // depth of the water's surface below the top of the walls
const float FRAME = 0.55;             // half the side of a frame
const float BEAM = 0.15;              // thickness of a frame's beams
const float CORNER = 3.15;            // the frames are at MIDDLE + (-CORNER, CORNER) and MIDDLE + (CORNER, -CORNER)

const vec3 TO_SUN = vec3(-0.6149, 0.7549, 0.228); // direction to the sun, length 1
const vec3 SUN_COLOUR = vec3(1.30, 0.95, 0.60); // linear RGB
const vec3 SKY_COLOUR = vec3(0.13, 0.17, 0.24);

Ray pixelRay(vec2 screen)
{
    return projectionRay(screen, framingDistance);
}

// A lower bound of the distance to the channel's centre line, a rectangle. Like all distances in
// this scene, it takes the larger coordinate instead of the length, so it needs no square root.
float besideLoop(vec3 p)
{
    vec2 q = abs(p.xz - MIDDLE) - LOOP;
    return abs(max(q.x, q.y));
}

// The walls and the water of the channel, on two and a half sides of the rectangle.
float channelDistance(vec3 p)
{
    float beside = besideLoop(p);
    float bed = max(beside - WATER, TOP - DEEP - p.y);
    float open = min(2.5 - p.x, 0.5 - p.z);
    return max(max(beside - WALL, p.y - TOP), max(open, -bed));
}

// The tower above the origin. At its top, the water arrives from +x and leaves towards +z.
float towerDistance(vec3 p)
{
    float bed = max(abs(min(p.x, p.z)) - WATER, TOP + CLIMB - DEEP - p.y);
    return max(max(abs(p.x), abs(p.z)) - WALL, max(p.y - TOP - CLIMB, -bed));
}

// Two equal frames: min and max fold one onto the other, across the plinth's diagonal. A frame is
// the part of a cube where at least two of the three coordinates are near a face, so that the middle
// one in order of size is near a face.
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
    return min(min(plinth, channelDistance(p)), min(towerDistance(p), frameDistance(p)));
}

// Bright lines that the water carries along, in lanes that are 1/12 scene unit wide.
float foam(float along, float aside)
{
    float lane = floor(12.0 * aside);
    float line = fract(0.5 * along - 0.4 * iTime + 0.37 * lane * lane);
    return smoothstep(0.75, 0.9, line) * (1.0 - smoothstep(0.9, 1.0, line));
}

// The coordinate of p along its side of the channel: 0 in the middle of the side, and increasing
// downstream.
float streamAt(vec3 p)
{
    vec2 q = p.xz - MIDDLE;
    return abs(q.x) - LOOP.x > abs(q.y) - LOOP.y ? -q.y : sign(q.y) * q.x;
}

vec3 colourAt(vec3 p)
{
    bool tower = max(abs(p.x), abs(p.z)) < WALL + 0.02;
    bool falling = tower && p.z > WALL - 0.02;
    float beside = falling ? p.x : (tower ? abs(min(p.x, p.z)) : besideLoop(p));
    float along = falling ? -p.y : (tower ? -0.5 - p.x : streamAt(p));
    float level = p.y - TOP + DEEP - (tower ? CLIMB : 0.0);
    bool wet = abs(beside) < WATER && level < 0.02 && (falling || level > -0.02);
    vec3 water = vec3(0.03, 0.26, 0.38) + 0.25 * foam(along, beside);
    bool odd = mod(floor(p.x) + floor(p.z), 2.0) > 0.5;
    vec3 tile = odd ? vec3(0.70, 0.52, 0.42) : vec3(0.56, 0.36, 0.31);
    vec3 colour = wet ? water : (p.y > 0.02 ? vec3(0.86, 0.78, 0.67) : tile);
    return frameDistance(p) < 0.02 ? vec3(0.72, 0.20, 0.11) : colour;
}

// The share of the sun's light that a surface receives.
float sunlight(vec3 p, vec3 normal)
{
    Ray ray = shadowRay(p, normal, TO_SUN, SHADOW_OFFSET);
    float far = shadowReach(normal, TO_SUN, boxInterval(ray, LOW, HIGH).y);
    return lambert(normal, TO_SUN) * lightReaching(ray, far, hitThreshold, maxSteps);
}

// The background. All parallel rays would meet the same point of a sky, so the background is a
// painting that depends on the pixel's position.
vec3 backdrop()
{
    vec2 screen = screenPosition(gl_FragCoord.xy + iPixelOffset);
    vec3 air = mix(vec3(0.11, 0.21, 0.24), vec3(0.012, 0.04, 0.08), 0.5 + 0.5 * screen.y);
    float rim = smoothstep(0.285, 0.295, distance(screen, vec2(1.0, 0.45)));
    return mix(vec3(0.85, 0.48, 0.22), air, rim);
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
