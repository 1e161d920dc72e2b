// Experiment of chapter 11: the workshop's three balls, melted into each other, with three methods
// of mixing their materials. The numbers of the materials are the workshop's: 2 on the left, 5 on
// the right, 0.1 above.
//
//   way=0  records, mixed in the shares of the smooth union
//   way=1  the workshop's numbers, mixed with the weight clamp(a - d, 0, 1), where a is the
//          distance to the first of two parts and d the distance to their blend; this weight is
//          blend / 6 where it should be 1 / 2; a colour is then computed from the number
//   way=2  numbers, mixed in the right shares, then looked up in a table: between 2 and 5 are 3 and
//          4, which are other materials
#include "main.glsl"
#include "cone.glsl"
#include "normal.glsl"
#include "primitives.glsl"
#include "combine.glsl"
#include "material.glsl"
#include "checkers.glsl"
#include "gloss.glsl"
#include "fresnel.glsl"
#include "lighting.glsl"
#include "shadow.glsl"
#include "bounds.glsl"

uniform int   way;   // 0 in [0, 2]: 0 records, 1 numbers with the workshop's weight and colours, 2 numbers and a table
uniform float blend; // 0.8 in [0.05, 2] step 0.05, scene units: width of the blends

const vec3 LOW = vec3(-2.2, -0.02, -1.3);
const vec3 HIGH = vec3(2.2, 3.3, 1.3);
const vec3 TO_LIGHT = vec3(-0.48, 0.64, 0.6);

const Material CLAY = Material(vec3(0.42, 0.12, 0.05), vec3(0.04), 0.7);
const Material COBALT = Material(vec3(0.02, 0.10, 0.30), vec3(0.05), 0.25);
const Material LEMON = Material(vec3(0.75, 0.48, 0.04), vec3(0.04), 0.4);

Ray pixelRay(vec2 screen)
{
    return perspectiveRay(screen);
}

// The distances to the balls on the left, on the right and above.
vec3 ballDistances(vec3 p)
{
    p -= vec3(0.0, 1.05, 0.0);
    return vec3(sdSphere(p + vec3(1.1, 0.05, 0.0), 1.0), sdSphere(p - vec3(1.1, -0.05, 0.0), 1.0),
                sdSphere(p - vec3(0.0, 1.3, 0.0), 0.85));
}

float sceneDistance(vec3 p)
{
    vec3 ball = ballDistances(p);
    return opUnion(p.y, opSmoothUnion(opSmoothUnion(ball.x, ball.y, blend), ball.z, blend));
}

// The workshop's opBlend: two pairs of a distance and a number become one pair.
vec2 opBlend(vec2 a, vec2 b, float weight)
{
    return vec2(opSmoothUnion(a.x, b.x, blend), mix(a.y, b.y, weight));
}

float weightOf(float a, float b)
{
    return way == 1 ? clamp(a - opSmoothUnion(a, b, blend), 0.0, 1.0) : smoothUnionShare(a, b, blend);
}

float numberAt(vec3 ball)
{
    vec2 lower = opBlend(vec2(ball.x, 2.0), vec2(ball.y, 5.0), weightOf(ball.x, ball.y));
    return opBlend(lower, vec2(ball.z, 0.1), weightOf(lower.x, ball.z)).y;
}

// Six materials in a row, with the numbers 0 to 5. A number is rounded: those of the balls become
// 2, 5 and 0.
Material tableAt(float number)
{
    int n = int(floor(number + 0.5));
    vec3 colour = n == 1 ? vec3(0.02, 0.25, 0.06) : n == 3 ? vec3(0.7) : vec3(0.35, 0.02, 0.25);
    if (n == 0)
        return LEMON;
    if (n == 2)
        return CLAY;
    if (n == 5)
        return COBALT;
    return Material(colour, vec3(0.04), 0.5);
}

Material ballMaterial(vec3 ball)
{
    float lower = opSmoothUnion(ball.x, ball.y, blend), number = numberAt(ball);
    Material pair = mixMaterials(CLAY, COBALT, smoothUnionShare(ball.x, ball.y, blend));
    Material right = mixMaterials(pair, LEMON, smoothUnionShare(lower, ball.z, blend));
    Material line = Material(vec3(0.18 * number, 0.6 - 0.05 * number, 0.2), vec3(0.04), 0.5);
    if (way == 0)
        return right;
    if (way == 1)
        return line;
    return tableAt(number);
}

vec3 skyLight(vec3 direction)
{
    return mix(vec3(0.16, 0.15, 0.14), vec3(0.05, 0.08, 0.12), smoothstep(0.0, 0.5, direction.y));
}

vec3 rayColour(Ray ray)
{
    vec2 things = boxInterval(ray, LOW, HIGH);
    float ground = ray.direction.y < 0.0 ? -ray.origin.y / ray.direction.y : 200.0;
    float start = things.x < things.y ? min(things.x, ground) : ground;
    Hit hit = marchCone(ray, start - 0.01, min(ground + 0.5, 200.0), 0.001, pixelSpread(), 128);
    vec3 light = skyLight(ray.direction);
    if (hit.found) {
        vec3 p = ray.origin + hit.t * ray.direction;
        float halfSide = pixelSpread() * hit.t, radius = 0.001 + halfSide;
        vec3 normal = normalAt(p, radius);
        Footprint seen = planeFootprint(p, ray.direction, vec3(0.0, 1.0, 0.0), halfSide, 1.0 / hit.t,
                                        mat2x3(1.0, 0.0, 0.0, 0.0, 0.0, 1.0));
        float share = checkers(seen.middle, seen.width);
        Material material = Material(vec3(mix(0.10, 0.22, share)), vec3(0.03), 0.8);
        if (p.y > 2.0 * radius)
            material = ballMaterial(ballDistances(p));
        Ray toLight = shadowRay(p, normal, TO_LIGHT, 4.0 * radius);
        float seenLight = coneReaching(toLight, 0.0, shadowReach(normal, TO_LIGHT, boxInterval(toLight, LOW, HIGH).y),
                                       2.0 * radius, 0.04, 96);
        float facing = clamp(dot(halfway(TO_LIGHT, -ray.direction), TO_LIGHT), 0.0, 1.0);
        float mirrored = schlickShare(facing, material.straight.g);
        float gloss = mirrored * GLOSS_PI * ggxGloss(normal, TO_LIGHT, -ray.direction, material.roughness);
        vec3 received = seenLight * lambert(normal, TO_LIGHT) * vec3(1.9, 1.75, 1.5);
        vec3 shown = (material.colour * (1.0 - mirrored) + gloss) * received;
        shown += material.colour * vec3(0.22, 0.24, 0.27) * (0.7 + 0.3 * normal.y);
        light = mix(shown, skyLight(vec3(0.0)), smoothstep(10.0, 60.0, hit.t));
    }
    return encodeSRGB(light);
}
