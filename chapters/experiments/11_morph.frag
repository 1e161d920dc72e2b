// Experiment of chapter 11: a square that changes into a disc. The picture is a diagram, in the
// plane, of (1 - share) square + share disc, where square and disc are the two distances. Dark
// lines connect points where this value is the same multiple of 0.25. Red shows by how much the
// slope is less than 1, and is strongest where the slope is at most one half. Where the picture is
// red, the value is not a distance, because a distance has slope 1 wherever it has a slope. The
// slope is never more than 1.
#include "main.glsl"
#include "camera.glsl"
#include "primitives.glsl"

uniform float share; // 0.5 in [0, 1] step 0.05: share of the disc
uniform float apart; // 0 in [0, 2] step 0.1, scene units: distance between the centres of square and disc

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float sceneDistance(vec3 p)
{
    p.x += 0.5 * apart;
    return mix(sdBox(p, vec3(0.8, 0.8, 9.0)), sdSphere(vec3(p.x - apart, p.y, 0.0), 0.9), share);
}

float slopeAt(vec3 p, float h)
{
    vec2 slope = vec2(sceneDistance(p + vec3(h, 0.0, 0.0)) - sceneDistance(p - vec3(h, 0.0, 0.0)),
                      sceneDistance(p + vec3(0.0, h, 0.0)) - sceneDistance(p - vec3(0.0, h, 0.0)));
    return length(slope) / (2.0 * h);
}

// Lines where a value is a multiple of 0.25; the line at 0 is thicker. Returns the share of the
// pixel that the lines cover, from 0 to 1.
float levels(float value, float pixel)
{
    float nearest = 0.25 * floor(4.0 * value + 0.5);
    float width = nearest == 0.0 ? 3.0 : 1.2;
    return clamp(0.5 * width + 0.5 - abs(value - nearest) / pixel, 0.0, 1.0);
}

vec3 rayColour(Ray ray)
{
    float pixel = 4.0 / iResolution.y;
    vec3 p = vec3(2.0 * screenPosition(gl_FragCoord.xy + iPixelOffset), 0.0);
    float value = sceneDistance(p), slope = slopeAt(p, 0.002);
    vec3 colour = value < 0.0 ? vec3(0.62, 0.72, 0.84) : vec3(0.95, 0.93, 0.88);
    colour = mix(colour, vec3(0.86, 0.30, 0.22), 0.85 * clamp(2.0 * (1.0 - slope), 0.0, 1.0));
    return mix(colour, vec3(0.07, 0.10, 0.20), levels(value, pixel * max(slope, 0.2)));
}
