// Experiment of chapter 16: the sea of chapter 05 with the methods of 16_means.glsl and one more:
// each ray has its own stretch for the waves and for the twisted ring.
#include "main.glsl"
#include "16_means.glsl"
#include "stretch.glsl"
#include "transform.glsl"

uniform bool own; // true: a stretch for each ray

void stretchAlong(vec3 direction);

// A march whose distances are divided by the stretches of this ray. Afterwards, normals and the
// next ray again use the stretches that are safe for all directions.
Hit ownMarch(Ray ray, float tMin, float tMax, float threshold, int maxSteps)
{
    stretchAlong(own ? ray.direction : vec3(0.0));
    Hit hit = march(ray, tMin, tMax, threshold, maxSteps);
    stretchAlong(vec3(0.0));
    return hit;
}

#undef march
#define march ownMarch
#include "05_transforms.frag"

// Set the stretches of the scene for a direction, or for all directions if it is 0. The direction
// is turned to the ring's axes; the scale of the ring does not change it.
void stretchAlong(vec3 direction)
{
    bool all = direction == vec3(0.0);
    vec3 turned = all ? direction : direction * now.ring.turn;
    now.ringStretch = all ? twistStretch(twist, RING_REACH) : twistStretchAlong(twist, RING_REACH, turned);
    now.seaStretch = all ? heightStretch(waveHeight * STEEPEST) : heightStretchAlong(waveHeight * STEEPEST, direction);
}

float coarseMargin(float t)
{
    return hitThreshold;
}
