// Solution to exercise 20.1: the high layer of clouds over a flat Earth.
#include "main.glsl"
#include "clouds.glsl"

Cloud flatLayer(sampler2D layer, vec3 eye, vec3 direction, float altitude, float period, float width)
{
    float climb = max(direction.y, 0.0005), t = (altitude - eye.y) / climb;
    vec2 uv = (eye.xz + t * direction.xz) / period;
    float reach = width * t / climb / period;
    float cover = textureGrad(layer, uv, vec2(reach, 0.0), vec2(0.0, reach)).x;
    return Cloud(cover, 0.9 * cover, 0.0);
}

#define cloudLayer flatLayer
#include "20_clouds_and_weather.frag"
