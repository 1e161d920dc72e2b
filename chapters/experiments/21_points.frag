// Experiment of chapter 21: the slope of the waves at one point of each pixel, instead of its mean
// over the pixel.
#include "main.glsl"
#include "water.glsl"

Footprint pointOfWater(vec3 direction, float width)
{
    return Footprint(vec3(0.0), vec3(0.0));
}

#define footprintOnWater pointOfWater
#include "21_a_landscape.frag"
