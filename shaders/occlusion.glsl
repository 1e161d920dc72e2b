// occlusion.glsl - how much of the sky is visible from a point, when the whole sky is the lamp.
//
// The openness of a point is the light that a matt surface receives there from a uniform sky, as a share of the
// light without any obstacles:
//   A = 1 / pi times the integral of V(w) cos(angle of w to the normal) over the half-space of the normal,
// where V(w) is 1 if nothing blocks the direction w, and 0 otherwise. Projected along the normal, the directions are
// the points of a disc, and A is the open part of the disc's area. docs/14_occlusion.md proves the claims made
// here.
#include "random.glsl"
#include "shadow.glsl"
#include "soft_shadow.glsl"

// ---- Closed forms ----

// The openness of a surface above an endless level ground, with nothing else in the scene.
//   normal   length 1, with y upwards
//   returns  (1 + normal.y) / 2: 1 for a floor, 1/2 for a wall, 0 for a ceiling. Exact
float openOverGround(vec3 normal)
{
    return 0.5 + 0.5 * normal.y;
}

// The openness of a level floor in front of a wall of infinite length.
//   away     distance from the wall, >= 0, scene units
//   height   of the wall, > 0, scene units
//   formula  (1 + cos a) / 2, where a is the elevation of the wall's top above the horizon. Exact
float openBeforeWall(float away, float height)
{
    return 0.5 + 0.5 * away / length(vec2(away, height));
}

// The share of the disc of directions that a ball hides.
//   p        point outside the ball, scene units
//   normal   of the surface at p, length 1; the part of the ball behind the surface hides nothing
//   centre, radius  of the ball
//   formula  (s^2 c atan(k, -c q) - q k + atan(k, q)) / pi with c = cosine of the angle between the normal and
//            the direction to the ball's centre, s = radius / distance = sine of the ball's angular radius,
//            q = sqrt(1 - s^2), k = sqrt(max(s^2 - c^2, 0)); where the whole ball is in front of the surface,
//            k = 0 and the result is c s^2. Exact
// Source: J. M. Snyder, 'Area light sources for real-time graphics', Microsoft Research MSR-TR-96-11 (1996),
// derives the same share differently.
float hiddenByBall(vec3 p, vec3 normal, vec3 centre, float radius)
{
    vec3 toBall = centre - p;
    float distance = length(toBall);
    float c = dot(normal, toBall) / distance, s = min(radius / distance, 1.0);
    float q = sqrt(1.0 - s * s), k = sqrt(max(s * s - c * c, 0.0));
    return k > 0.0 ? (s * s * c * atan(k, -c * q) - q * k + atan(k, q)) / PI : max(c, 0.0) * s * s;
}

// ---- Many rays ----

// A direction in the half-space of a normal, from a point of the unit square. Each part of the sky receives
// directions in proportion to its contribution.
//   normal   length 1
//   square   both coordinates in [0, 1]
//   formula  discPoint gives a point of the disc; the direction is the point of the hemisphere above it
//   returns  length 1. Uniformly distributed points become directions of density cos / pi
// Source: W. Nusselt (1928) for the disc; T. J. V. Malley (1988) for the sampling.
vec3 cosineDirection(vec3 normal, vec2 square)
{
    vec3 axis = abs(normal.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    vec3 right = normalize(cross(normal, axis)), up = cross(right, normal);
    vec2 point = discPoint(square);
    return point.x * right + point.y * up + sqrt(max(1.0 - dot(point, point), 0.0)) * normal;
}

// The share of side x side rays that reach the sky: one ray for a random point in each of side x side cells of the
// unit square. Each of the k x k samples of a pixel takes a different one of the k x k parts of a cell, in an order
// that differs from ray to ray, so all samples together have one ray in each of (k side)^2 cells.
//   p          on the surface, or a little above it, scene units
//   normal     length 1
//   offset     how far above the surface the rays start, as for shadowRay
//   far        how far to search, scene units
//   side       >= 0; with 0, no ray is marched and the result is 1
//   threshold, maxSteps  of the march
//   dimension  the first of 2 side^2 dimensions of pixelRandom that are used
// As the number of samples grows, the mean of this share over the samples of a pixel tends to the openness.
float skyReaching(vec3 p, vec3 normal, float offset, float far, int side, float threshold,
                  int maxSteps, int dimension)
{
    float arrived = 0.0;
    int parts = max(int(sqrt(float(iSamples)) + 0.5), 1);
    for (int i = 0; i < side * side; i++) {
        vec2 lot = vec2(pixelRandom(dimension + 2 * i), pixelRandom(dimension + 2 * i + 1));
        int part = (iSample + i) % (parts * parts);
        lot = (vec2(part % parts, part / parts) + lot) / float(parts);
        vec2 square = (vec2(i % side, i / side) + lot) / float(side);
        Ray ray = shadowRay(p, normal, cosineDirection(normal, square), offset);
        arrived += lightReaching(ray, far, threshold, maxSteps);
    }
    return side > 0 ? arrived / float(side * side) : 1.0;
}

// ---- An estimate from five taps ----

const int TAPS = 5;

// The height of tap k above the surface, k from 0 to TAPS - 1. Each tap is twice as high as the tap before.
//   reach    height of the last tap, > 0, scene units
//   formula  reach / 2^(TAPS - 1 - k)
float tapHeight(int k, float reach)
{
    return reach * exp2(float(k + 1 - TAPS));
}

// An estimate of the openness from five distances along the normal.
//   p        on the surface, scene units; normal of length 1
//   reach    height of the last tap, > 0, scene units: anything farther away is ignored
//   strength how much of the light a tap removes where it finds another surface: 1 for a point that is
//            enclosed, 1/2 for a point beside a single wall
//   formula  1 - strength times the mean of 1 - d_k / h_k, each in [0, 1], h_k = tapHeight, d_k = the scene's
//            distance at p + h_k normal; never less than 0
//   returns  1 where no tap is nearer to anything than to the surface itself: with an exact distance, on a single
//            plane, ball or other convex solid. It is neither an upper nor a lower bound of the openness
// Source: after A. Evans, 'Fast approximations for global illumination on dynamic scenes', SIGGRAPH 2006.
float openByTaps(vec3 p, vec3 normal, float reach, float strength)
{
    float hidden = 0.0;
    for (int k = 0; k < TAPS; k++) {
        float height = tapHeight(k, reach);
        hidden += clamp(1.0 - distanceAt(p + height * normal) / height, 0.0, 1.0);
    }
    return max(1.0 - strength * hidden / float(TAPS), 0.0);
}

// ---- Light from nearby surfaces ----

// The light of a point that sees a share of the sky and, in all other directions, surfaces with the same light as the
// point.
//   open     openness of the point, in [0, 1]
//   colour   share of the light that those surfaces reflect, in [0, 1] per channel
//   bounces  0 for only the sky's light, 1 to include the light of one reflection, 2 for all reflections
//   returns  light, relative to that of an open floor
//   formula  open, open (1 + b), or open / (1 - b), b = colour (1 - open). The last quotient is 1 if colour is 1 and
//            open at least 1e-6, and 0 if open is 0; it is exact in a hollow ball with a hole
vec3 skyAndBounces(float open, vec3 colour, int bounces)
{
    vec3 back = colour * (1.0 - open);
    vec3 all = open / max(1.0 - back, 1e-6);
    return bounces == 0 ? vec3(open) : (bounces == 1 ? open * (1.0 + back) : all);
}
