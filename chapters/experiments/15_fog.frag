// Experiment of chapter 15: fog at the wrong stage. The parameter `fogWay` selects one of three
// fogs: the correct one; one that is mixed into the encoded values, after film and encoding; and
// one of a single grey, with an amount that depends only on the distance to the hit, so that the
// sky has no fog and the sun does not affect the fog.
#include "main.glsl"
#define rayColour chapterRayColour
#include "15_the_picture.frag"
#undef rayColour

uniform int fogWay; // 1 in [0, 2]: 0 in the light, 1 after the encoding, 2 one grey that depends only on the distance, none on the sky

const vec3 GREY = vec3(0.30, 0.33, 0.38); // linear

// Convert light to encoded values.
vec3 shown(vec3 light)
{
    float share = vignette ? cosineFourth(screenPosition(vec2(iPixel) + 0.5), focalLength) : 1.0;
    return encodeSRGB(developed(exposed(share * light, exposure)));
}

vec3 rayColour(Ray ray)
{
    Seen seen = seenAlong(ray);
    vec3 right = shown(throughFog(seen.light, seen.fog, seen.depth));
    vec3 late = throughFog(shown(seen.light), shown(seen.fog), seen.depth);
    vec3 grey = shown(seen.way < SKY ? throughFog(seen.light, GREY, fogDensity * seen.way) : seen.light);
    return fogWay == 0 ? right : (fogWay == 1 ? late : grey);
}
