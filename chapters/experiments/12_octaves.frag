// Experiment of chapter 12: a stone cut from a block. Its colour is the sum of four octaves of a
// volume texture, with the weights of the workshop: 0.5, 0.25, 0.125 and 0.0625 add up to 0.9375,
// so the stone is too dark by a sixteenth. Switch on the parameter `divided` to correct the colour.
#include "main.glsl"
#include "texture.glsl"

uniform sampler3D volume; // "noise.png" linear repeat 64: value noise, 16 cells per repeat
uniform bool divided;     // false: divide by the sum of the weights

vec4 fourOctaves(vec3 p, Footprint f)
{
    vec4 sum = vec4(0.0);
    float weight = 0.5, scale = 0.25;
    for (int i = 0; i < 4; i++) {
        sum += weight * textureInSpace(volume, scale * p, footprintSeen(f, mat3(1.0), scale));
        weight *= 0.5;
        scale *= 2.0;
    }
    return vec4(divided ? sum.rgb / 0.9375 : sum.rgb, 1.0);
}

#define textureOnPlanes(picture, p, f, weights) fourOctaves(p, f)
#include "12_textures.frag"
