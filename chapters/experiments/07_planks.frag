// Experiment of chapter 07: planks that are turned in their cells. The plank in a point's cell need
// not be the nearest, so rays step through the neighbouring plank. To prevent this, evaluate the
// nearer neighbour too, or mirror every other cell, which makes a different fence.
#include "main.glsl"
#include "camera.glsl"
#include "march.glsl"
#include "normal.glsl"
#include "primitives.glsl"
#include "lighting.glsl"
#include "repetition.glsl"

uniform int   asked;  // 0 in [0, 2]: 0 only the cell's plank, 1 also the nearer neighbour's, 2 mirrored cells
uniform float turn;   // 30 in [0, 30] step 2.5, degrees: how far each plank is turned
uniform float period; // 2.5 in [2.5, 6] step 0.25, scene units: width of a cell

const float FAR = 60.0;
const vec3  SUN = vec3(0.48, 0.64, 0.6);

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// A plank 2.4 scene units wide and 0.4 thick, turned about the vertical.
//   x  along the fence, from the plank's centre
float plankDistance(float x, vec3 p)
{
    float c = cos(radians(turn));
    float s = sin(radians(turn));
    return sdBox(vec3(c * x - s * p.z, p.y - 1.0, s * x + c * p.z), vec3(1.2, 1.0, 0.2));
}

float sceneDistance(vec3 p)
{
    float own = plankDistance(asked == 2 ? opRepeatMirrored(p.x, period) : opRepeat(p.x, period), p);
    float next = plankDistance(p.x - period * cellNeighbour(p.x, period), p);
    return asked == 1 ? min(own, next) : own;
}

vec3 skyLight(vec3 direction)
{
    return mix(vec3(0.20, 0.24, 0.24), vec3(0.010, 0.035, 0.07), smoothstep(-0.05, 0.5, direction.y));
}

// The ground is found with a formula, and the planks with the march.
vec3 rayColour(Ray ray)
{
    float ground = ray.direction.y < 0.0 ? min(-ray.origin.y / ray.direction.y, FAR) : FAR;
    Hit hit = march(ray, 0.0, ground, 0.001, 256);
    vec3 p = ray.origin + hit.t * ray.direction;
    vec3 normal = hit.found ? normalAt(p, 0.001) : vec3(0.0, 1.0, 0.0);
    vec3 albedo = hit.found ? vec3(0.75, 0.42, 0.20) : vec3(0.16, 0.17, 0.15);
    vec3 light = albedo * (vec3(1.0, 0.85, 0.6) * lambert(normal, SUN) + vec3(0.07, 0.11, 0.16));
    float clear = hit.found || ground < FAR ? exp(-min(hit.t, ground) / 25.0) : 0.0;
    return encodeSRGB(mix(skyLight(ray.direction), light, clear));
}
