// Experiment of chapter 11: the number of the material is carried through the march together with
// the distance, in a vec2, as in the workshop. Where two materials blend, the share is carried too,
// as the fractional part of the number. The picture is the same as the chapter's; compare the cost.
//
// The chapter's rayColour is renamed.
#include "main.glsl"
#define rayColour chapterRayColour
#include "11_materials.frag"
#undef rayColour

// The distance and the number of the nearer of two parts.
vec2 opU(vec2 a, vec2 b)
{
    return a.x < b.x ? a : b;
}

vec2 sceneCarried(vec3 p)
{
    vec2 pear = pearDistances(p), lemon = lemonDistances(p), wax = waxDistances(p);
    vec2 found = opU(vec2(p.z - WALL, 0.0), vec2(p.y, 1.0));
    found = opU(found, vec2(jugDistance(p), 2.0));
    found = opU(found, vec2(bowlDistance(p), 3.0));
    found = opU(found, vec2(opSmoothUnion(lemon.x, lemon.y, 0.22), 4.0 + 0.99 * smoothUnionShare(lemon.x, lemon.y, 0.22)));
    found = opU(found, vec2(opSmoothUnion(pear.x, pear.y, blend), 5.0 + 0.99 * smoothUnionShare(pear.x, pear.y, blend)));
    found = opU(found, vec2(stalkDistance(p), 6.0));
    found = opU(found, vec2(silverDistance(p), 7.0));
    found = opU(found, vec2(ivoryDistance(p), 8.0));
    return opU(found, vec2(mix(wax.x, wax.y, waxShare()), 9.0));
}

float carried; // the number at the point where the last march ended

Hit marchCarried(Ray ray, float tMin, float tMax, float threshold, float spread, int maxSteps)
{
    traceBegin(tMin, tMax);
    float t = tMin;
    int steps = 0;
    bool found = false;
    bool searching = tMin < tMax;
    while (searching) {
        vec2 scene = sceneCarried(ray.origin + t * ray.direction);
        trace.evaluations++;
        traceStep(steps, t, scene.x);
        steps++;
        found = scene.x < threshold + spread * t;
        carried = scene.y;
        t += found ? 0.0 : scene.x;
        searching = !found && t < tMax && steps < maxSteps;
    }
    int end = found ? END_HIT : (t >= tMax ? END_PASSED : END_STEPS);
    traceMarch(steps, t, end);
    return Hit(found, t);
}

Material materialOf(float number, vec3 p, Pixel pixel)
{
    int n = int(number);
    float share = fract(number) / 0.99;
    Material found = PLASTER;
    if (n == 1)
        found = mixMaterials(MADDER, LINEN, linenShare(p, pixel));
    if (n == 2)
        found = CLAY;
    if (n == 3)
        found = mixMaterials(COBALT, CREAM, smoothstep(0.77, 0.80, p.y));
    if (n == 4)
        found = mixMaterials(YELLOW, LEAF, share);
    if (n == 5)
        found = mixMaterials(GREEN, RUSSET, share);
    if (n == 6)
        found = WOOD;
    if (n == 7)
        found = SILVER;
    if (n == 8)
        found = IVORY;
    if (n == 9)
        found = mixMaterials(BOTTLE, HONEY, waxShare());
    found.roughness = clamp(found.roughness / polish, 0.06, 1.0);
    return found;
}

vec3 rayColour(Ray ray)
{
    vec3 light = vec3(0.0), share = vec3(1.0);
    float spread = pixelSpread() * dot(ray.direction, iCameraForward), halfSide = 0.0, roughness = 0.0;
    for (int bounce = 0; bounce < 2; bounce++) {
        vec2 interval = sceneInterval(ray);
        Hit hit = marchCarried(ray, interval.x, interval.y, hitThreshold + halfSide, spread, maxSteps);
        if (!hit.found)
            break;
        vec3 p = ray.origin + hit.t * ray.direction;
        halfSide += spread * hit.t;
        float radius = hitThreshold + halfSide;
        vec3 normal = surfaceNormal(p, radius);
        Material material = materialOf(carried, p, Pixel(ray.direction, halfSide, spread / halfSide));
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
