// caustic.glsl - the light that a clear ball focuses.
#include "coverage.glsl"
#include "fresnel.glsl"

const int CAUSTIC_RINGS = 24;

// The area, divided by pi, of a disc with a soft rim: the integral of 2 r coverage(radius - r, width).
//   radius  >= 0
//   width   of the rim, > 0
//   formula radius^2 + width^2 / 12; if the rim reaches the centre, radius < width / 2, this is
//           (radius + width / 2)^3 / (3 width)
float softDiscArea(float radius, float width)
{
    float reach = radius + 0.5 * width;
    return radius < 0.5 * width ? reach * reach * reach / (3.0 * width) : radius * radius + width * width / 12.0;
}

// The light of a distant lamp that reaches a point through a clear ball, divided by the light that would arrive without
// the ball on a surface that faces the lamp: 1 is as bright as without the ball.
//   p        point outside the ball, from the ball's centre, scene units
//   toLight  direction of the lamp, length 1
//   radius   of the ball, > 0
//   index    of refraction of the ball, in (1, 1.53]; with a larger index, or more than 13 radii behind the ball, light
//            falls outside the area that is searched
//   spread   radius that the lamp would have at a distance of 1; the light is blurred over a width of spread z
//   formula  a ray at b = radius sin(i) from the axis is turned by D = 2 (i - j), sin(j) = sin(i) / index, and
//            leaves on a line that is also b from the centre: at z behind the centre this line is
//            r = (b - z sin(D)) / cos(D) from the axis; the line begins at the exit, z = radius cos(D - i). The beam is
//            cut into rings of b of equal areas. A ring's light, minus the light that the two surfaces reflect, is spread
//            evenly over the ring between its two r: (b^2 - b'^2) / (r^2 - r'^2), with both rims as wide as the blur
// The result is neither a bound nor exact. It leaves out light that is reflected inside, absorption, and the grazing
// rays beyond 0.96 radius, which carry 0.037 of the light that passes. On a plane that faces the lamp, the remaining
// light has the right total to within 0.005, but its distribution within a ring is an assumption.
float ballCaustic(vec3 p, vec3 toLight, float radius, float index, float spread)
{
    float z = -dot(p, toLight), r = length(p + z * toLight), width = max(spread * z, 0.002 * radius);
    float light = 0.0, before = 0.0; // r at the ring's inner rim
    float passed = 1.0 - fresnelShare(1.0, 1.0 / index); // the share that passes at the inner rim
    float share = 0.96 * 0.96 / float(CAUSTIC_RINGS); // of the beam: all rings have the same area
    int rings = z > 0.0 && r < max(radius, 2.5 * z) + width ? CAUSTIC_RINGS : 0; // rays turn by less than 70 degrees
    for (int k = 1; k <= rings; k++) {
        float square = share * float(k), sine = sqrt(square), inner = sine / index;
        float cosine = sqrt(1.0 - square), innerCosine = sqrt(1.0 - inner * inner);
        vec2 halfTurn = vec2(cosine * innerCosine + sine * inner, sine * innerCosine - cosine * inner);
        vec2 turn = vec2(halfTurn.x * halfTurn.x - halfTurn.y * halfTurn.y, 2.0 * halfTurn.x * halfTurn.y);
        float after = (radius * sine - z * turn.y) / max(turn.x, 0.05);
        float passes = 1.0 - fresnelShare(cosine, 1.0 / index);
        float low = before * after > 0.0 ? min(abs(before), abs(after)) : 0.0, high = max(abs(before), abs(after));
        float ring = softDiscArea(high, width) - (low > 0.0 ? softDiscArea(low, width) : 0.0);
        float lit = coverage(high - r, width) - (low > 0.0 ? coverage(low - r, width) : 0.0);
        bool left = z > radius * (cosine * turn.x + sine * turn.y);
        light += left ? lit * passed * passes * share / max(ring / (radius * radius), 1e-6) : 0.0;
        before = after;
        passed = passes;
    }
    return light;
}
