// marched.glsl - the march of the selected ray, step by step: a table that is complete before the
// picture is drawn.
//
// For a shader that reads this table, the harness marches the selected pixel's ray first, once for the whole picture,
// as it does for the slice and for --probe: all three show the same march. If every pixel marched this ray, each pixel
// would cost as many additional evaluations as the march has steps.
#include "scene.glsl"

const int MARCHED_STEPS = 64; // the table has at most this many steps

#ifndef EXPORTED

uniform vec2 iMarched[MARCHED_STEPS]; // t and distance of step k, scene units
uniform int  iMarchedSteps;           // number of steps
uniform bool iMarchedHit;             // whether the last step of the march found the surface

// The number of steps in the table. The arguments are used only in Shadertoy, which has no table.
//   ray, far, threshold, maxSteps  of the chapter's march of the selected ray
int marchedSteps(Ray ray, float far, float threshold, int maxSteps)
{
    return iMarchedSteps;
}

// Step k of the march, k from 0 to marchedSteps - 1.
//   returns  (t, distance), scene units
vec2 marchedStep(int k)
{
    return iMarched[k];
}

// Did the last step of the march find the surface?
bool marchedHit()
{
    return iMarchedHit;
}

#else

vec2 marchedTable[MARCHED_STEPS];
bool marchedEnd;

int marchedSteps(Ray ray, float far, float threshold, int maxSteps)
{
    float t = 0.0;
    int steps = 0;
    marchedEnd = false;
    while (!marchedEnd && t < far && steps < min(maxSteps, MARCHED_STEPS)) {
        float distance = distanceAt(ray.origin + t * ray.direction);
        marchedTable[steps++] = vec2(t, distance);
        marchedEnd = distance < threshold;
        t += distance;
    }
    return steps;
}

vec2 marchedStep(int k)
{
    return marchedTable[k];
}

bool marchedHit()
{
    return marchedEnd;
}

#endif
