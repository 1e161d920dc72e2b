// 11 Materials: a still life. The march needs only distances; the material is determined once, at
// the hit.

#include "main.glsl"       // main(): calls pixelRay, then rayColour
#include "cone.glsl"       // perspectiveRay, marchCone, pixelSpread, coneReaching
#include "normal.glsl"     // normalAt
#include "still_life.glsl" // jugDistance and the other objects on the table, thingsInterval, SILVER_RADIUS
#include "combine.glsl"    // opUnion, opSmoothUnion, smoothUnionShare
#include "material.glsl"   // Material, mixMaterials
#include "checkers.glsl"   // planeFootprint, checkers
#include "gloss.glsl"      // ggxGloss, halfway, GLOSS_PI
#include "fresnel.glsl"    // schlickShare
#include "lighting.glsl"   // lambert, encodeSRGB
#include "shadow.glsl"     // shadowRay, shadowReach

uniform float blend;        // 0.45 in [0.05, 1] step 0.05, scene units: width of the pear's blend
uniform float polish;       // 1 in [0.25, 4] step *1.1: divides the roughness of everything
uniform bool  averaged;     // true: the cloth's squares are averaged over the pixel; false: evaluated at its centre
uniform int   maxSteps;     // 128 in [1, 512]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.001 in [0.0001, 0.05] step *2, scene units: distance that counts as a hit, at the eye

const float WALL = -2.2;                              // z of the wall
const float FAR = 40.0;                               // a ray that has travelled this far shows the room
const float TILE = 0.42;                              // side of a square of the cloth, scene units
const vec3  TO_LIGHT = vec3(-0.7433, 0.5213, 0.4194);  // direction to the light of the window, length 1
const vec3  WINDOW_LIGHT = vec3(2.25, 1.86, 1.34);     // linear RGB
const vec3  ROOM_LIGHT = vec3(0.060, 0.062, 0.052);
const vec3  CLOTH_LIGHT = vec3(0.050, 0.020, 0.010);   // light that the cloth reflects upwards

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// ---- Distances: the table, the wall and the objects ----

// How far the wax has changed from the cube to the ball, from 0 to 1.
float waxShare()
{
    return 0.5 - 0.5 * cos(0.5 * iTime + 1.2);
}

float sceneDistance(vec3 p)
{
    vec2 pear = pearDistances(p), lemon = lemonDistances(p), wax = waxDistances(p);
    float fruit = opUnion(opSmoothUnion(pear.x, pear.y, blend), opSmoothUnion(lemon.x, lemon.y, 0.22));
    float vessels = opUnion(opUnion(jugDistance(p), bowlDistance(p)), silverDistance(p));
    float small = opUnion(opUnion(ivoryDistance(p), mix(wax.x, wax.y, waxShare())), stalkDistance(p));
    return opUnion(opUnion(opUnion(fruit, vessels), small), opUnion(p.y, p.z - WALL));
}

// The camera stops in front of the objects, the table and the wall.
float cameraRoom(vec3 p)
{
    return sceneDistance(p) - 0.1;
}

// ---- Where to look ----

// The interval in which a ray can meet the scene. It begins where the ray enters a box around
// objects or, if the ray misses the boxes, just in front of the table or the wall, and ends a little
// behind that table or wall. It never begins behind the ray's origin, which may be on the silver ball.
vec2 sceneInterval(Ray ray)
{
    vec2 things = thingsInterval(ray);
    float table = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : FAR;
    float wall = ray.direction.z < 0.0 ? (WALL - ray.origin.z) / ray.direction.z : FAR;
    float end = min(table, wall);
    float begin = (things.x < things.y ? min(things.x, end) : end) - 0.01;
    return vec2(max(begin, 0.0), end + 0.3);
}

// ---- Materials, determined once, at the hit ----

const Material PLASTER = Material(vec3(0.16, 0.175, 0.14), vec3(0.03), 0.9);
const Material LINEN = Material(vec3(0.46, 0.39, 0.29), vec3(0.03), 0.8);
const Material MADDER = Material(vec3(0.12, 0.018, 0.015), vec3(0.03), 0.8);
const Material CLAY = Material(vec3(0.30, 0.095, 0.04), vec3(0.04), 0.75);
const Material COBALT = Material(vec3(0.015, 0.05, 0.16), vec3(0.06), 0.12);
const Material CREAM = Material(vec3(0.50, 0.45, 0.36), vec3(0.06), 0.15);
const Material SILVER = Material(vec3(0.0), vec3(0.93, 0.88, 0.80), 0.10);
const Material IVORY = Material(vec3(0.62, 0.51, 0.34), vec3(0.05), 0.40);
const Material YELLOW = Material(vec3(0.66, 0.37, 0.02), vec3(0.04), 0.38);
const Material LEAF = Material(vec3(0.25, 0.28, 0.03), vec3(0.04), 0.5);
const Material GREEN = Material(vec3(0.46, 0.40, 0.06), vec3(0.04), 0.34);
const Material RUSSET = Material(vec3(0.38, 0.05, 0.02), vec3(0.04), 0.30);
const Material WOOD = Material(vec3(0.07, 0.04, 0.02), vec3(0.04), 0.7);
const Material BOTTLE = Material(vec3(0.02, 0.08, 0.05), vec3(0.04), 0.22);
const Material HONEY = Material(vec3(0.55, 0.25, 0.03), vec3(0.04), 0.30);

// The pixel that shows a point.
struct Pixel {
    vec3  direction; // direction of the pixel's ray, length 1
    float halfSide;  // half the pixel's side at the point, perpendicular to the view, scene units
    float bend;      // how fast the direction changes across the pixel, per scene unit
};

// The share of linen in the part of the cloth that a pixel covers. The sides of the squares are at
// 45 degrees to the x and z axes.
float linenShare(vec3 p, Pixel pixel)
{
    const float S = 0.70710678 / TILE;
    Footprint seen = planeFootprint(p, pixel.direction, vec3(0.0, 1.0, 0.0), pixel.halfSide, pixel.bend,
                                    mat2x3(S, 0.0, S, S, 0.0, -S));
    return checkers(seen.middle, averaged ? seen.width : vec2(1e-4));
}

// Replace the nearest part and its material with a candidate if the candidate is nearer.
void take(inout float nearest, inout Material found, float distance, Material candidate)
{
    if (distance < nearest) {
        nearest = distance;
        found = candidate;
    }
}

Material materialAt(vec3 p, Pixel pixel)
{
    vec2 pear = pearDistances(p), lemon = lemonDistances(p), wax = waxDistances(p);
    Material cloth = mixMaterials(MADDER, LINEN, linenShare(p, pixel));
    Material pearSkin = mixMaterials(GREEN, RUSSET, smoothUnionShare(pear.x, pear.y, blend));
    Material lemonSkin = mixMaterials(YELLOW, LEAF, smoothUnionShare(lemon.x, lemon.y, 0.22));
    Material glaze = mixMaterials(COBALT, CREAM, smoothstep(0.77, 0.80, p.y));
    Material found = PLASTER;
    float nearest = p.z - WALL;
    take(nearest, found, p.y, cloth);
    take(nearest, found, jugDistance(p), CLAY);
    take(nearest, found, bowlDistance(p), glaze);
    take(nearest, found, opSmoothUnion(lemon.x, lemon.y, 0.22), lemonSkin);
    take(nearest, found, opSmoothUnion(pear.x, pear.y, blend), pearSkin);
    take(nearest, found, stalkDistance(p), WOOD);
    take(nearest, found, silverDistance(p), SILVER);
    take(nearest, found, ivoryDistance(p), IVORY);
    take(nearest, found, mix(wax.x, wax.y, waxShare()), mixMaterials(BOTTLE, HONEY, waxShare()));
    found.roughness = clamp(found.roughness / polish, 0.06, 1.0);
    return found;
}

// ---- Light ----

// A rectangle with soft edges around the origin: 1 inside, 0 outside.
float pane(vec2 q, vec2 halfSize, float soft)
{
    vec2 inside = 1.0 - smoothstep(halfSize - soft, halfSize + soft, abs(q));
    return inside.x * inside.y;
}

// The light from the direction of a ray that meets nothing: the room behind the viewer, with the
// window on the left. The room is painted by eye, and a rougher surface reflects a softer window.
vec3 skyLight(vec3 direction, float roughness)
{
    vec2 q = direction.yz / min(direction.x, -0.1) + vec2(0.55, 0.45);
    vec2 bars = 1.0 - smoothstep(0.018, 0.042, abs(q));
    float cross = max(bars.x, bars.y);
    float window = pane(q, vec2(0.36, 0.3), 0.02 + roughness) * (1.0 - cross * max(1.0 - 4.0 * roughness, 0.0));
    return ROOM_LIGHT * (0.6 + 0.4 * direction.y) + 8.0 * WINDOW_LIGHT * window / (1.0 + 9.0 * roughness);
}

// The share of the window's light that its frame lets through to p.
float shaft(vec3 p)
{
    vec2 q = (p - TO_LIGHT * ((p.x + 6.0) / TO_LIGHT.x)).yz;
    return 0.06 + 0.94 * pane(q - vec2(4.8, 2.5), vec2(2.0, 2.4), 0.5);
}

// The share of light that a surface reflects as a mirror, for each colour.
vec3 mirroredShare(Material material, float facing)
{
    return mix(material.straight, vec3(1.0), schlickShare(clamp(facing, 0.0, 1.0), 0.0));
}

// The light that a surface sends to the eye: the light of the window where the window is visible,
// mirrored and scattered, and the light of the room, scattered.
vec3 surfaceLight(vec3 p, vec3 normal, vec3 toEye, Material material, float radius)
{
    Ray ray = shadowRay(p, normal, TO_LIGHT, 4.0 * radius);
    vec2 interval = thingsInterval(ray);
    float far = shadowReach(normal, TO_LIGHT, interval.y);
    float seen = coneReaching(ray, interval.x, far, 2.0 * radius, 0.04, maxSteps) * shaft(p);
    vec3 mirrored = mirroredShare(material, dot(toEye, halfway(TO_LIGHT, toEye)));
    vec3 gloss = mirrored * ggxGloss(normal, TO_LIGHT, toEye, material.roughness) * GLOSS_PI;
    vec3 received = seen * lambert(normal, TO_LIGHT) * WINDOW_LIGHT;
    vec3 room = ROOM_LIGHT * (0.8 + 0.2 * normal.y - 0.35 * normal.x) + CLOTH_LIGHT * max(-normal.y, 0.0);
    return (material.colour * (1.0 - mirrored) + gloss) * received + material.colour * room;
}

// The normal at a hit. It is known on the table and the wall, which fill most of the picture;
// elsewhere it is computed from differences.
vec3 surfaceNormal(vec3 p, float radius)
{
    bool wall = p.z < WALL + radius;
    vec3 normal = wall ? vec3(0.0, 0.0, 1.0) : vec3(0.0, 1.0, 0.0);
    if (wall || p.y < radius)
        traceNormal(normal);
    else
        normal = normalAt(p, radius);
    return normal;
}

// The light that reaches the camera, including light that the silver has reflected once. The ray of
// a pixel widens along its path, and faster after a curved mirror.
vec3 rayColour(Ray ray)
{
    vec3 light = vec3(0.0), share = vec3(1.0);
    float spread = pixelSpread() * dot(ray.direction, iCameraForward), halfSide = 0.0, roughness = 0.0;
    for (int bounce = 0; bounce < 2; bounce++) {
        vec2 interval = sceneInterval(ray);
        Hit hit = marchCone(ray, interval.x, interval.y, hitThreshold + halfSide, spread, maxSteps);
        if (!hit.found)
            break;
        vec3 p = ray.origin + hit.t * ray.direction;
        halfSide += spread * hit.t;
        float radius = hitThreshold + halfSide;
        vec3 normal = surfaceNormal(p, radius);
        Material material = materialAt(p, Pixel(ray.direction, halfSide, spread / halfSide));
        light += share * surfaceLight(p, normal, -ray.direction, material, radius);
        roughness = material.roughness;
        share *= mirroredShare(material, -dot(ray.direction, normal)) * (1.0 - roughness) * (1.0 - roughness);
        ray = shadowRay(p, normal, reflect(ray.direction, normal), 4.0 * radius);
        spread += 2.0 * halfSide / SILVER_RADIUS;
        if (material.straight.g < 0.5)
            break;
    }
    return encodeSRGB(light + share * skyLight(ray.direction, roughness));
}
