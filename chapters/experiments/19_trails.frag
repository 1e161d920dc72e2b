// Experiment of chapter 19: a long exposure, which adds up the stars at many moments.
#include "main.glsl"
#include "night.glsl"

uniform float hours;     // 3 in [0, 12] step 0.5, hours: time during which the shutter is open, from timeOfDay on
uniform int   moments;   // 192 in [1, 1000] step *2: moments of which the exposure consists
uniform float longer;    // 3 in [0, 12] step 0.5, stops: additional light, compared with a short exposure

// The sky turns about the third axis of the stars' frame.
vec3 trailLight(vec3 direction, float width)
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < moments; i++) {
        float angle = 2.0 * NIGHT_PI * hours / SIDEREAL_DAY * (float(i) + 0.5) / float(moments);
        float c = cos(angle), s = sin(angle);
        sum += starLight(vec3(c * direction.x - s * direction.y, s * direction.x + c * direction.y, direction.z), width);
    }
    return exp2(longer) / float(moments) * sum;
}

#define starLight trailLight
#include "19_moon_and_stars.frag"
