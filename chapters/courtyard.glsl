// courtyard.glsl - a court with an arcade, the scene of chapters 14 and 15: its objects and their
// materials. Light, camera and parameters are in the chapters.
//
// x points to the right, y upwards, z towards the eye; one scene unit is a metre. The court consists
// of a trough, which is the floor and the two side walls, and of objects in the trough. The point
// where a ray meets the trough is computed in closed form, and a march finds the objects:
// courtyardDistance is the distance to the objects only. To find everything that hides the sky, use
// the smaller of courtyardDistance and troughDistance, or the nearer of the march's end and
// troughReached.
#include "bounds.glsl"
#include "cone.glsl"
#include "coverage.glsl"
#include "noise.glsl"
#include "normal.glsl"
#include "primitives.glsl"
#include "repetition.glsl"

const vec3  COURT_LOW = vec3(-4.80, -0.01, -6.35);   // opposite corners of a box around all objects
const vec3  COURT_HIGH = vec3(4.80, 4.75, 1.50);
const float COURT_FAR = 40.0;                        // a ray that has travelled this far meets the sky
const float COURT_SIDE = 4.75;                       // the side walls are at x = -4.75 and 4.75
const float COURT_TOP = 3.10;                        // height of the side walls
const float COURT_FRONT = -3.60;                     // z at which the gallery's floor begins
const float COURT_BACK = -6.20;                      // z of the gallery's rear wall
const vec2  COURT_EAVES = vec2(-3.3, 3.46);          // z and y of the roof's edge
const float TILE = 0.27;                             // width of a tile
const vec3  COURT_WELL = vec3(-2.15, 0.0, 0.30);     // foot of the axis of the well
const vec3  COURT_JAR = vec3(2.90, 0.0, -2.85);      // foot of a jar; another jar is at -x
const vec4  COURT_BALL = vec4(3.50, 0.68, -0.5, 0.68); // the larger box tree: centre and radius
const vec4  COURT_SMALL_BALL = vec4(2.70, 0.36, 1.05, 0.36);
const float COURT_PAVING = 0.95;                     // side of a paving stone
const float COURT_JOINT = 0.018;                     // width of a joint, in paving stones

const vec3  LIME = vec3(0.82, 0.79, 0.74);            // limewash; a colour is a share of reflected light, linear RGB
const vec3  DADO = vec3(0.56, 0.34, 0.23);            // the painted bands at the foot and the top of the side walls
const vec3  STONE = vec3(0.58, 0.55, 0.50);
const vec3  PAVING = vec3(0.57, 0.53, 0.47);
const vec3  CLAY = vec3(0.60, 0.26, 0.14);            // tiles and jars
const vec3  LEAF = vec3(0.12, 0.20, 0.07);
const vec3  DOOR = vec3(0.10, 0.22, 0.21);
const vec3  IRON = vec3(0.05, 0.055, 0.06);

// ---- The objects ----

// A convex corner of a figure in the plane, in a form that needs only one square root for a union of
// many corners: the square of the distance outside, and a signed depth, which is negative inside. For
// the union of two corners, take the smaller square and the smaller depth.
//   q        distances to two edges at right angles, each negative inside, scene units
//   returns  (|max(q, 0)|^2, max(q.x, q.y)), for cornersDistance
vec2 corner(vec2 q)
{
    vec2 outside = max(q, 0.0);
    return vec2(dot(outside, outside), max(q.x, q.y));
}

// The distance to a union of corners: sqrt(squares) + min(depth, 0), scene units. It is exact
// outside if each q is exact, and otherwise a lower bound if each q is 1-Lipschitz. Inside, it is a
// lower bound of the depth.
//   corners  the smallest square of all corners, and the smallest depth
float cornersDistance(vec2 corners)
{
    return sqrt(corners.x) + min(corners.y, 0.0);
}

// A wall with five openings below round arches, and ledges where the arches begin.
vec2 arcadeCorners(vec3 p)
{
    float x = opRepeatLimited(p.x, 1.9, -2.0, 2.0);
    float opening = length(vec2(x, max(p.y - 2.05, 0.0))) - 0.72;
    float before = abs(p.z + 4.0) - 0.22;
    vec2 wall = corner(vec2(max(p.y - 3.6, -opening), before));
    return min(wall, corner(vec2(0.66 - abs(x), max(abs(p.y - 2.02) - 0.06, before - 0.06))));
}

// The gallery behind the arcade: the floor, three round steps that lead up to it, and the rear
// wall.
vec2 galleryCorners(vec3 p)
{
    float r = length(p.xz - vec2(0.0, COURT_FRONT));
    vec2 lower = min(corner(vec2(r - 2.16, p.y - 0.15)), corner(vec2(r - 1.80, p.y - 0.30)));
    vec2 upper = min(corner(vec2(r - 1.44, p.y - 0.45)), corner(vec2(p.z - COURT_FRONT, p.y - 0.6)));
    return min(min(lower, upper), corner(vec2(p.z - COURT_BACK, p.y - 4.4)));
}

// A pent roof of half-round tiles, TILE apart.
vec2 roofCorners(vec3 p)
{
    vec2 q = mat2(-0.94, 0.3411745, 0.3411745, 0.94) * (p.zy - COURT_EAVES);
    float tile = length(vec2(opRepeat(p.x, TILE), q.y - 0.02)) - 0.1;
    return corner(vec2(-q.x, max(min(tile, q.y - 0.05), -q.y - 0.03)));
}

// A well: a ring of stone below a slab with a hole, and an iron bow above the slab.
//   q  position relative to the foot of the axis, scene units
vec2 wellCorners(vec3 q)
{
    float r = abs(length(q.xz) - 0.62);
    vec2 ring = min(corner(vec2(r - 0.1, q.y - 0.74)), corner(vec2(r - 0.17, abs(q.y - 0.75) - 0.06)));
    float bow = length(vec2(q.x, max(q.y - 1.65, 0.0))) - 0.62;
    return min(ring, corner(abs(vec2(bow, q.z)) - 0.024));
}

// A jar with a foot, a belly, a neck and a lip.
//   q  position relative to the foot of the jar, scene units
vec2 jarCorners(vec3 q)
{
    vec2 r = vec2(length(q.xz), q.y);
    float belly = length(r - vec2(0.0, clamp(r.y, 0.52, 0.68))) - 0.43;
    vec2 neck = min(corner(vec2(r.x - 0.21, r.y - 1.16)), corner(vec2(r.x - 0.27, abs(r.y - 1.16) - 0.045)));
    return min(vec2(max(belly, 0.0) * belly, belly), min(corner(vec2(r.x - 0.24, r.y - 0.3)), neck));
}

// The distance to the two round box trees.
float boxTreeDistance(vec3 p)
{
    return min(sdSphere(p - COURT_BALL.xyz, COURT_BALL.w), sdSphere(p - COURT_SMALL_BALL.xyz, COURT_SMALL_BALL.w));
}

// All objects in the court, without its floor and side walls.
//   p        scene units
//   returns  signed distance, scene units: a lower bound, 1-Lipschitz; exact outside, except around
//            the roof and near the ends of the ledges
float courtyardDistance(vec3 p)
{
    vec2 built = min(min(arcadeCorners(p), galleryCorners(p)), roofCorners(p));
    vec2 placed = min(wellCorners(p - COURT_WELL), jarCorners(vec3(abs(p.x), p.yz) - COURT_JAR));
    return min(cornersDistance(min(built, placed)), boxTreeDistance(p));
}

// The distance to the floor and the side walls. Exact outside.
float troughDistance(vec3 p)
{
    return min(p.y, cornersDistance(corner(vec2(COURT_SIDE - abs(p.x), p.y - COURT_TOP))));
}

// The camera stops in front of everything in the court.
float cameraRoom(vec3 p)
{
    return min(courtyardDistance(p), troughDistance(p)) - 0.1;
}

// Where a ray that starts in the court meets the floor or a side wall.
//   returns  the exact t, scene units; COURT_FAR if the ray meets neither, or passes over a wall
float troughReached(Ray ray)
{
    float wall = (COURT_SIDE - sign(ray.direction.x) * ray.origin.x) / max(abs(ray.direction.x), 1e-6);
    float ground = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : COURT_FAR;
    bool over = wall < ground && ray.origin.y + wall * ray.direction.y > COURT_TOP;
    return over ? COURT_FAR : min(min(wall, ground), COURT_FAR);
}

// ---- The materials ----

// Paving stones with thin joints; every other row is shifted by half a stone.
//   width  of the pixel on the floor, along x and z, scene units
vec3 pavingColour(vec3 p, vec2 width)
{
    vec2 tile = p.xz / COURT_PAVING, across = width / COURT_PAVING;
    tile.x += 0.5 * mod(floor(tile.y + 0.5), 2.0);
    float alongZ = mix(stripes(tile.x, COURT_JOINT, across.x), COURT_JOINT, blurred(across.x));
    float alongX = mix(stripes(tile.y, COURT_JOINT, across.y), COURT_JOINT, blurred(across.y));
    float tone = cellRandom(ivec3(floor(tile.x + 0.5), floor(tile.y + 0.5), 3));
    return PAVING * (0.88 + 0.2 * tone) * (1.0 - 0.4 * max(alongZ, alongX));
}

// The colour of walls, steps, and all floors except the paving.
//   grain  noise at the point, in [0, 1]
vec3 masonryColour(vec3 p, float grain)
{
    bool side = abs(p.x) > COURT_SIDE - 0.02, rear = p.z < COURT_BACK + 0.02;
    bool painted = side && (p.y < 0.8 || p.y > COURT_TOP - 0.12);
    bool door = rear && abs(p.x) < 0.6 && p.y < 2.3;
    vec3 wall = LIME * (0.93 + 0.07 * grain);
    vec3 lower = painted ? DADO * (0.92 + 0.16 * grain) : wall;
    return door ? DOOR : (p.y < 0.62 && !side && !rear ? STONE * (0.92 + 0.12 * grain) : lower);
}

// The colour of a surface at a point; for the paving use pavingColour. The object is found from the
// position: near the well and the jars there is no other object, apart from the roof above the jars,
// and a point that is nearer to the roof than to the arcade's wall is on the roof. The distances are
// not evaluated, because the scene would then be compiled once more.
//   p        on a surface, scene units
//   radius   the point is at most this far from the surface, scene units, > 0
//   returns  share of the light that is reflected, linear RGB
vec3 courtyardColour(vec3 p, float radius)
{
    bool leaf = boxTreeDistance(p) < radius;
    bool above = p.y > 0.5 * radius; // the point is not on the paving
    bool well = above && length(p.xz - COURT_WELL.xz) < 0.82;
    bool jar = above && length(vec2(abs(p.x), p.z) - COURT_JAR.xz) < 0.5;
    vec2 q = p.zy - COURT_EAVES;
    float below = -dot(q, vec2(0.3411745, 0.94)) - 0.03, wall = max(abs(p.z + 4.0) - 0.22, p.y - 3.6);
    bool roof = q.x < 0.1 && below < min(wall, radius);
    float grain = valueNoise((leaf ? vec3(20.0) : vec3(1.7, 2.6, 1.7)) * p).x;
    float tone = cellRandom(ivec3(floor(p.x / TILE + 0.5), floor(2.4 * p.z), 1));
    vec3 stone = p.y > 0.83 ? IRON : STONE * (0.85 + 0.2 * grain);
    vec3 clay = CLAY * (roof ? 0.7 + 0.5 * tone : 0.95 + 0.2 * grain);
    vec3 made = jar || roof ? clay : (well ? stone : masonryColour(p, grain));
    return leaf ? LEAF * (0.6 + 0.8 * grain) : made;
}

// ---- Where a ray ends ----

// Where the ray of a pixel ends, and the surface there.
struct Surface {
    bool  open;   // the ray met only the sky
    vec3  p;      // scene units
    vec3  normal; // length 1; undefined if open
    vec3  colour; // share of the light that is reflected, linear RGB
    float radius; // radius of the pixel's footprint at p, scene units
};

// March among the objects, then check the trough. During this march, the chapter's sceneDistance
// must be courtyardDistance.
//   ray                  starts at the eye, which is in the court
//   tMin                 where the march may begin: the ray meets no object before tMin, scene units
//   threshold, maxSteps  of marchCone, which also takes pixelSpread()
Surface courtyardSurfaceFrom(Ray ray, float tMin, float threshold, int maxSteps)
{
    vec2 interval = boxInterval(ray, COURT_LOW, COURT_HIGH);
    float trough = troughReached(ray);
    Hit hit = marchCone(ray, max(interval.x, tMin), min(interval.y, trough), threshold, pixelSpread(), maxSteps);
    float t = hit.found ? hit.t : trough;
    vec3 p = ray.origin + t * ray.direction;
    float radius = threshold + pixelSpread() * t;
    bool onTrough = !hit.found && t < COURT_FAR, ground = p.y < COURT_SIDE - abs(p.x);
    vec2 width = 2.0 * radius * (1.0 + abs(ray.direction.xz / ray.direction.y));
    vec3 straight = ground ? vec3(0.0, 1.0, 0.0) : vec3(-sign(p.x), 0.0, 0.0);
    vec3 normal = hit.found ? normalAt(p, radius) : straight;
    if (onTrough) { // report the hit to the views and the probe
        traceMarch(trace.steps, t, END_HIT);
        traceNormal(normal);
    }
    vec3 colour = onTrough && ground ? pavingColour(p, width) : courtyardColour(p, radius);
    return Surface(!hit.found && !onTrough, p, normal, colour, radius);
}

// courtyardSurfaceFrom, starting at the eye.
Surface courtyardSurface(Ray ray, float threshold, int maxSteps)
{
    return courtyardSurfaceFrom(ray, 0.0, threshold, maxSteps);
}
