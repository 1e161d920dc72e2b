// Solution of exercise 06.1: the Sierpinski triangle in the plane. Two folds a level, three copies.
#include "main.glsl"
#include "symmetry.glsl" // opReflect

uniform int levels; // 6 in [0, 12]: how often each triangle is cut in three

const float RADIUS = 1.7; // from the middle to a corner, units

// The place in the plane travels in the ray's origin: the picture is 4 units high.
Ray pixelRay(vec2 screen)
{
    return Ray(vec3(2.0 * screen, 0.0), vec3(0.0, 0.0, -1.0));
}

// The triangle's three lines. Inside exact; outside between d / 2 and d.
float sdTriangleLines(vec3 p, float radius)
{
    return max(0.8660254 * abs(p.x) + 0.5 * p.y, -p.y) - 0.5 * radius;
}

// The mirrors stand halfway between the upper corner, from which q is measured, and the other two.
float sceneDistance(vec3 p)
{
    vec3 q = p - vec3(0.0, RADIUS - 0.35, 0.0);
    float radius = RADIUS;
    for (int i = 0; i < levels; i++) {
        q = opReflect(q, vec3(-0.5, 0.8660254, 0.0), 0.8660254 * radius);
        q = opReflect(q, vec3(0.5, 0.8660254, 0.0), 0.8660254 * radius);
        radius *= 0.5;
    }
    return sdTriangleLines(q + vec3(0.0, radius, 0.0), radius);
}

vec3 rayColour(Ray ray)
{
    float away = distanceAt(ray.origin);
    float pixels = away * 0.25 * iResolution.y;
    float fromLine = abs(away / 0.1 - floor(away / 0.1 + 0.5)) * 0.1 * 0.25 * iResolution.y;
    vec3 outside = mix(vec3(0.93, 0.66, 0.36), vec3(0.20, 0.24, 0.42), 1.0 - exp(-2.5 * max(away, 0.0)));
    outside *= 1.0 - 0.25 * clamp(1.0 - fromLine, 0.0, 1.0);
    return mix(vec3(1.0, 0.97, 0.90), outside, clamp(pixels + 0.5, 0.0, 1.0));
}
