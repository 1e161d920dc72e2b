// Solution to exercise 11.5: a blend of three balls that does not depend on their order, and its
// shares.
//
// The experiment's sceneDistance and ballMaterial are replaced, and so is rayColour, which calls
// ballMaterial.
#include "main.glsl"
#define sceneDistance nestedDistance
#define ballMaterial nestedMaterial
#define rayColour nestedColour
#include "experiments/11_three_balls.frag"
#undef rayColour
#undef ballMaterial
#undef sceneDistance

const float WIDTH = 0.15; // width of the blend, scene units

// For each ball, exp(-distance / WIDTH) after the smallest distance has been subtracted. Without
// the subtraction, every value would be rounded to 0 far from all balls.
vec3 weights(vec3 ball, float least)
{
    return exp((least - ball) / WIDTH);
}

float sceneDistance(vec3 p)
{
    vec3 ball = ballDistances(p);
    float least = min(ball.x, min(ball.y, ball.z));
    return opUnion(p.y, least - WIDTH * log(dot(weights(ball, least), vec3(1.0))));
}

Material ballMaterial(vec3 ball)
{
    vec3 w = weights(ball, min(ball.x, min(ball.y, ball.z)));
    vec3 share = w / (w.x + w.y + w.z);
    Material pair = mixMaterials(CLAY, COBALT, share.y / max(share.x + share.y, 1e-6));
    return mixMaterials(pair, LEMON, share.z);
}

vec3 rayColour(Ray ray)
{
    vec2 things = boxInterval(ray, LOW, HIGH);
    float ground = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : 200.0;
    float start = things.x < things.y ? min(things.x, ground) : ground;
    Hit hit = marchCone(ray, start - 0.01, min(ground + 0.5, 200.0), 0.001, pixelSpread(), 128);
    vec3 light = skyLight(ray.direction);
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction;
        float halfSide = pixelSpread() * hit.t, radius = 0.001 + halfSide;
        vec3 normal = normalAt(p, radius);
        Footprint seen = planeFootprint(p, ray.direction, vec3(0.0, 1.0, 0.0), halfSide, 1.0 / hit.t,
                                        mat2x3(1.0, 0.0, 0.0, 0.0, 0.0, 1.0));
        float share = checkers(seen.middle, seen.width);
        Material material = Material(vec3(mix(0.10, 0.22, share)), vec3(0.03), 0.8);
        if (p.y > 2.0 * radius)
            material = ballMaterial(ballDistances(p));
        Ray toLight = shadowRay(p, normal, TO_LIGHT, 4.0 * radius);
        float seenLight = coneReaching(toLight, 0.0, shadowReach(normal, TO_LIGHT, boxInterval(toLight, LOW, HIGH).y),
                                       2.0 * radius, 0.04, 96);
        float facing = clamp(dot(halfway(TO_LIGHT, -ray.direction), TO_LIGHT), 0.0, 1.0);
        float mirrored = schlickShare(facing, material.straight.g);
        float gloss = mirrored * GLOSS_PI * ggxGloss(normal, TO_LIGHT, -ray.direction, material.roughness);
        vec3 received = seenLight * lambert(normal, TO_LIGHT) * vec3(1.9, 1.75, 1.5);
        vec3 shown = (material.colour * (1.0 - mirrored) + gloss) * received;
        shown += material.colour * vec3(0.22, 0.24, 0.27) * (0.7 + 0.3 * normal.y);
        light = mix(shown, skyLight(vec3(0.0)), smoothstep(10.0, 60.0, hit.t));
    }
    return encodeSRGB(light);
}
