// occlusion.glsl - how much of the sky a point sees, when the whole sky is the lamp.
//
// The openness of a point is the share of a matt surface's light that arrives from an even sky:
//   A = 1 / pi times the integral of V(w) cos(angle of w to the normal) over the half-space of the normal,
// V(w) = 1 where nothing stands in the direction w, else 0. Seen from above along the normal the directions
// are the points of a disc, and A is the part of the disc's area that is open. docs/14_occlusion.md proves
// what is claimed here.
#include "random.glsl"
#include "shadow.glsl"
#include "soft_shadow.glsl"

// ---- What is seen, in closed form ----

// The openness of a surface over an endless level ground, when nothing else is there.
//   normal   length 1, y upwards
//   returns  (1 + normal.y) / 2: 1 for a floor, 1/2 for a wall, 0 for a ceiling. Exact
float openOverGround(vec3 normal)
{
    return 0.5 + 0.5 * normal.y;
}

// The openness of a level floor in front of a wall that runs on to both sides for ever.
//   away     from the wall, >= 0, scene units
//   height   of the wall, > 0, scene units
//   formula  (1 + cos a) / 2, a the angle under which the wall's top is seen over the horizon. Exact
float openBeforeWall(float away, float height)
{
    return 0.5 + 0.5 * away / length(vec2(away, height));
}

// What a ball hides: its share of the disc of directions.
//   p        point that is not in the ball, scene units
//   normal   of the surface at p, length 1; what lies behind the surface hides nothing
//   centre, radius  of the ball
//   formula  (s^2 c atan(k, -c q) - q k + atan(k, q)) / pi with c = cosine of the angle from the normal to the
//            ball's middle, s = radius / distance = sine of half the angle under which the ball is seen,
//            q = sqrt(1 - s^2), k = sqrt(max(s^2 - c^2, 0)); where the whole ball is in front of the surface
//            k = 0, and that is c s^2. Exact
// Source: J. M. Snyder, 'Area light sources for real-time graphics', Microsoft Research MSR-TR-96-11 (1996),
// has the same share by another road.
float hiddenByBall(vec3 p, vec3 normal, vec3 centre, float radius)
{
    vec3 toBall = centre - p;
    float distance = length(toBall);
    float c = dot(normal, toBall) / distance, s = min(radius / distance, 1.0);
    float q = sqrt(1.0 - s * s), k = sqrt(max(s * s - c * c, 0.0));
    return k > 0.0 ? (s * s * c * atan(k, -c * q) - q * k + atan(k, q)) / PI : max(c, 0.0) * s * s;
}

// ---- What many rays find ----

// A direction of the half-space of a normal, for a place of the unit square: as many go to each part of the
// sky as its light counts.
//   normal   length 1
//   square   each in [0, 1]
//   formula  discPoint gives a point of the disc; the direction stands straight above it, on the half-ball
//   returns  length 1. Evenly spread places become directions of density cos / pi
// Source: W. Nusselt (1928) for the disc; T. J. V. Malley (1988) for the sampling.
vec3 cosineDirection(vec3 normal, vec2 square)
{
    vec3 axis = abs(normal.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    vec3 right = normalize(cross(normal, axis)), up = cross(right, normal);
    vec2 point = discPoint(square);
    return point.x * right + point.y * up + sqrt(max(1.0 - dot(point, point), 0.0)) * normal;
}

// The share of side x side rays that reach the sky: one in each cell of the unit square, at a place drawn by
// lot. Of k x k samples of a pixel each takes another of k x k parts of the cell, and for each ray in another
// order: so all samples together have one ray in each of (k side)^2 cells.
//   place      on the surface, or a little above it, scene units
//   normal     length 1
//   offset     how far above it the rays start, as of shadowRay
//   far        how far to look, scene units
//   side       >= 0; with 0 nothing is looked for, and 1 returned
//   threshold, maxSteps  of the march
//   dimension  the first of 2 side^2 dimensions of pixelRandom that it uses
// Its mean over the samples of a pixel tends to the openness.
float skyReaching(vec3 place, vec3 normal, float offset, float far, int side, float threshold,
                  int maxSteps, int dimension)
{
    float arrived = 0.0;
    int parts = max(int(sqrt(float(iSamples)) + 0.5), 1);
    for (int i = 0; i < side * side; i++) {
        vec2 lot = vec2(pixelRandom(dimension + 2 * i), pixelRandom(dimension + 2 * i + 1));
        int part = (iSample + i) % (parts * parts);
        lot = (vec2(part % parts, part / parts) + lot) / float(parts);
        vec2 square = (vec2(i % side, i / side) + lot) / float(side);
        Ray ray = shadowRay(place, normal, cosineDirection(normal, square), offset);
        arrived += lightReaching(ray, far, threshold, maxSteps);
    }
    return side > 0 ? arrived / float(side * side) : 1.0;
}

// ---- What five taps guess ----

const int TAPS = 5;

// How high over the surface tap k asks, k from 0 to TAPS - 1: each twice as high as the one before.
//   reach    of the last, > 0, scene units
//   formula  reach / 2^(TAPS - 1 - k)
float tapHeight(int k, float reach)
{
    return reach * exp2(float(k + 1 - TAPS));
}

// An openness by five distances along the normal.
//   place    on the surface, scene units; normal of length 1
//   reach    height of the last tap, > 0, scene units: what is farther than that is not looked for
//   strength how much of the light a tap that finds the surface of something takes: 1 for a place that is
//            walled round, 1/2 for one beside a single wall
//   formula  1 - strength times the mean of 1 - d_k / h_k, each in [0, 1], h_k = tapHeight, d_k = the scene's
//            distance at place + h_k normal; never less than 0
//   returns  1 where no tap has anything nearer than the surface itself: with an exact distance an open plane,
//            a ball, and all else that is convex and alone. A guess: neither bound of the openness
// Source: after A. Evans, 'Fast approximations for global illumination on dynamic scenes', SIGGRAPH 2006.
float openByTaps(vec3 place, vec3 normal, float reach, float strength)
{
    float hidden = 0.0;
    for (int k = 0; k < TAPS; k++) {
        float height = tapHeight(k, reach);
        hidden += clamp(1.0 - distanceAt(place + height * normal) / height, 0.0, 1.0);
    }
    return max(1.0 - strength * hidden / float(TAPS), 0.0);
}

// ---- What comes back from what is near ----

// The light of a place that sees a share of the sky, and else things that are lit as it is.
//   open     its openness, in [0, 1]
//   colour   share of the light that those things send back, in [0, 1] per channel
//   bounces  0: the sky's light alone; 1: with what was sent back once; 2: however often
//   returns  light, where an open floor has 1
//   formula  open, open (1 + b), or open / (1 - b), b = colour (1 - open). The last is 1 where colour is 1 and
//            open at least 1e-6, and 0 where open is 0; exact in a hollow ball with a hole
vec3 skyAndBounces(float open, vec3 colour, int bounces)
{
    vec3 back = colour * (1.0 - open);
    vec3 all = open / max(1.0 - back, 1e-6);
    return bounces == 0 ? vec3(open) : (bounces == 1 ? open * (1.0 + back) : all);
}
