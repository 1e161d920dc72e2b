// Experiment of chapter 16: a harp far from the origin, and the limits of a float.
//
// The camera is given in the same coordinates as the harp. If the parameter `mended` is on, the harp's position is
// subtracted once from the position of the eye, and the positions in the march are small, so their rounding errors are
// small too.
#include "main.glsl"
#include "camera.glsl"
#include "march.glsl"
#include "normal.glsl"
#include "primitives.glsl"
#include "repetition.glsl"
#include "lighting.glsl"
#include "shadow.glsl"

uniform float away;         // 10000 in [0, 1000000] step 1000, scene units: how far east and south the harp is
uniform bool  mended;       // false: march in coordinates in which the harp is at the origin
uniform float hitThreshold; // 0.0002 in [0.00001, 0.1] step *2, scene units: distance that counts as a hit
uniform int   maxSteps;     // 256 in [1, 1024]: steps after which a ray is abandoned

const float FAR = 30.0;
const vec3  TO_SUN = vec3(-0.48, 0.72, 0.5);

// The position of the harp in the coordinates of the march.
vec3 harpPosition()
{
    return mended ? vec3(0.0) : vec3(away, 0.0, away);
}

Ray pixelRay(vec2 screen)
{
    Ray ray = perspectiveRay(screen);
    ray.origin -= vec3(away, 0.0, away) - harpPosition();
    return ray;
}

float ringDistance(vec3 p)
{
    return length(vec2(length(p.xy - vec2(0.0, 0.95)) - 0.85, p.z)) - 0.05;
}

// Vertical strings inside the ring.
float stringDistance(vec3 p)
{
    float x = opRepeatLimited(p.x, 0.12, -6.0, 6.0), own = p.x - x;
    float high = sqrt(max(0.7225 - own * own, 0.0));
    return length(vec3(x, p.y - clamp(p.y, 0.95 - high, 0.95 + high), p.z)) - 0.005;
}

float floorDistance(vec3 p)
{
    return sdBox(p - vec3(0.0, -0.1, 0.0), vec3(1.6, 0.1, 1.2)) - 0.02;
}

// A hollow ball of paper.
float ballDistance(vec3 p)
{
    return abs(sdSphere(p - vec3(0.95, 0.32, 0.7), 0.3)) - 0.0001;
}

float sceneDistance(vec3 p)
{
    vec3 q = p - harpPosition();
    return min(min(ringDistance(q), stringDistance(q)), min(floorDistance(q), ballDistance(q)));
}

vec3 colourOf(vec3 q)
{
    float wood = min(ringDistance(q), stringDistance(q)), ball = ballDistance(q);
    vec3 colour = floorDistance(q) < min(wood, ball) ? vec3(0.34, 0.42, 0.47) : vec3(0.62, 0.30, 0.12);
    return ball < min(wood, floorDistance(q)) ? vec3(0.75, 0.56, 0.20) : colour;
}

vec3 rayColour(Ray ray)
{
    Hit hit = march(ray, 0.0, FAR, hitThreshold, maxSteps);
    vec3 sky = mix(vec3(0.80, 0.74, 0.66), vec3(0.28, 0.42, 0.58), smoothstep(-0.2, 0.5, ray.direction.y));
    vec3 p = ray.origin + hit.t * ray.direction, normal = normalAt(p, 0.25 * hitThreshold);
    Ray there = shadowRay(p, normal, TO_SUN, 4.0 * hitThreshold);
    float seen = lightReaching(there, hit.found ? shadowReach(normal, TO_SUN, 4.0) : 0.0, hitThreshold, 96);
    vec3 light = seen * lambert(normal, TO_SUN) * vec3(1.5, 1.3, 1.05) + (0.6 + 0.4 * normal.y) * vec3(0.26, 0.33, 0.42);
    return encodeSRGB(hit.found ? colourOf(p - harpPosition()) * light : sky);
}
