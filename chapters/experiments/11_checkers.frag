// Experiment of chapter 11: an endless plane of squares under two balls, averaged over the area
// that a pixel covers.
//
//   way=0  the pattern is evaluated only at the centre of the pixel
//   way=1  the chapter's method: the footprint from the ray, the normal and t
//   way=2  the workshop's method: the footprint from fwidth, the difference between neighbouring
//          pixels. Where one of two neighbours shows a ball and the other the plane, this
//          difference is no footprint, as the outlines of the balls show
//
// Apart from the figures, only this shader and 20_seam.frag use derivatives across pixels.
#include "main.glsl"
#include "orthographic.glsl"
#include "cone.glsl"
#include "primitives.glsl"
#include "checkers.glsl"
#include "lighting.glsl"
#include "normal.glsl"

uniform int   way;             // 1 in [0, 2]: 0 centre of the pixel, 1 footprint of the ray, 2 fwidth
uniform float tile;            // 0.5 in [0.1, 2] step 0.1, scene units: side of a square
uniform float turn;            // 20 in [0, 90] step 5, degrees: rotation of the pattern about the vertical
uniform float framingDistance; // 4 in [1, 40] step 0.5, scene units: distance from the camera to the plane whose size does not change

const float FAR = 1e4;

Ray pixelRay(vec2 screen)
{
    return projectionRay(screen, framingDistance);
}

float sceneDistance(vec3 p)
{
    return min(sdSphere(p - vec3(-0.8, 0.6, 0.0), 0.6), sdSphere(p - vec3(0.7, 0.35, 0.9), 0.35));
}

// The chapter's footprint, for any view between perspective and orthographic.
Footprint footprintOf(vec3 p, Ray ray, float t, mat2x3 axes)
{
    float cosine = dot(ray.direction, iCameraForward);
    float depth = mix(t * cosine, framingDistance, orthographic);
    return planeFootprint(p, ray.direction, vec3(0.0, 1.0, 0.0), depth * pixelSpread(),
                          (1.0 - orthographic) * cosine / depth, axes);
}

vec3 rayColour(Ray ray)
{
    Hit hit = march(ray, 0.0, 30.0, 0.001, 128);
    float t = ray.direction.y < 0.0 ? min(-ray.origin.y / ray.direction.y, FAR) : FAR;
    t = hit.found ? hit.t : t;
    vec3 p = ray.origin + t * ray.direction;
    float c = cos(radians(turn)) / tile, s = sin(radians(turn)) / tile;
    mat2x3 axes = mat2x3(c, 0.0, s, -s, 0.0, c);
    Footprint seen = footprintOf(p, ray, t, axes);
    vec2 middle = way == 1 ? seen.middle : p * axes;
    vec2 width = way == 0 ? vec2(1e-4) : way == 1 ? seen.width : fwidth(p * axes) + 0.001;
    vec3 plane = mix(vec3(0.02), vec3(0.80), checkers(middle, width));
    vec3 ball = vec3(0.55, 0.17, 0.07) * (0.15 + 0.85 * lambert(normalAt(p, 0.002), vec3(-0.48, 0.64, 0.6)));
    vec3 sky = vec3(0.35, 0.45, 0.55);
    return encodeSRGB(hit.found ? ball : t < FAR ? plane : sky);
}
