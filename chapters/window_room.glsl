// window_room.glsl - a room with one window, the scene of chapter 24: its walls, the things on the table, and their
// colours. The light is in the chapter.
//
// x points to the right, y upwards, z towards the eye; one scene unit is a metre. The room is a box, and the window a
// deep hole in its left wall, so the point where a ray meets them is computed in closed form. A march finds the table
// with its cloth and everything on it: sceneDistance contains nothing else.
#include "bounds.glsl"
#include "combine.glsl"
#include "march.glsl"
#include "normal.glsl"
#include "primitives.glsl"
#include "symmetry.glsl"

const vec3  ROOM_AT = vec3(0.0, 1.3, 0.8), ROOM = vec3(1.9, 1.3, 2.4); // the room: its middle and half its size
const vec3  WINDOW_AT = vec3(-2.13, 1.66, -0.45), WINDOW = vec3(0.23, 0.66, 0.62); // the hole in the left wall
const float OUTSIDE = -2.36;     // x of the outer end of the window
const float ROOM_FAR = 14.0;     // longer than any path through the room
const vec3  THINGS_LOW = vec3(-0.30, 0.0, -1.48), THINGS_HIGH = vec3(1.88, 1.20, -0.40); // a box around table and things
const vec3  TABLE_AT = vec3(0.80, 0.74, -0.94); // middle of the table's top
const vec2  TABLE = vec2(0.95, 0.40);        // half of its size
const float CLOTH = 0.758;       // height of the cloth on the table

const vec3  LIME = vec3(0.86, 0.84, 0.80), CORAL = vec3(0.80, 0.24, 0.15); // shares of reflected light, linear RGB
const vec3  BLUE = vec3(0.10, 0.21, 0.54), WOOD = vec3(0.40, 0.25, 0.14);
const vec3  WHITE = vec3(0.86, 0.83, 0.77), YELLOW = vec3(0.90, 0.66, 0.07), GREEN = vec3(0.13, 0.38, 0.34);
const vec3  TILE_RED = vec3(0.52, 0.23, 0.13), TILE_PALE = vec3(0.70, 0.60, 0.48);

// ---- The walls ----

// Where a ray ends, if it meets nothing on the table.
struct Wall {
    float t;      // along the ray, scene units; ROOM_FAR if the ray leaves through the window
    vec3  normal; // towards the ray's origin
};

// Where a ray leaves a box in which it begins. No component of its direction may be 0.
Wall boxLeft(Ray ray, vec3 centre, vec3 halfSize)
{
    vec3 onward = sign(ray.direction);
    vec3 t = (centre + onward * halfSize - ray.origin) / ray.direction;
    float first = min(t.x, min(t.y, t.z));
    return Wall(first, -onward * vec3(first == t.x, first == t.y && first != t.x, first == t.z && first != t.x && first != t.y));
}

// Does a ray in the room, or in the window, cross the window's inner end?
bool inWindow(vec2 yz)
{
    vec2 off = abs(yz - WINDOW_AT.yz);
    return off.x < WINDOW.y && off.y < WINDOW.z;
}

// Where a ray meets the two bars of the window, or ROOM_FAR.
Wall barsReached(Ray ray)
{
    Wall bars = Wall(ROOM_FAR, vec3(1.0, 0.0, 0.0));
    for (int i = 0; i < 2; i++) {
        vec3 centre = vec3(-2.26, WINDOW_AT.yz + (i == 0 ? vec2(0.0) : vec2(0.14, 0.0)));
        vec3 halfSize = i == 0 ? vec3(0.025, WINDOW.y, 0.025) : vec3(0.020, 0.020, WINDOW.z);
        vec3 entry = (centre - ray.origin - sign(ray.direction) * halfSize) / ray.direction;
        vec3 leave = entry + 2.0 * halfSize / abs(ray.direction);
        float first = max(entry.x, max(entry.y, entry.z));
        if (first > 1e-4 && first < min(bars.t, min(leave.x, min(leave.y, leave.z)))) {
            bars.t = first;
            bars.normal = -sign(ray.direction) * vec3(equal(entry, vec3(first)));
        }
    }
    return bars;
}

// Where a ray from a point in the room or in the window meets a wall, the floor, the ceiling, a bar, or the open air.
Wall wallReached(Ray ray)
{
    ray.direction += vec3(equal(ray.direction, vec3(0.0))) * 1e-9;
    Wall wall = boxLeft(ray, ROOM_AT, ROOM), hole = boxLeft(ray, WINDOW_AT, WINDOW), bars = barsReached(ray);
    bool within = ray.origin.x < -ROOM.x;
    bool enters = !within && wall.normal.x > 0.0 && inWindow((ray.origin + wall.t * ray.direction).yz);
    if (enters || (within && hole.normal.x >= 0.0)) {
        wall = hole;
        wall.t = hole.normal.x > 0.0 ? ROOM_FAR : hole.t;
    }
    if ((enters || within) && bars.t < wall.t)
        wall = bars;
    return wall;
}

// ---- The things ----

// A table under a cloth whose folds grow from its edge downwards. The distance is a lower bound.
float clothDistance(vec3 p)
{
    vec3 q = p - TABLE_AT;
    vec2 edge = clamp(q.xz, -TABLE, TABLE);
    float along = edge.x + edge.y, down = clamp(-2.5 * q.y, 0.0, 1.5);
    float wave = sin(10.0 * along + 1.2 * sin(3.3 * along + 1.0));
    float fold = 0.040 * down * (wave - 0.25 * wave * wave + 0.7);
    vec2 across = vec2(0.80 * q.x + 0.60 * q.z - 0.10, 0.94 * q.x - 0.34 * q.z + 0.335);
    vec2 ridge = 1.0 / (1.0 + 180.0 * across * across);
    float crease = dot(vec2(0.022, 0.018), ridge * ridge);
    return 0.74 * (sdBox(q + vec3(0.0, 0.37, 0.0), vec3(TABLE, 0.355).xzy) - 0.03 - fold - crease);
}

// A jug: a belly on a foot, a neck that widens upwards, and a handle.
float jugDistance(vec3 p)
{
    vec3 q = p - vec3(0.16, CLOTH, -1.04);
    float r = length(q.xz), up = clamp(q.y - 0.30, -0.11, 0.13);
    float belly = length(vec2(r, q.y - clamp(q.y, 0.12, 0.17))) - 0.125;
    float rim = 0.060 + (0.30 + 1.6 * max(up, 0.0)) * up * up;
    float neck = max(abs(r - rim) - 0.007, abs(q.y - 0.31) - 0.12), foot = max(r - 0.085, q.y - 0.02);
    vec2 ring = vec2(length(vec2(q.x + 0.085, 0.85 * (q.y - 0.315))) - 0.075, q.z);
    return min(min(opSmoothUnionQuadratic(belly, 0.9 * neck, 0.06), foot), length(ring) - 0.013);
}

// A bowl: a piece of a shell on a ring.
float bowlDistance(vec3 p)
{
    vec3 q = p - vec3(0.70, CLOTH + 0.165, -0.98);
    float shell = max(abs(length(q) - 0.20) - 0.007, q.y - 0.02);
    return min(shell, max(abs(length(q.xz) - 0.075) - 0.012, abs(q.y + 0.18) - 0.02));
}

// A lemon with its middle at the origin, the body of revolution of an arc: a lower bound of the distance.
//   axis  from tip to tip, length 1
float lemonDistance(vec3 q, vec3 axis)
{
    float along = dot(q, axis), across = length(q - along * axis);
    return length(vec2(across + 0.0265, along)) - 0.0755;
}

// Four lemons, two in the bowl and two on the cloth. Each pair is one lemon and its image in a mirror.
float lemonsDistance(vec3 p)
{
    vec3 inBowl = opReflect(p - vec3(0.69, 0.935, -0.98), vec3(0.83, 0.07, -0.5534), 0.0);
    vec3 onCloth = opReflect(p - vec3(1.29, CLOTH + 0.049, -0.78), vec3(0.992, 0.0, -0.1262), 0.0);
    return min(lemonDistance(inBowl - vec3(0.060, 0.005, -0.040), vec3(0.6, 0.0, 0.8)),
               lemonDistance(onCloth - vec3(0.310, 0.0, -0.040), vec3(0.97, 0.0, 0.2431)));
}

// Two eggs, again one and its image. An egg is a row of balls that get smaller along its axis. Exact outside.
float eggsDistance(vec3 p)
{
    vec3 q = opReflect(p - vec3(1.305, CLOTH + 0.038, -0.74), vec3(0.6757, 0.0, 0.7372), 0.0);
    q -= vec3(0.055, 0.0, 0.060);
    float along = dot(q, vec3(0.8, 0.0, -0.6)), across = length(q - along * vec3(0.8, 0.0, -0.6));
    float ball = clamp(along - 0.3779 * across, 0.0, 0.034);
    return length(vec2(along - ball, across)) - 0.038 + 0.3535 * ball;
}

float sceneDistance(vec3 p)
{
    float placed = min(min(jugDistance(p), bowlDistance(p)), min(lemonsDistance(p), eggsDistance(p)));
    return min(clothDistance(p), placed);
}

// The camera stays in the room.
float cameraRoom(vec3 p)
{
    vec3 q = abs(p - ROOM_AT) - ROOM;
    return min(sceneDistance(p), -max(q.x, max(q.y, q.z))) - 0.1;
}

// The share of the light that a surface at p reflects.
vec3 wallColour(vec3 p)
{
    vec2 tile = floor(p.xz / 0.38 + 0.25);
    vec3 ground = mod(tile.x + tile.y, 2.0) < 0.5 ? TILE_RED : TILE_PALE;
    bool board = p.y < 0.10 && (p.z < -1.59 || (p.x < -1.89 && p.x > -1.91));
    bool bar = p.x < -2.2 && inWindow(vec2(WINDOW_AT.y, WINDOW_AT.z) + 1.002 * (p.yz - WINDOW_AT.yz));
    return p.y < 0.001 ? ground : (board || bar ? WOOD : (p.x > 1.899 ? CORAL : LIME));
}

vec3 thingColour(vec3 p, float threshold)
{
    vec3 colour = p.x > 0.42 && p.x < 0.95 ? GREEN : WHITE; // the bowl; the jug and the eggs
    colour = lemonsDistance(p) < 2.0 * threshold ? YELLOW : colour;
    return clothDistance(p) < 2.0 * threshold ? BLUE : colour;
}

// ---- What a ray meets ----

struct Surface {
    bool  open;   // the ray leaves through the window
    float t;      // along the ray, scene units
    vec3  p, normal, colour;
};

Surface roomSurface(Ray ray, float threshold, int maxSteps)
{
    Wall wall = wallReached(ray);
    vec2 interval = boxInterval(ray, THINGS_LOW, THINGS_HIGH);
    Hit hit = march(ray, interval.x, min(interval.y, wall.t), threshold, maxSteps);
    float t = hit.found ? hit.t : wall.t;
    vec3 p = ray.origin + t * ray.direction, normal = normalAt(p, threshold), colour = thingColour(p, threshold);
    bool open = !hit.found && wall.t >= ROOM_FAR;
    return Surface(open, t, p, hit.found ? normal : wall.normal, hit.found ? colour : wallColour(p));
}

// The share of the light from a direction beyond the window that reaches p: 0 or 1.
//   far  distance to the outer end of the window
float reaching(vec3 p, vec3 normal, vec3 direction, float far, float threshold, int maxSteps)
{
    Ray ray = Ray(p + 3.0 * threshold * normal, direction);
    bool free = (p.x < -ROOM.x || inWindow((p - (ROOM.x + p.x) / direction.x * direction).yz)) && inWindow((p + far * direction).yz);
    far = free && barsReached(ray).t > far ? far : 0.0;
    vec2 interval = boxInterval(ray, THINGS_LOW, THINGS_HIGH);
    bool found = march(ray, interval.x, min(interval.y, far), threshold, maxSteps).found;
    return far > 0.0 && !found ? 1.0 : 0.0;
}
