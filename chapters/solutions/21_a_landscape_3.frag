// Solution of exercise 21.3: gorges for ridges. The fold is turned over, and no bound changes: |grad| is the same.
//
// All calls of ridged are turned into calls of gorge.
#include "main.glsl"
#include "land.glsl"

vec3 gorge(vec3 noise)
{
    float s = 2.0 * noise.x - 1.0;
    return vec3(abs(s), 2.0 * sign(s) * noise.yz);
}

#define ridged gorge
#include "21_a_landscape.frag"
