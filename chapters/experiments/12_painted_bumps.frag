// Experiment of chapter 12: the threads of the cloth appear raised. Their heights are in a second
// picture, computed from the same weave as the colours of the cloth. The slope of these heights
// tilts the normal, but the shape does not change.
#include "main.glsl"
#include "texture.glsl"

uniform sampler2D heights; // "cloth_height.png" linear repeat: heights of the threads
uniform float     thread;  // 0.008 in [0, 0.02] step 0.001, scene units: apparent height of the threads

const float REPEATED = 0.8; // repeats of the cloth per scene unit

vec3 clothNormal(vec3 normal, vec3 p, vec3 direction, float width, bool isCloth)
{
    int axis = abs(normal.y) > 0.6 ? 1 : (abs(normal.x) > abs(normal.z) ? 0 : 2);
    Footprint f = footprintSeen(footprintOn(direction, normal, width), mat3(1.0), REPEATED);
    float reach = max(1.0 / 512.0, REPEATED * width); // a texel, but at least a pixel
    vec4 height = heightOnSlide(heights, slideAlong(REPEATED * p, f, axis), axis, reach, isCloth);
    return isCloth ? bumpedNormal(normal, thread * REPEATED * height.yzw) : normal;
}

#define bumpedNormal(normal, gradient) clothNormal(bumpedNormal(normal, gradient), p, direction, width, isCloth)
#include "12_textures.frag"
