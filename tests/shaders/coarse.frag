// For coarse.c: four balls and a wire. Each pixel's march begins where the coarse march of its
// block ended.

#include "main.glsl"
#include "orthographic.glsl"
#include "cone.glsl"
#include "coarse.glsl"

uniform float framing;    // 6 in [1, 40], scene units: from the camera's plane to the plane that keeps its size
uniform vec4  ball0;      // 0, 0, 0, 1 in [-40, 40], scene units: centre and radius
uniform vec4  ball1;      // 0, 0, 0, 1 in [-40, 40], scene units: centre and radius
uniform vec4  ball2;      // 0, 0, 0, 1 in [-40, 40], scene units: centre and radius
uniform vec4  ball3;      // 0, 0, 0, 1 in [-40, 40], scene units: centre and radius
uniform vec3  wireFrom;   // 0, 0, 0 in [-40, 40], scene units: one end of the wire
uniform vec3  wireTo;     // 1, 0, 0 in [-40, 40], scene units: the other end of the wire
uniform float wireRadius; // 0.01 in [0.0001, 1], scene units: radius of the wire
uniform float threshold;  // 0.001 in [0.00001, 1], scene units: distance that counts as a hit, at the eye
uniform float growth;     // 0 in [0, 4], half pixels: how fast the threshold grows along the ray
uniform float factor;     // 1 in [0.1, 1]: factor by which the distance is multiplied
uniform float moved;      // 0 in [0, 1], scene units: how far the last sample's ray is to the right of the first one's

Ray pixelRay(vec2 screen)
{
    Ray ray = projectionRay(screen, framing);
    ray.origin += moved * float(iSample) / float(max(iSamples - 1, 1)) * iCameraRight;
    return ray;
}

float coarseMargin(float t)
{
    return threshold + growth * pixelSpread() * t + moved;
}

float wireDistance(vec3 p)
{
    vec3 along = wireTo - wireFrom;
    float share = clamp(dot(p - wireFrom, along) / dot(along, along), 0.0, 1.0);
    return distance(p, wireFrom + share * along) - wireRadius;
}

float ballDistance(vec4 ball, vec3 p)
{
    return distance(p, ball.xyz) - ball.w;
}

float sceneDistance(vec3 p)
{
    float balls = min(min(ballDistance(ball0, p), ballDistance(ball1, p)),
                      min(ballDistance(ball2, p), ballDistance(ball3, p)));
    return factor * min(balls, wireDistance(p));
}

// Red: the march found something. Green: it found the wire. Blue: where the march began, divided by
// 64.
vec3 rayColour(Ray ray)
{
    float start = coarseStart(ray);
    Hit hit = marchCone(ray, start, 60.0, threshold, growth * pixelSpread(), 512);
    vec3 p = ray.origin + hit.t * ray.direction;
    bool wire = factor * wireDistance(p) < 1.01 * coarseMargin(hit.t);
    return vec3(hit.found, hit.found && wire, start / 64.0);
}
