// Experiment of chapter 04: all colours at once, as a lattice of cubes. The hue changes around the
// axis, the saturation outwards, and the value upwards. A slice is cut out to show the inside.
//
// The stage, the light and the camera are those of the chapter; this file replaces sceneDistance
// and everything that depends on it.
#include "main.glsl"
#define sceneDistance wheelScene
#define colourAt wheelColourAt
#define rayColour wheelRayColour
#include "04_hue_colour.frag"
#undef rayColour
#undef colourAt
#undef sceneDistance

uniform bool whole; // false: do not cut out the slice

const float RINGS = 5.0;  // number of steps in saturation
const float LEVELS = 5.0; // number of steps in value

// One ring of 24 columns of cubes. The plane is folded as in the chapter, here into a wedge of 7.5
// degrees. All cubes of a column have the same size, so the nearest cube is the one whose height is
// nearest.
//   q  the folded point
float ringDistance(vec3 q, float ring)
{
    float level = clamp(floor((q.y - 0.14) / 0.32 + 0.5), 0.0, LEVELS - 1.0);
    vec3 toCube = q - vec3(0.58 * ring, 0.14 + 0.32 * level, 0.0);
    return sdBox(toCube, vec3(min(0.045 * ring, 0.115)));
}

float latticeDistance(vec3 p)
{
    vec2 q = abs(p.xz);
    q = vec2(max(q.x, q.y), min(q.x, q.y));
    q = folded(q, MIRROR_30);
    q = folded(q, vec2(0.2588190, -0.9659258));
    q = folded(q, vec2(0.1305262, -0.9914449));
    float lattice = 1e6;
    for (float ring = 1.0; ring <= RINGS; ring++)
        lattice = opUnion(lattice, ringDistance(vec3(q.x, p.y, q.y), ring));
    float slice = opIntersection(dot(p.xz, vec2(0.6087614, -0.7933533)), dot(p.xz, vec2(-0.9238795, -0.3826834)));
    return whole ? lattice : opSubtraction(lattice, slice);
}

float sceneDistance(vec3 p)
{
    return opUnion(stageDistance(p), latticeDistance(p));
}

vec3 colourAt(vec3 p)
{
    float hue = 15.0 * floor(degrees(atan(p.z, p.x + float(p.xz == vec2(0.0)))) / 15.0 + 0.5);
    float ring = clamp(floor(length(p.xz) / 0.58 + 0.5), 1.0, RINGS);
    float level = clamp(floor((p.y - 0.14) / 0.32 + 0.5), 0.0, LEVELS - 1.0);
    vec3 colour = hsvToRGB(hue + hueShift, ring / RINGS, (level + 1.0) / LEVELS);
    return stageDistance(p) < latticeDistance(p) ? STAGE_COLOUR : colour;
}

vec3 rayColour(Ray ray)
{
    vec2 interval = boxInterval(ray, LOW, HIGH);
    Hit hit = march(ray, interval.x, interval.y, hitThreshold, maxSteps);
    vec3 light = skyLight(ray.direction);
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction;
        light = colourAt(p) * receivedLight(p, normalAt(p, normalStep));
    }
    return encodeSRGB(light);
}
