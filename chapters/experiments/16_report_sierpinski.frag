// The report's figure 10, redrawn: Sierpinski's pyramid in a parallel view, with the light and the
// shadow of the figure.
//
// The pyramid rests on an edge, as in the formula for its distance; its corners are (1, 1, 1),
// (1, -1, -1), (-1, 1, -1) and (-1, -1, 1).
#include "main.glsl"         // main(): calls pixelRay, then rayColour
#include "orthographic.glsl" // orthographicRay
#include "cone.glsl"         // march, coneReaching
#include "normal.glsl"       // normalAt
#include "symmetry.glsl"     // sdSierpinskiPlanes, sdTetrahedronPlanes, foldToCorner, tetrahedronInterval
#include "shadow.glsl"       // shadowRay, shadowReach
#include "lighting.glsl"     // lambert, encodeSRGB

uniform int   levels;       // 8 in [0, 12]: how many times each tetrahedron is divided into four
uniform bool  clipped;      // true: march only inside the tetrahedron that contains the pyramid
uniform float footprint;    // 1 in [0, 4] step 0.25, half pixels: smaller distances count as hits; with 0 only those below hitThreshold
uniform int   maxSteps;     // 128 in [1, 1024]: steps after which a ray is abandoned
uniform float hitThreshold; // 0.0005 in [0.00001, 0.2] step *2, scene units: distance that counts as a hit

const float HALF_HEIGHT = 1.567;                  // half the picture's height; the pyramid fits in a cube of side 2
const float FAR = 8.0;                            // a ray that has travelled this far meets the sky
const float MARGIN = 0.02;                        // how much larger the bound is than the pyramid
const vec3  TO_SUN = vec3(0.447, 0.866, -0.224);  // length 1
const float SUN_SPREAD = 0.03;                    // tangent of the angular radius of the sun's disc
const vec3  SUN_COLOUR = vec3(1.35, 1.02, 0.70);  // light of the sun on a surface that faces it, linear RGB
const vec3  SKY_COLOUR = vec3(0.09, 0.20, 0.26);  // light from above
const vec3  EARTH_COLOUR = vec3(0.01, 0.03, 0.06); // light from below
const vec3  STONE = vec3(0.80, 0.78, 0.75);

Ray pixelRay(vec2 screen)
{
    return orthographicRay(screen, HALF_HEIGHT);
}

float sceneDistance(vec3 p)
{
    return sdSierpinskiPlanes(p, 1.0, levels);
}

// The interval in which a ray can meet the pyramid.
vec2 pyramidInterval(Ray ray)
{
    return clipped ? tetrahedronInterval(ray, 1.0 + 1.7320508 * MARGIN) : vec2(0.0, FAR);
}

// How open a point is to the sky, at most 1: each of the first four levels darkens the point in
// proportion to the depth of the point in that level's tetrahedron, as in chapter 06.
float openness(vec3 p)
{
    vec3 q = p - 1.0;
    float size = 1.0, open = 1.0;
    for (int i = 0; i < 4; i++) {
        open *= 1.0 + min(1.5 * sdTetrahedronPlanes(q + size, size) / size, 0.0);
        q = foldToCorner(q, size);
        size *= 0.5;
    }
    return open;
}

// The backdrop of the figure, whose colour is the same along each row.
vec3 backdrop(Ray ray)
{
    float height = dot(ray.origin - iCameraPosition, iCameraUp) / HALF_HEIGHT;
    return mix(vec3(0.0, 0.003, 0.017), vec3(0.002, 0.085, 0.14), smoothstep(-1.2, 1.2, height));
}

vec3 rayColour(Ray ray)
{
    float width = hitThreshold + footprint * HALF_HEIGHT / iResolution.y; // constant along a parallel ray
    vec2 interval = pyramidInterval(ray);
    Hit hit = march(ray, interval.x, interval.y, width, maxSteps);
    vec3 light = backdrop(ray);
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction, normal = normalAt(p, width);
        Ray shadow = shadowRay(p, normal, TO_SUN, 2.0 * width);
        vec2 inside = pyramidInterval(shadow);
        float far = shadowReach(normal, TO_SUN, inside.y);
        float seen = coneReaching(shadow, inside.x, far, width, SUN_SPREAD, maxSteps);
        vec3 around = mix(EARTH_COLOUR, SKY_COLOUR, (0.5 + 0.5 * normal.y) * openness(p));
        light = STONE * (around + seen * lambert(normal, TO_SUN) * SUN_COLOUR);
    }
    return encodeSRGB(light);
}
