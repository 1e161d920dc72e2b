// Experiment of chapter 03: a lamp that hangs between the objects on the stage, and a shadow ray
// that does not stop at the lamp. The report invites this mistake by mixing a direction (section
// 1.5.2) with a position (section 1.5.3). Objects behind the lamp cast shadows that are upside
// down. Switch on the parameter `stopping` to correct the mistake.
//
// The chapter's rayColour is renamed and not used; everything else is as in the chapter.
#include "main.glsl"
#define rayColour chapterRayColour
#include "03_shadows.frag"
#undef rayColour

uniform bool stopping; // false: end the shadow ray at the lamp, where it should end

const vec3  HUNG_LAMP = vec3(-0.3, 0.9, 0.6);
const float HUNG_REFERENCE = 1.2; // distance at which the hanging lamp's light equals LAMP_COLOUR, scene units

// The lamp itself, drawn as a small disc that shows its position.
//   far  t at which the ray ends, scene units
vec3 glow(Ray ray, float far)
{
    float along = dot(HUNG_LAMP - ray.origin, ray.direction);
    float aside = distance(HUNG_LAMP, ray.origin + along * ray.direction);
    return along < far ? LAMP_COLOUR * (1.0 - smoothstep(0.04, 0.06, aside)) : vec3(0.0);
}

// The light that the hanging lamp adds. visibility() takes no step where the surface faces away
// from the lamp.
vec3 hungLight(vec3 p, vec3 normal)
{
    vec3 toLamp = HUNG_LAMP - p;
    float away = length(toLamp);
    float seen = visibility(p, normal, toLamp / away, stopping ? away : FAR);
    return seen * LAMP_COLOUR * lambert(normal, toLamp / away) * fallOff(away, HUNG_REFERENCE);
}

vec3 rayColour(Ray ray)
{
    vec2 interval = sceneInterval(ray);
    Hit hit = march(ray, interval.x, interval.y, hitThreshold, maxSteps);
    vec3 light = skyLight(ray.direction);
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction;
        vec3 normal = normalAt(p, normalStep);
        vec3 coldLight = lampLight(normal, COLD_LAMP - p, COLD_COLOUR);
        light = OBJECT_COLOUR * (AMBIENT + hungLight(p, normal) + coldLight);
    }
    light += glow(ray, hit.found ? hit.t : FAR);
    return encodeSRGB(light);
}
