// Solution of exercise 04.1: hue, saturation and value taken as the numbers of a screen, and decoded
// to linear light. What lies between two knees becomes darker and purer: orange is orange.
//
// Every hsvToRGB of the chapter becomes a paintedHSV.
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
