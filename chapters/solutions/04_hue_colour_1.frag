// Solution to exercise 04.1: the results of hsvToRGB are read as encoded values and decoded to
// linear light. A channel between 0 and 1 becomes smaller, so amber turns orange.
//
// A macro replaces every hsvToRGB of the chapter with paintedHSV.
#include "main.glsl"
#include "hue.glsl"

vec3 paintedHSV(float hue, float saturation, float value)
{
    vec3 v = hsvToRGB(hue, saturation, value);
    vec3 high = pow((v + 0.055) / 1.055, vec3(2.4));
    return mix(high, v / 12.92, vec3(lessThanEqual(v, vec3(0.04045))));
}

#define hsvToRGB paintedHSV
#include "04_hue_colour.frag"
