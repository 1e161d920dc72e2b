// Solution to exercise 21.4: a second layer of mist, low over the lake, dense at six in the morning
// and gone at nine. The optical depths of two layers add up.
//
// The chapter's calls to fogDepth become calls to morningDepth.
#include "main.glsl"
#include "fog.glsl"

float morningDepth(float height, float climb, float t, float density, float scale);

#define fogDepth morningDepth
#include "21_a_landscape.frag"
#undef fogDepth

float morningDepth(float height, float climb, float t, float density, float scale)
{
    float hour = mod(theHour, 24.0), share = smoothstep(3.0, 6.0, hour) * (1.0 - smoothstep(6.0, 9.0, hour));
    return fogDepth(height, climb, t, density, scale) + fogDepth(height, climb, t, 0.12 * share, 0.4);
}
