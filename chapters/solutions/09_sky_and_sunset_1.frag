// Solution to exercise 09.1: the seasons. Latitude and declination become parameters.
#include "main.glsl"
#define rayColour chapterRayColour
#include "09_sky_and_sunset.frag"
#undef rayColour

uniform float latitude;    // 43.6 in [-66, 66] step 1, degrees: latitude of the city
uniform float declination; // -23.44 in [-23.44, 23.44] step 1, degrees: declination of the sun; lowest in December

vec3 rayColour(Ray ray)
{
    vec3 sun = sunDirection(hour(), latitude, declination);
    vec3 upwards = vec3(ray.direction.x, max(ray.direction.y, 0.0), ray.direction.z);
    return cityColour(ray, sun, skyLight(upwards, sun));
}
