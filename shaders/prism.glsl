// prism.glsl - light through a prism, in the plane across its edge.
//
// Light enters one of two flat faces and leaves by the other. Angles are counted from the faces' normals, on the
// side of the edge where they meet away from it: so light that goes straight through symmetrically has two
// positive ones. apex is the angle between the faces, radians, in (0, pi).
#include "coverage.glsl"
#include "spectrum.glsl"

// The sine of the angle at which light leaves.
//   entering  sine of the angle at which it comes, in [-1, 1]
//   index     of the prism, over that of what is around it, >= 1
//   returns   above 1: total reflection, nothing leaves by the other face
//   formula   sin(apex) sqrt(index^2 - entering^2) - cos(apex) entering
float prismLeaving(float entering, float apex, float index)
{
    return sin(apex) * sqrt(index * index - entering * entering) - cos(apex) * entering;
}

// prismLeaving read backwards: the index for which light that enters so leaves so.
//   entering, leaving  sines, in [-1, 1]; leaving + cos(apex) entering >= 0
//   formula  sqrt(entering^2 + ((leaving + cos(apex) entering) / sin(apex))^2)
float prismIndex(float entering, float leaving, float apex)
{
    float along = (leaving + cos(apex) * entering) / sin(apex);
    return sqrt(entering * entering + along * along);
}

// The least angle by which a prism turns light: where it goes through symmetrically.
//   index    at most 1 / sin(apex / 2), or no light goes through so
//   returns  radians
//   formula  2 asin(index sin(apex / 2)) - apex
float leastDeviation(float apex, float index)
{
    return 2.0 * asin(index * sin(0.5 * apex)) - apex;
}

// The index that a prism has for the plan of a ray that also goes along its edge: the plan obeys Snell's law with
// this one.
//   rise     sine of the angle between the ray and the plane across the edge, in (-1, 1); it is the same before
//            and behind the prism
//   formula  sqrt((index^2 - rise^2) / (1 - rise^2))
// Source: A. Bravais, 'Notice sur les parhélies qui sont situés à la même hauteur que le soleil' (1845).
float planIndex(float index, float rise)
{
    return sqrt((index * index - rise * rise) / (1.0 - rise * rise));
}

// A narrow beam of white light and an equal-sided prism, seen from above at one point.
struct Beam {
    float white; // how much of the beam comes here before the prism, in [0, 1]
    vec2  waves; // behind it: the wavelengths that come here lie between these two, micrometres; equal: none
};

// A beam enters the middle of one side of an upright prism whose plan is a triangle with equal sides, so that green,
// 0.55, goes through symmetrically; and what comes of it to a point.
//   q          point of the plan, from the triangle's middle: x along its base, in the direction of the green
//              light inside, y towards the edge that the light passes
//   radius     from the middle to a side, scene units
//   glass      Cauchy's two numbers; the plan's index of green must be below 2, or no light goes through so
//   rise       as of planIndex
//   halfWidth  of the beam, scene units, small against radius
//   formula    at q light has left the second side at the place where its wavelength does: prismIndex for the direction
//              from there, three times over, for the place depends on the index; once from either edge of the beam.
//              In its middle the wavelength is right to 0.0005. The beam is taken to be as wide behind as before,
//              which holds for green
Beam prismBeam(vec2 q, float radius, vec2 glass, float rise, float halfWidth)
{
    const vec2 first = vec2(-0.8660254, 0.5), second = vec2(0.8660254, 0.5); // normals of the two sides
    const vec2 rising = vec2(0.5, 0.8660254), falling = vec2(0.5, -0.8660254); // along them: to the edge, from it
    vec2 enter = q - radius * first, leave = q - radius * second;
    float green = planIndex(cauchyIndex(glass, 0.55), rise), entering = 0.5 * green;
    float cosine = sqrt(1.0 - entering * entering);
    vec2 along = entering * rising - cosine * first, away = entering * falling + cosine * second;
    float white = dot(enter, first) > 0.0 ? coverage(halfWidth - abs(determinant(mat2(along, enter))), 0.02) : 0.0;
    float aside = abs(determinant(mat2(away, leave)));
    bool near = dot(leave, second) > 0.0 && aside < 0.2 * dot(leave, away) + 3.0 * halfWidth;
    vec2 waves = vec2(0.0);
    for (int edge = 0; edge < (near ? 2 : 0); edge++) {
        float index = green;
        for (int i = 0; i < 3; i++) {
            float inside = entering / index;
            vec2 way = inside * rising - sqrt(1.0 - inside * inside) * first;
            vec2 to = enter - way * (1.5 * radius / dot(way, second)); // from where it leaves
            to += (edge == 0 ? halfWidth : -halfWidth) * vec2(-to.y, to.x) / length(to);
            index = prismIndex(entering, clamp(dot(normalize(to), falling), 0.0, 1.0), radians(60.0));
        }
        index = sqrt(index * index + rise * rise * (1.0 - index * index)); // planIndex read backwards
        waves[edge] = cauchyWave(glass, index);
    }
    return Beam(white, clamp(waves, SHORTEST_WAVE, LONGEST_WAVE));
}
