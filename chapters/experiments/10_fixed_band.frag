// Experiment of chapter 10: lines that are drawn where the distance is in a band of fixed width.
// From nearby they are thick, from far away they break up into dots, and where the gradient is
// small they swell.
#include "main.glsl"
#define rayColour chapterRayColour
#include "10_distance_in_the_plane.frag"
#undef rayColour

uniform float band; // 0.008 in [0.001, 0.05] step 0.001, units: width of the lines; the outline is twice as wide

vec3 rayColour(Ray ray)
{
    vec2 p = planePoint(screenPosition(gl_FragCoord.xy + iPixelOffset));
    float d = distanceAt(vec3(p, 0.0)), level = floor(d / lineSpacing + 0.5);
    vec3 light = d > 0.0 ? mix(PAPER, GLOW, exp(-d / 0.3)) : mix(DEEP, EDGE, exp(d / 0.06));
    if (abs(d - level * lineSpacing) < 0.5 * band)
        light = mix(light, d > 0.0 ? LINE_OUT : LINE_IN, 0.6);
    return encodeSRGB(abs(d) < band ? OUTLINE : light);
}
