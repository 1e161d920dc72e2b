// Experiment of chapter 05: a twisted torus, the report's figure 10b. The torus is upright, and the
// angle of the twist is proportional to the height.
//
// With divided=false the point is twisted and nothing else is done, so steps are too long, and rays
// jump through the surface. With divided=true the distance is divided by its Lipschitz constant.
#include "main.glsl"
#include "camera.glsl"     // perspectiveRay
#include "march.glsl"      // march
#include "normal.glsl"     // normalAt
#include "lighting.glsl"   // lambert, encodeSRGB
#include "shadow.glsl"     // shadowRay, shadowReach, lightReaching
#include "bounds.glsl"     // boxInterval
#include "transform.glsl"  // opTwist, twistStretch, sdTorus

uniform float twistRate;  // 2.4 in [-4, 4] step 0.1, radians per scene unit of height: twist of the torus
uniform bool  divided;    // true: divide by the Lipschitz constant
uniform float stepFactor; // 1 in [0.1, 4] step 0.05: an additional factor on every step

const float REACH = 1.84; // radius of a cylinder around the box, and so around the torus
const vec3  LOW = vec3(-1.3, 0.0, -1.3); // opposite corners of a box around the torus
const vec3  HIGH = vec3(1.3, 2.6, 1.3);
const vec3  TO_SUN = vec3(0.50, 0.66, 0.56); // length 1 to three digits

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

float sceneDistance(vec3 p)
{
    vec3 q = opTwist(p - vec3(0.0, 1.28, 0.0), twistRate);
    float torus = sdTorus(q.xzy, 1.0, 0.26);
    return stepFactor * (divided ? torus / twistStretch(twistRate, REACH) : torus);
}

// The floor is a plane and needs no march. Rays are marched only inside the box around the torus.
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
    return encodeSRGB(hit.found ? vec3(0.85, 0.06, 0.03) * light : (floorT < 999.0 ? ground : sky));
}
