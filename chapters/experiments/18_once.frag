// Chapter 18's picture in light that has been scattered only once.
#include "main.glsl"
#define tableSky wholeSky
#include "sky_table.glsl"
#undef tableSky
vec3 tableSky(sampler2D sunward, sampler2D away, vec3 direction, vec3 sun);
#include "18_sky_from_tables.frag"

vec3 tableSky(sampler2D sunward, sampler2D away, vec3 direction, vec3 sun)
{
    vec2 uv = skyUV(sun.y, direction.y);
    SkyScale scale = skyScale(sun.y, uv.y);
    float c = dot(direction, sun), share = sunwardShare(levelCosine(direction, sun), sun.y, uv.y);
    return max(mix(onceLight(away, uv, c, scale), onceLight(sunward, uv, c, scale), share), 0.0);
}
