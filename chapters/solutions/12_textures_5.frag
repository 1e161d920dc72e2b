// Solution to exercise 12.5: eight lookups along the elliptical footprint, each as wide as the short
// axis and an eighth as long as the long axis.
//
// The chapter's calls to textureOnSlide, for plank and cloth, are replaced by calls to
// textureAlong.
#include "main.glsl"
#include "texture.glsl"

const int LOOKUPS = 8;

vec4 textureAlong(sampler2D picture, Slide slide)
{
    vec4 sum = vec4(0.0);
    for (int i = 0; i < LOOKUPS; i++) {
        float offset = (float(i) + 0.5) / float(LOOKUPS) - 0.5;
        sum += textureGrad(picture, slide.at + offset * slide.along, slide.across, slide.along / float(LOOKUPS));
    }
    return sum / float(LOOKUPS);
}

#define textureOnSlide textureAlong
#include "12_textures.frag"
