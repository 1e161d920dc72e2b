// Experiment of chapter 19: a hemisphere of stars drawn twice, in an equal-area projection centred
// on the diagonal (1, 1, 1) of the grid. On the left are the article's cells, the cubes that a
// sphere meets; on the right are cells of equal solid angle.
#include "main.glsl"
#include "night.glsl"

uniform float side;  // 60 in [10, 400] step *1.2: cubes along the radius of the sphere
uniform float share; // 0.12 in [0, 1] step 0.02: share of the cubes that contain a star

Ray pixelRay(vec2 screen)
{
    return Ray(vec3(0.0), vec3(screen, 1.0));
}

float sceneDistance(vec3 p)
{
    return length(p);
}

vec3 rayColour(Ray ray)
{
    vec2 point = vec2(abs(ray.direction.x) - 0.89, ray.direction.y) / 0.84;
    float square = dot(point, point), out_ = sqrt(max(2.0 - square, 0.0));
    vec3 p = vec3(point * out_, 1.0 - square); // Lambert's map, which preserves areas
    vec3 right = normalize(vec3(1.0, -1.0, 0.0)), ahead = normalize(vec3(1.0)), up = cross(ahead, right);
    vec3 direction = p.x * right + p.y * up + p.z * ahead;
    uvec3 cell = uvec3(ivec3(floor(side * direction) + 1000.0));
    uvec4 bits = stirredBits(uvec4(cell.x * 73856093u ^ cell.y * 19349663u ^ cell.z * 83492791u));
    float cubes = float(bits.x >> 8u) / 16777216.0 < share ? 1.0 : 0.0;
    float even = clamp(3e7 * starLight(direction, 0.0035).g - 1.0, 0.0, 1.0);
    float stars = ray.direction.x < 0.0 ? cubes : even;
    return square < 1.0 ? mix(vec3(0.02, 0.03, 0.07), vec3(1.0, 0.97, 0.9), stars) : vec3(0.10, 0.11, 0.14);
}
