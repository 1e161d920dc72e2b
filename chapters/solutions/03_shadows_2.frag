// Solution of exercise 03.2: the shadow ray starts a little along the light instead of along the
// normal. Where the light grazes, that is not far enough from the surface: acne.
//
// The chapter's call of shadowRay is turned into a call of startAlongLight.
#include "main.glsl"
#include "shadow.glsl"

Ray startAlongLight(vec3 p, vec3 normal, vec3 toLight, float offset)
{
    return Ray(p + offset * toLight, toLight);
}

#define shadowRay startAlongLight
#include "03_shadows.frag"
