// glass.glsl - rays through clear solids: a march outside or inside a solid, the start of the next ray, and
// the light that remains.
//
// The scene distance must be negative inside a solid and bound the depth there: on both sides, |distance| must
// be at most the distance to the surface. docs/17_glass.md proves the claims and says which shapes satisfy this.
#include "fresnel.glsl"
#include "march.glsl"

// march of march.glsl on either side of a surface, with the distance side * distanceAt.
//   side     1 if the ray starts outside, as in march; -1 if it starts inside a solid, where the distance is
//            negative
//   the other parameters and the result are those of march; found means that the march reached the surface
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

// How a surface splits a ray: the two new rays, and the share of the light in each.
struct Parting {
    float mirrored; // share of the light that is reflected, in [0, 1]; the rest is transmitted
    vec3  away;     // direction of the reflected ray, length 1
    vec3  bent;     // direction of the refracted ray, length 1; the zero vector if there is none
};

// The two rays into which a smooth surface splits one ray.
//   direction  of the ray, length 1
//   normal     of the surface, outwards, length 1
//   side       the side from which the ray comes, as for marchSide
//   index      of refraction of the solid divided by that of its surroundings, > 0
//   formula    Snell's law with GLSL's refract, which takes the normal on the side of the ray and the ratio of the
//              index before the surface to that behind it; the reflected share from fresnelShare. A ray that does not
//              come from the given side is treated as grazing: it is reflected completely
Parting partingAt(vec3 direction, vec3 normal, float side, float index)
{
    float eta = side > 0.0 ? 1.0 / index : index, facing = clamp(-side * dot(normal, direction), 0.0, 1.0);
    return Parting(fresnelShare(facing, eta), reflect(direction, normal), refract(direction, side * normal, eta));
}

// The ray that continues from a surface, refracted or reflected. It starts beside the surface, on the side to which it
// goes.
//   p          where a march ended, scene units
//   normal     of the surface there, outwards, length 1
//   direction  of the new ray, length 1
//   offset     how far from p the ray starts, along the normal, scene units, > 0. It must be at least twice the march's
//              threshold: p lies up to one threshold in front of the surface, and a transmitted ray must start at least
//              as far behind the surface, or the next march ends where it starts
Ray leavingRay(vec3 p, vec3 normal, vec3 direction, float offset)
{
    return Ray(p + (dot(normal, direction) > 0.0 ? offset : -offset) * normal, direction);
}

// The share of the light that a homogeneous, clear, coloured medium transmits.
//   absorption  per channel and scene unit, >= 0: 0 is clear
//   way         length of the path through the medium, scene units, >= 0
//   formula     exp(-absorption way): the shares of two paths in succession multiply, as they must
// Source: P. Bouguer, 'Essai d'optique' (1729); J. H. Lambert, 'Photometria' (1760); A. Beer (1852).
vec3 absorbed(vec3 absorption, float way)
{
    return exp(-absorption * way);
}

// The path of a straight line through glass.
struct Passage {
    float share;   // of the light that the boundaries transmit, in [0, 1]
    float inside;  // length of the path inside solids, scene units
    float deepest; // t where the line is farthest inside
};

// Follow a straight ray through all solids in its path, as a simple model of a shadow that is not black. In reality,
// glass refracts the light to other places; here the light goes straight on, minus the share that each boundary
// reflects.
//   ray       from shadowRay; it starts outside all solids
//   far       how far to search, scene units; 0 or less costs nothing
//   index     of refraction of the glass
//   least     the shortest step, scene units, > 0: a solid that is thinner along the ray may be missed
//   maxSteps  limit on the evaluations
//   formula   steps of max(|distance|, least). If two successive distances d, e differ in sign, there is a boundary
//             between them, found by linear interpolation; the cosine to its normal is |d - e| divided by the step,
//             exact for a flat face and an exact distance, so no normal has to be computed
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
        float part = clamp(distance / (distance - before), 0.0, 1.0); // share of the stride beyond the boundary
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
