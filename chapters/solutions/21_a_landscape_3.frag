// Solution to exercise 21.3: gorges instead of ridges. The fold is turned upside down. No bound
// changes, because the length of the gradient is the same.
//
// All calls to ridged become calls to gorge.
#include "main.glsl"
#include "land.glsl"

vec3 gorge(vec3 noise)
{
    float s = 2.0 * noise.x - 1.0;
    return vec3(abs(s), 2.0 * sign(s) * noise.yz);
}

#define ridged gorge
#include "21_a_landscape.frag"
