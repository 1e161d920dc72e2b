// Experiment of chapter 21: one exposure for all hours, that of the hour `exposedAt`.
#include "main.glsl"
#include "film.glsl"

vec3 exposedOnce(vec3 light, float stops);

#define exposed exposedOnce
#include "21_a_landscape.frag"
#undef exposed

uniform float exposedAt; // 12 in [0, 24] step 0.5, hours: the hour for which the camera is set

vec3 exposedOnce(vec3 light, float stops)
{
    float hour = theHour;
    theHour = exposedAt;
    float once = hourNow().stops;
    theHour = hour;
    return exposed(light, once);
}
