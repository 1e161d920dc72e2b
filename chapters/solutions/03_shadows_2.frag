// Solution to exercise 03.2: the offset of the shadow ray points towards the light instead of along
// the normal. At grazing angles, the start is then too close to the surface, which causes acne.
//
// The macro turns the chapter's call to shadowRay into a call to startAlongLight.
#include "main.glsl"
#include "shadow.glsl"

Ray startAlongLight(vec3 p, vec3 normal, vec3 toLight, float offset)
{
    return Ray(p + offset * toLight, toLight);
}

#define shadowRay startAlongLight
#include "03_shadows.frag"
