// prism.glsl - light through a prism, in the plane perpendicular to its edge.
//
// Light enters through one of two flat faces and leaves through the other. Angles are measured from the faces'
// normals, on the side away from the edge where the faces meet, so both angles of a ray that passes symmetrically are
// positive. apex is the angle between the faces, radians, in (0, pi).
#include "coverage.glsl"
#include "spectrum.glsl"

// The sine of the angle at which light leaves.
//   entering  sine of the angle at which the light enters, in [-1, 1]
//   index     refractive index of the prism, divided by that of its surroundings, >= 1
//   returns   above 1 for total reflection: no light leaves through the second face
//   formula   sin(apex) sqrt(index^2 - entering^2) - cos(apex) entering
float prismLeaving(float entering, float apex, float index)
{
    return sin(apex) * sqrt(index * index - entering * entering) - cos(apex) * entering;
}

// The inverse of prismLeaving: the index for which light that enters at one angle leaves at another.
//   entering, leaving  sines, in [-1, 1]; leaving + cos(apex) entering >= 0
//   formula  sqrt(entering^2 + ((leaving + cos(apex) entering) / sin(apex))^2)
float prismIndex(float entering, float leaving, float apex)
{
    float along = (leaving + cos(apex) * entering) / sin(apex);
    return sqrt(entering * entering + along * along);
}

// The smallest angle by which a prism deflects light, reached by light that passes symmetrically.
//   index    at most 1 / sin(apex / 2), or no light passes symmetrically
//   returns  radians
//   formula  2 asin(index sin(apex / 2)) - apex
float leastDeviation(float apex, float index)
{
    float sine = min(index * sin(0.5 * apex), 1.0);
    return 2.0 * atan(sine, sqrt(1.0 - sine * sine)) - apex;
}

// The effective index for the projection of an oblique ray onto the plane perpendicular to the edge: with this
// index, the projection obeys Snell's law.
//   rise     sine of the angle between the ray and that plane, in (-1, 1); it is the same in front of
//            and behind the prism
//   formula  sqrt((index^2 - rise^2) / (1 - rise^2))
// Source: A. Bravais, 'Notice sur les parhélies qui sont situés à la même hauteur que le soleil' (1845).
float planIndex(float index, float rise)
{
    return sqrt((index * index - rise * rise) / (1.0 - rise * rise));
}

// The light of a narrow white beam at one point near an equilateral prism, seen from above.
struct Beam {
    float white; // share of the beam that passes this point in front of the prism, in [0, 1]
    vec2  waves; // behind the prism: two limits of the wavelengths that arrive, micrometres; equal if none arrive
};

// The light at a point, from a beam that enters the middle of one side of an upright prism whose plan is an
// equilateral triangle, at the angle at which green light, 0.55 micrometres, passes symmetrically.
//   q          point of the plan, from the triangle's centre: x along its base, in the direction of the green
//              light inside, y towards the edge that the light passes
//   radius     from the centre to a side, scene units
//   glass      Cauchy's two numbers; planIndex for green must be below 2, or no light passes symmetrically
//   rise       as for planIndex
//   halfWidth  of the beam, scene units, small compared with radius
//   formula    the light at q has left the second side at a point that depends on its wavelength. prismIndex for
//              the direction from that point gives the index, and the index gives the point: three iterations, for
//              each edge of the beam. In the middle of the beam the wavelength is right to within 0.0005 micrometres.
//              The beam is assumed to be as wide behind the prism as in front of it, which is true for green
Beam prismBeam(vec2 q, float radius, vec2 glass, float rise, float halfWidth)
{
    const vec2 first = vec2(-0.8660254, 0.5), second = vec2(0.8660254, 0.5); // normals of the two sides
    const vec2 rising = vec2(0.5, 0.8660254), falling = vec2(0.5, -0.8660254); // along the sides, to and from the edge
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
            vec2 to = enter - way * (1.5 * radius / dot(way, second)); // from the point where the light leaves
            to += (edge == 0 ? halfWidth : -halfWidth) * vec2(-to.y, to.x) / length(to);
            index = prismIndex(entering, clamp(dot(normalize(to), falling), 0.0, 1.0), radians(60.0));
        }
        index = sqrt(index * index + rise * rise * (1.0 - index * index)); // the inverse of planIndex
        waves[edge] = cauchyWave(glass, index);
    }
    return Beam(white, clamp(waves, SHORTEST_WAVE, LONGEST_WAVE));
}
