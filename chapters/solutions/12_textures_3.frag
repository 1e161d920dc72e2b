// Solution to exercise 12.3: ridges. Every octave is folded at 1/2, which doubles its slope.
//
// The chapter's calls to octaveNoise and octaveStretch are replaced by calls to the functions
// below.
#include "main.glsl"
#include "noise.glsl"

vec4 ridgedNoise(vec3 p, int count, float gain, float lacunarity)
{
    vec4 sum = vec4(0.0);
    float weight = 1.0, scale = 1.0;
    for (int i = 0; i < count; i++) {
        vec4 noise = 2.0 * valueNoise(p) - vec4(1.0, vec3(0.0));
        sum += weight * vec4(1.0, vec3(scale)) * (noise.x < 0.0 ? -noise : noise);
        p = lacunarity * p + OCTAVE_SHIFT;
        weight *= gain;
        scale *= lacunarity;
    }
    return sum / geometricSum(gain, count);
}

float ridgedStretch(int count, float gain, float lacunarity)
{
    return 2.0 * octaveStretch(count, gain, lacunarity);
}

#define octaveNoise ridgedNoise
#define octaveStretch ridgedStretch
#include "12_textures.frag"
