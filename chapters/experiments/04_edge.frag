// Experiment of chapter 04: how a march approaches an edge. In the middle of the chapter's wheel is
// a lens, the intersection of two balls of radius 1.1. Its distance is the lower bound max(a, b),
// where a and b are the distances to the balls. The parameter `apart` sets how sharp the rim of the
// lens is.
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

uniform float apart; // 0.8 in [0.1, 1] step 0.05, scene units: from the lens's centre to the centre of each ball

float lensDistance(vec3 p)
{
    vec3 q = p - vec3(0.0, 0.76, 0.0), centre = vec3(apart, 0.0, 0.0);
    return opIntersection(sdSphere(q + centre, 1.1), sdSphere(q - centre, 1.1));
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
    return stage < wheel ? STAGE_COLOUR : wheelColour(p);
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
