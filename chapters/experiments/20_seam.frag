// Experiment of chapter 20: a fault caused by the hardware's footprint, a line where the panorama
// begins and ends.
//
// Two neighbouring pixels there differ by a whole turn in u. The hardware takes this difference for
// the size of the pixel and reads the last mip level, which is the mean of the whole panorama.

#include "main.glsl"
#include "clouds.glsl"

uniform int way; // 0 in [0, 3]: footprint: 0 the hardware's, 1 that of the second coordinate if under half, 2 the ray's, 3 that of the second coordinate if smaller

Cloud panoramaByWay(sampler2D panorama, vec3 direction, float turned, float width)
{
    vec2 uv = panoramaUV(direction), other = vec2(fract(uv.x), uv.y); // uv jumps in the south, other in the north
    float size = fwidth(uv.x), otherSize = fwidth(other.x);
    vec2 at = way == 1 && otherSize < 0.5 * size || way == 3 && otherSize < size ? other : uv;
    vec4 texel = texture(panorama, at + vec2(turned, 0.0));
    Cloud cloud = Cloud(texel.x, texel.y, 2.0 * texel.z - 1.0), mended = cloudPanorama(panorama, direction, turned, width);
    if (way == 2)
        cloud = mended;
    return cloud;
}

#define cloudPanorama panoramaByWay
#include "20_clouds_and_weather.frag"
