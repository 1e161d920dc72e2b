// Experiment of chapter 16: the scene of chapter 06 with the methods of 16_means.glsl.
#include "main.glsl"
#include "16_means.glsl"
#include "06_sierpinski_symmetry.frag"

float coarseMargin(float t)
{
    return hitThreshold + footprint * pixelSpread() * t;
}
