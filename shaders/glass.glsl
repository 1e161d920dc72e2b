// glass.glsl - rays through clear solids: the march with a sign, where the next ray starts, what is left of
// the light.
//
// Needs a scene distance that is negative inside a solid and bounds the depth there: |distance| is at most the
// distance to the surface, on both sides. docs/17_glass.md proves what is claimed, and says which shapes have it.
#include "fresnel.glsl"
#include "march.glsl"

// march of march.glsl on either side of a surface: it walks by side * distanceAt.
//   side     1: the ray starts outside, and this is march; -1: it starts inside a solid, whose distance is
//            negative there
//   others, and what it returns  those of march; found means the surface from this side
Hit marchSide(Ray ray, float side, float tMin, float tMax, float threshold, int maxSteps)
{
    traceBegin(tMin, tMax);
    traceThreshold(threshold, 0.0);
    float t = tMin;
    int steps = 0;
    bool found = false;
    bool searching = tMin < tMax;
    while (searching) {
        float distance = side * distanceAt(ray.origin + t * ray.direction);
        traceStep(steps, t, side * distance);
        steps++;
        found = distance < threshold;
        t += found ? 0.0 : distance;
        searching = !found && t < tMax && steps < maxSteps;
    }
    int end = found ? END_HIT : (t >= tMax ? END_PASSED : END_STEPS);
    traceMarch(steps, t, end);
    return Hit(found, t);
}

// What a surface makes of a ray: two, and how much of the light each has.
struct Parting {
    float mirrored; // share of the light that is mirrored, in [0, 1]; the rest is let through
    vec3  away;     // direction of what is mirrored, length 1
    vec3  bent;     // direction of what is let through, length 1; the vector 0 where nothing is
};

// The two rays that a smooth surface makes of one.
//   direction  of the ray, length 1
//   normal     of the surface, outwards, length 1
//   side       as of marchSide: from which the ray comes
//   index      of the solid over that of what is around it, > 0
//   formula    Snell's law, by refract of GLSL with the normal on the side of the ray, and with the index before the
//              surface over that behind it; fresnelShare. A ray that comes from the other side than side says is
//              taken to come along the surface: from inside it is mirrored as a whole
Parting partingAt(vec3 direction, vec3 normal, float side, float index)
{
    float eta = side > 0.0 ? 1.0 / index : index, facing = clamp(-side * dot(normal, direction), 0.0, 1.0);
    return Parting(fresnelShare(facing, eta), reflect(direction, normal), refract(direction, side * normal, eta));
}

// The ray that goes on from a surface, bent or mirrored: it starts off the surface, on the side to which it goes.
//   p          where a march ended, scene units
//   normal     of the surface there, outwards, length 1
//   direction  of the new ray, length 1
//   offset     scene units, > 0: how far from p along the normal. At least twice the march's threshold: on the
//              way through, p lies up to one threshold before the surface, and as much again must be left
//              behind it, or the next march ends where it starts
Ray leavingRay(vec3 p, vec3 normal, vec3 direction, float offset)
{
    return Ray(p + (dot(normal, direction) > 0.0 ? offset : -offset) * normal, direction);
}

// What an even, clear, coloured medium leaves of the light.
//   absorption  per channel and scene unit, >= 0: 0 is clear
//   way         through the medium, scene units, >= 0
//   formula     exp(-absorption way): two ways one after the other multiply, as they must
// Source: P. Bouguer, 'Essai d'optique' (1729); J. H. Lambert, 'Photometria' (1760); A. Beer (1852).
vec3 absorbed(vec3 absorption, float way)
{
    return exp(-absorption * way);
}

// What a straight line through glass meets.
struct Passage {
    float share;   // of the light that the boundaries let through, in [0, 1]
    float inside;  // the way inside solids, scene units
    float deepest; // t where the line is farthest inside
};

// A straight ray through whatever stands in its way: a quick model of a shadow that is not black. Light that
// glass bends goes elsewhere; here it is taken to go straight on, less what each boundary mirrors.
//   ray       from shadowRay, outside
//   far       how far to look, scene units; 0 or less is free
//   index     of refraction of the glass
//   least     the shortest step, scene units, > 0: what is thinner along the ray may be missed
//   maxSteps  evaluations
//   formula   steps of max(|distance|, least). Where two distances d, e that follow each other differ in sign there
//             is a boundary, found by a straight line between them; the cosine to its normal is |d - e| over the
//             step, exact for a flat face and an exact distance. So no normal is computed
Passage straightThrough(Ray ray, float far, float index, float least, int maxSteps)
{
    traceBegin(0.0, far);
    Passage passage = Passage(1.0, 0.0, 0.0);
    float t = 0.0, before = 1e6, stride = 1e6, lowest = 0.0;
    int steps = 0;
    bool searching = far > 0.0;
    while (searching) {
        float distance = distanceAt(ray.origin + t * ray.direction);
        traceStep(steps, t, distance);
        steps++;
        float part = clamp(distance / (distance - before), 0.0, 1.0); // of the stride, on this side of the boundary
        bool crossed = (before < 0.0) != (distance < 0.0);
        float facing = clamp(abs(distance - before) / stride, 0.0, 1.0);
        passage.share *= crossed ? 1.0 - fresnelShare(facing, 1.0 / index) : 1.0;
        passage.inside += stride * (crossed ? (distance < 0.0 ? part : 1.0 - part) : (distance < 0.0 ? 1.0 : 0.0));
        passage.deepest = distance < lowest ? t : passage.deepest;
        lowest = min(lowest, distance);
        before = distance;
        stride = max(abs(distance), least);
        t += stride;
        searching = t < far && steps < maxSteps;
    }
    traceMarch(steps, t, END_PASSED);
    return passage;
}
