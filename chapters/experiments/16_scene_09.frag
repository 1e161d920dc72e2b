// Experiment of chapter 16: the scene of chapter 09 with the methods of 16_means.glsl.
#include "main.glsl"
#include "16_means.glsl"
#include "09_sky_and_sunset.frag"

float coarseMargin(float t)
{
    return hitThreshold + 0.5 * footprint * pixelSpread() * t;
}
