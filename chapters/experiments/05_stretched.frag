// Experiment of chapter 05: four objects whose inverse maps stretch distances. From left to right: a ring made half as
// large, a ball squeezed to half its width by diag(2, 1, 1), a bent plank, and a ball with bumps.
//
// With divided=true, each distance is divided by its Lipschitz constant. With divided=false, no distance is divided, as
// in the formula that the report's section 2.2 states for every transformation.
#include "main.glsl"
#include "camera.glsl"     // perspectiveRay
#include "march.glsl"      // march
#include "normal.glsl"     // normalAt
#include "primitives.glsl" // sdSphere, sdBox
#include "lighting.glsl"   // lambert, encodeSRGB
#include "shadow.glsl"     // shadowRay, shadowReach, lightReaching
#include "bounds.glsl"     // boxInterval
#include "transform.glsl"  // opBend and the stretches, sdTorus

uniform bool divided; // true: divide by the Lipschitz constant

const vec3  LOW = vec3(-3.2, 0.0, -0.8); // opposite corners of a box around the objects
const vec3  HIGH = vec3(3.2, 1.7, 0.8);
const vec3  TO_SUN = vec3(0.50, 0.66, 0.56); // length 1 to three digits
const float BEND = 1.3;   // radians per scene unit
const float BUMP = 0.045; // height of a bump, scene units
const float FINE = 14.0;  // radians per scene unit: how close together the bumps are
const float NEAR = 1.0;   // radius of the ball in which the stretch of the bend is bounded, scene units

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float safe(float distance, float stretch)
{
    return divided ? distance / stretch : distance;
}

float ring(vec3 p)
{
    return safe(sdTorus((p / 0.5).xzy, 1.0, 0.3), 1.0 / 0.5);
}

float squeezed(vec3 p)
{
    mat3 m = mat3(2.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
    return safe(sdSphere(m * p, 0.65), largestStretch(m));
}

float plank(vec3 p)
{
    float ball = length(p) - (NEAR - 0.15);
    float bent = safe(sdBox(opBend(p, BEND), vec3(0.78, 0.1, 0.3)), bendStretch(BEND, NEAR));
    return ball > 0.15 ? ball : bent;
}

float bumpy(vec3 p)
{
    vec3 wave = sin(FINE * p);
    return safe(sdSphere(p, 0.6) + BUMP * wave.x * wave.y * wave.z, displacementStretch(BUMP * FINE));
}

float sceneDistance(vec3 p)
{
    p.y -= 0.75;
    float left = min(ring(p - vec3(-2.4, 0.0, 0.0)), squeezed(p - vec3(-0.9, 0.0, 0.0)));
    return min(left, min(plank(p - vec3(0.7, 0.0, 0.0)), bumpy(p - vec3(2.4, 0.0, 0.0))));
}

// The floor is a plane and needs no march. Rays are marched only inside the box around the objects.
vec3 rayColour(Ray ray)
{
    vec2 interval = boxInterval(ray, LOW, HIGH);
    Hit hit = march(ray, interval.x, interval.y, 0.001, 512);
    float floorT = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : 1000.0;
    float t = hit.found ? hit.t : floorT;
    vec3 p = ray.origin + t * ray.direction;
    vec3 normal = hit.found ? normalAt(p, 0.001) : vec3(0.0, 1.0, 0.0);
    Ray toSun = shadowRay(p, normal, normalize(TO_SUN), 0.01);
    vec2 way = boxInterval(toSun, LOW, HIGH);
    float seen = lightReaching(toSun, shadowReach(normal, TO_SUN, way.x < way.y ? way.y : 0.0), 0.001, 256);
    vec3 sun = vec3(1.7, 1.25, 0.85) * seen * lambert(normal, normalize(TO_SUN));
    vec3 light = sun + vec3(0.10, 0.14, 0.19) * (0.6 + 0.4 * normal.y);
    vec3 sky = mix(vec3(0.030, 0.075, 0.11), vec3(0.003, 0.007, 0.018), smoothstep(-0.2, 0.6, ray.direction.y));
    vec3 ground = mix(sky, vec3(0.045, 0.095, 0.115) * light, exp(-0.06 * t));
    vec3 paint = mix(vec3(0.85, 0.06, 0.03), vec3(0.90, 0.55, 0.10), smoothstep(-2.0, 2.6, p.x));
    return encodeSRGB(hit.found ? paint * light : (floorT < 999.0 ? ground : sky));
}
