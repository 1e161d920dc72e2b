// Experiment of chapter 19: the article's projection of the moon, which consists of a scale and a
// compensating factor.
#include "main.glsl"
#include "night.glsl"

uniform float compensation; // 1 in [0.5, 2] step 0.05: the article has 1.4

// The article's moon has the radius 0.03. The offset from the centre, times 23.57 / 2 and the
// factor, is meant to run from -1/2 to 1/2 across the disc; in this course's texture, the disc
// takes up 0.94 of the width. The texture is shown as it is, without sunlight.
vec3 articleFace(sampler2D face, vec2 point, float width, vec3 toSun, float relief)
{
    vec2 foot = vec2(0.47 * width, 0.0), offset = 0.03 * point;
    vec2 at = 0.5 + 0.94 * 23.57 / 2.0 * compensation * offset;
    return vec3(4.0 * textureGrad(face, at, foot.xy, foot.yx).x);
}

#define moonFace articleFace
#include "19_moon_and_stars.frag"
