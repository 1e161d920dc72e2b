// Experiment of chapter 10: the sheet in the workshop's colours or in the chapter's, as seen by an eye that has all
// cones or lacks one kind of cone.
#include "main.glsl"
#define rayColour chapterRayColour
#include "10_distance_in_the_plane.frag"
#undef rayColour

uniform bool workshop; // false: the workshop's colours, green outside and red inside, instead of the chapter's
uniform int  eye;      // 2 in [0, 2]: 0 all cones, 1 no long-wave cones, 2 no medium-wave cones

// The linear light that an eye without long-wave or medium-wave cones sees: three factors each for red, green and blue.
// Source: G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, 'A physiologically-based model for simulation of color
// vision deficiency', IEEE Transactions on Visualization and Computer Graphics 15 (2009).
const mat3 NO_LONG = mat3(0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998);
const mat3 NO_MIDDLE = mat3(0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881);

vec3 decodeSRGB(vec3 v)
{
    return mix(pow((v + 0.055) / 1.055, vec3(2.4)), v / 12.92, vec3(lessThanEqual(v, vec3(0.04045))));
}

// The workshop's colours: green outside, red inside and black near the outline. The lines come from a cosine of the
// distance, and the white outline is a band of small distances.
vec3 workshopColour(float d)
{
    float bright = (1.0 - exp(-3.0 * abs(d))) * (0.8 + 0.2 * cos(150.0 * d));
    return mix(d > 0.0 ? vec3(0.0, bright, 0.0) : vec3(bright, 0.0, 0.0), vec3(1.0), 1.0 - smoothstep(0.008, 0.016, abs(d)));
}

vec3 rayColour(Ray ray)
{
    vec3 ours = chapterRayColour(ray);
    vec2 p = planePoint(screenPosition(gl_FragCoord.xy + iPixelOffset));
    vec3 light = decodeSRGB(workshop ? workshopColour(sheetDistance(p)) : ours);
    return encodeSRGB(eye == 0 ? light : light * (eye == 1 ? NO_LONG : NO_MIDDLE));
}
