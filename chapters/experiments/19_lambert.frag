// Experiment of chapter 19: the moon as a matt ball that obeys Lambert's law.
#include "main.glsl"
#include "night.glsl"

vec3 mattFace(sampler2D face, vec2 point, float width, vec3 toSun, float relief)
{
    point /= max(length(point), 1.0);
    vec3 normal = vec3(point, sqrt(max(1.0 - dot(point, point), 0.0)));
    vec2 foot = vec2(0.47 * width, 0.0);
    float albedo = 0.40 * textureGrad(face, 0.5 + 0.47 * point, foot.xy, foot.yx).x;
    return 10.2 * albedo * max(dot(normal, toSun), 0.0) * vec3(1.06, 1.0, 0.88);
}

#define moonFace mattFace
#include "19_moon_and_stars.frag"
