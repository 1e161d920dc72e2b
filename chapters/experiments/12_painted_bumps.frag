// Experiment of chapter 12: the cloth's threads stand out. How high they lie is a second picture, that of their
// colours' own program; its slope tilts the normal, and the shape stays as it was.
#include "main.glsl"
#include "texture.glsl"

uniform sampler2D heights; // "cloth_height.png" linear repeat: how high the threads lie
uniform float     thread;  // 0.008 in [0, 0.02] step 0.001, scene units: how thick they seem

const float REPEATED = 0.8; // repeats of the cloth, a scene unit

vec3 clothNormal(vec3 normal, vec3 p, vec3 direction, float width, bool isCloth)
{
    int axis = abs(normal.y) > 0.6 ? 1 : (abs(normal.x) > abs(normal.z) ? 0 : 2);
    Footprint f = footprintSeen(footprintOn(direction, normal, width), mat3(1.0), REPEATED);
    float reach = max(1.0 / 512.0, REPEATED * width); // a texel, and not less than a pixel
    vec4 height = heightOnSlide(heights, slideAlong(REPEATED * p, f, axis), axis, reach, isCloth);
    return isCloth ? bumpedNormal(normal, thread * REPEATED * height.yzw) : normal;
}

#define bumpedNormal(normal, gradient) clothNormal(bumpedNormal(normal, gradient), p, direction, width, isCloth)
#include "12_textures.frag"
