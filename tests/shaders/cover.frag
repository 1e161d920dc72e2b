// For bound.c: all rays of the picture are the same; they run towards or away from a plane, or past
// a ball.

#include "main.glsl"
#include "march.glsl"

uniform float slope;     // 0.5 in [-1, 1]: sine of the angle between the ray and the plane; below 0 the ray moves away
uniform float gap;       // 0 in [0, 4], scene units: distance between the ray and a ball of radius 1; 0 for the plane
uniform float far;       // 20 in [0, 100], scene units: the length of the ray
uniform float threshold; // 0.001 in [0.00001, 1], scene units: distance that counts as a hit

Ray pixelRay(vec2 screen)
{
    if (gap > 0.0)
        return Ray(vec3(-0.5 * far, 1.0 + gap, 0.0), vec3(1.0, 0.0, 0.0));
    return Ray(vec3(0.0, 1.0, 0.0), vec3(sqrt(1.0 - slope * slope), -slope, 0.0));
}

float sceneDistance(vec3 p)
{
    return gap > 0.0 ? length(p) - 1.0 : p.y;
}

vec3 rayColour(Ray ray)
{
    return vec3(march(ray, 0.0, far, threshold, 4096).t);
}
