// Experiment of chapter 10: the distances of two discs, mixed half and half. The outline is an
// ellipse with the centres as its foci. Dark lines belong to the mixture, white lines to the true
// distance. Red shows by how much the mixture is too small, and is strongest where the error is at
// least 0.25. The true distance is computed as the smallest distance to 256 chords of a quarter of
// the ellipse.
#include "main.glsl"
#include "plane.glsl"    // sdCircle, sdSegment
#include "coverage.glsl" // coverage
#include "camera.glsl"   // focalLength

uniform float apart;  // 0.5 in [0, 0.6] step 0.05, units: from the origin to each centre
uniform float radius; // 0.625 in [0.61, 1] step 0.015, units: radius of both discs

Ray pixelRay(vec2 screen)
{
    return Ray(vec3(iCameraPosition.z / focalLength * screen, 0.0), vec3(1.0, 0.0, 0.0));
}

float sceneDistance(vec3 p)
{
    vec2 centre = vec2(apart, 0.0);
    return mix(sdCircle(p.xy + centre, radius), sdCircle(p.xy - centre, radius), 0.5);
}

// The distance to the ellipse, computed in the quadrant that contains p.
float ellipseDistance(vec2 p)
{
    vec2 axes = vec2(radius, sqrt(radius * radius - apart * apart)), before = vec2(axes.x, 0.0);
    float nearest = 1e6;
    for (int i = 1; i <= 256; i++) {
        float angle = radians(90.0) * float(i) / 256.0;
        vec2 next = axes * vec2(cos(angle), sin(angle));
        nearest = min(nearest, sdSegment(abs(p), before, next));
        before = next;
    }
    return dot(p / axes, p / axes) < 1.0 ? -nearest : nearest;
}

// Lines where a distance is a multiple of 0.1; the line at 0 is thicker. Returns the share of the
// pixel that the lines cover, from 0 to 1.
float levels(float d, float pixel)
{
    float nearest = 0.1 * floor(10.0 * d + 0.5);
    return coverage((nearest == 0.0 ? 1.4 : 0.6) - abs(d - nearest) / pixel, 1.0);
}

vec3 rayColour(Ray ray)
{
    float pixel = 2.0 * iCameraPosition.z / focalLength / iResolution.y;
    float asked = distanceAt(ray.origin), truth = ellipseDistance(ray.origin.xy);
    vec3 colour = asked < 0.0 ? vec3(0.62, 0.72, 0.84) : vec3(0.95, 0.90, 0.80);
    colour = mix(colour, vec3(0.80, 0.22, 0.12), 0.85 * clamp(4.0 * (abs(truth) - abs(asked)), 0.0, 1.0));
    colour = mix(colour, vec3(1.0), 0.9 * levels(truth, pixel));
    return mix(colour, vec3(0.05, 0.07, 0.18), 0.9 * levels(asked, pixel));
}
