// Solution to exercise 04.4: a lens, the intersection of two equal balls, in the middle of the
// wheel, with its exact distance or with the bound max(a, b), where a and b are the distances to the
// balls.
//
// This file replaces the chapter's sceneDistance, colourAt and rayColour, because the solid in the
// middle is different.
#include "main.glsl"
#define sceneDistance wheelScene
#define colourAt wheelColourAt
#define rayColour wheelRayColour
#include "04_hue_colour.frag"
#undef rayColour
#undef colourAt
#undef sceneDistance

uniform bool exact; // true: the exact distance instead of the maximum

const float RADIUS = 1.1; // radius of the balls, scene units
const float APART = 0.8;  // from the lens's centre to the centre of each ball

float lensDistance(vec3 p)
{
    vec3 q = p - vec3(0.0, 0.76, 0.0);
    if (!exact)
        return opIntersection(sdSphere(q + vec3(APART, 0.0, 0.0), RADIUS), sdSphere(q - vec3(APART, 0.0, 0.0), RADIUS));
    vec2 side = vec2(abs(q.x), length(q.yz));
    float rim = sqrt(RADIUS * RADIUS - APART * APART);
    bool beyond = (side.y - rim) * APART > side.x * rim;
    return beyond ? length(side - vec2(0.0, rim)) : length(side + vec2(APART, 0.0)) - RADIUS;
}

float sceneDistance(vec3 p)
{
    return opUnion(opUnion(stageDistance(p), wheelDistance(p)), lensDistance(p));
}

vec3 colourAt(vec3 p)
{
    float stage = stageDistance(p), wheel = wheelDistance(p), lens = lensDistance(p);
    if (lens < min(stage, wheel))
        return hsvToRGB(BALL_HUE, saturation, value);
    return stage < wheel ? STAGE_COLOUR : wheelColourAt(p);
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
