// Experiment of chapter 20: the contents of the panoramas. The left third shows the cover of the
// clouds, the middle third the light that reaches them from above, and the right third the light
// from the right minus that from the left, with grey for 0.

#include "main.glsl"
#define rayColour chapterColour
#include "20_clouds_and_weather.frag"
#undef rayColour

vec3 rayColour(Ray ray)
{
    Cloud cloud = lowClouds(vec3(ray.direction.x, max(ray.direction.y, 0.0), ray.direction.z), 2.0 * pixelSpread());
    int third = int(3.0 * float(iPixel.x) / iResolution.x);
    float number = third == 0 ? cloud.cover : (third == 1 ? cloud.above : 0.5 + 0.5 * cloud.side);
    return vec3(ray.direction.y < 0.0 ? 0.0 : number);
}
