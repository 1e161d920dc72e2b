// Solution to exercise 03.3: rays are clipped to the ball around the scene's box instead of to the
// box itself.
//
// The macro turns the chapter's call to boxInterval into a call to ballInterval.
#include "main.glsl"
#include "bounds.glsl"

vec2 ballInterval(Ray ray, vec3 low, vec3 high)
{
    vec3 toCentre = 0.5 * (low + high) - ray.origin;
    float radius = 0.5 * length(high - low);
    float nearest = dot(toCentre, ray.direction);
    float under = radius * radius - (dot(toCentre, toCentre) - nearest * nearest);
    float chord = sqrt(max(under, 0.0));
    return under < 0.0 ? vec2(1.0, 0.0) : vec2(max(0.0, nearest - chord), nearest + chord);
}

#define boxInterval ballInterval
#include "03_shadows.frag"
