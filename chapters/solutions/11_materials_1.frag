// Solution to exercise 11.1: the jug is glazed from its shoulder up. The march evaluates nothing
// new; the height of the hit determines which part of the jug it is on.
//
// The chapter's materialAt is renamed, and rayColour, which calls materialAt, is replaced.
#include "main.glsl"
#define materialAt chapterMaterialAt
#define rayColour chapterRayColour
#include "11_materials.frag"
#undef rayColour
#undef materialAt

Material materialAt(vec3 p, Pixel pixel)
{
    Material found = chapterMaterialAt(p, pixel), glaze = CREAM;
    glaze.roughness = clamp(glaze.roughness / polish, 0.06, 1.0);
    bool jug = jugDistance(p) <= sceneDistance(p);
    return mixMaterials(found, glaze, jug ? smoothstep(0.93, 0.97, p.y) : 0.0);
}

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
