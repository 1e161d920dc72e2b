// Experiment of chapter 20: the article's first attempt, octaves of noise instead of a panorama, on
// the sphere around the eye or on a flat layer overhead.

#include "main.glsl"
#include "clouds.glsl"
#include "noise.glsl"

uniform bool layer; // false: put the noise on a flat layer instead of the sphere

Cloud cotton(sampler2D panorama, vec3 direction, float turned, float width)
{
    vec3 p = layer ? vec3(1.2 * direction.xz / max(direction.y, 0.03), 0.0) : 4.0 * direction;
    float cover = smoothstep(0.44, 0.66, octaveNoise(p + 9.0, 5, 0.5, 2.0).x);
    return Cloud(cover, 0.7 * cover, 0.0);
}

#define cloudPanorama cotton
#include "20_clouds_and_weather.frag"
