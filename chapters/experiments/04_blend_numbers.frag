// Experiment of chapter 04: the blend of the workshop's opBlend, which interpolates between the
// numbers of two materials, here their hues, with the weight clamp(a - d, 0, 1). The distance to
// the first solid is a, and the distance to the smooth union is d.
//
//   numbers=true           interpolate the hues: all hues between those of block and ball appear
//   workshopWeight=true    use the workshop's weight, which is blend / 6 where it should be 1 / 2
//
// Macros rename the chapter's colourAt, which is used here for the other solids, and its rayColour.
#include "main.glsl"
#define colourAt rightColourAt
#define rayColour rightRayColour
#include "04_hue_colour.frag"
#undef rayColour
#undef colourAt

uniform bool numbers;        // true: interpolate the hues instead of the colours
uniform bool workshopWeight; // false: use the workshop's weight instead of the slope of the smooth union

vec3 colourAt(vec3 p)
{
    float a = blockDistance(p), b = ballDistance(p), d = middleDistance(p);
    if (d > min(wheelDistance(p), stageDistance(p)))
        return rightColourAt(p);
    float share = workshopWeight ? clamp(a - d, 0.0, 1.0) : ballShare(p);
    vec3 mixed = mix(hsvToRGB(BLOCK_HUE, saturation, value), hsvToRGB(BALL_HUE, saturation, value), share);
    return numbers ? hsvToRGB(mix(BLOCK_HUE, BALL_HUE, share), saturation, value) : mixed;
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
