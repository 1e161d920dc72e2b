// soft_shadow.glsl - the share of an extended lamp that is visible from a point.
//
// The lamp is a disc of radius spread, at a distance of 1 from the point and perpendicular to the direction to it:
// the sun, or a round lamp that faces the point with a radius of spread times its distance. A point of the disc is
// given in radii of the disc, with (0, 0) at the centre. docs/13_soft_shadows.md proves the claims made here.
#include "random.glsl"
#include "shadow.glsl"

const float PI = 3.14159265;

// ---- Closed forms ----

// The visible share of the disc beside a straight edge.
//   clear    how far the centre of the disc is clear of the edge, in radii; negative behind the edge
//   returns  0 up to clear = -1, 1/2 at 0, 1 from 1 on
//   formula  1/2 + (asin(c) + c sqrt(1 - c^2)) / pi, c = clear in [-1, 1]: the disc's area without a
//            circular segment. Exact
float discBesideEdge(float clear)
{
    float c = clamp(clear, -1.0, 1.0);
    float root = sqrt(1.0 - c * c);
    return 0.5 + (atan(c, root) + c * root) / PI;
}

// The area of a circular segment, in a circle of radius 1: the part that a chord cuts off.
//   angle    half the angle that the chord subtends at the centre, in [0, pi]
//   formula  a - sin(a) cos(a); for small angles the first terms of its series, 2 a^3 / 3 - 2 a^5 / 15
float segmentArea(float angle)
{
    float square = angle * angle;
    float series = angle * square * (2.0 / 3.0 - 2.0 / 15.0 * square);
    return angle < 0.1 ? series : angle - sin(angle) * cos(angle);
}

// The visible share of the disc beside another disc.
//   clear    how far the centre of the first disc is clear of the other's rim, in radii of the first disc;
//            negative behind the rim, at least -radius
//   radius   of the other disc, in the same unit, > 0; for a large radius the result tends to discBesideEdge
//   formula  1 - (S(a) + radius^2 S(b)) / pi, S = segmentArea: two segments on one chord. With d = clear +
//            radius from centre to centre, the chord is at x = cos a = (d^2 + 1 - radius^2) / (2 d) from
//            the first centre and at d - x = radius cos b from the other. Exact for discs in one plane
float discBesideDisc(float clear, float radius)
{
    float between = max(clear + radius, 1e-6);
    float x = clamp(0.5 * (clear * clear + 2.0 * clear * radius + 1.0) / between, -1.0, 1.0);
    float chord = sqrt(1.0 - x * x); // half of the chord's length
    float a = atan(chord, x), b = atan(chord, between - x);
    return 1.0 - (segmentArea(a) + radius * radius * segmentArea(b)) / PI;
}

// The visible share of the lamp beside a straight edge in space.
//   p        point, scene units
//   toLight  direction of the lamp's middle, length 1
//   spread   radius of the lamp's disc, > 0
//   onEdge   a point of the edge
//   along    direction of the edge, of any length; cross(onEdge - p, along) must point to the free side
//   exact: the plane through p and the edge meets the disc's plane in a line
float lampBesideEdge(vec3 p, vec3 toLight, float spread, vec3 onEdge, vec3 along)
{
    vec3 free = normalize(cross(onEdge - p, along));
    float up = dot(free, toLight);
    return discBesideEdge(up / (spread * sqrt(max(1.0 - up * up, 1e-12))));
}

// The visible share of the lamp beside a ball.
//   p, toLight, spread  as for lampBesideEdge
//   centre, radius      of the ball, which does not contain p. The whole outline of the ball must be in front of the
//                       plane through p perpendicular to toLight
//   formula  the ball hides directions up to beta = asin(radius / distance) from that of its centre, which
//            is at an angle of psi to toLight. On the disc's plane these directions fill an ellipse. The formula
//            replaces the ellipse with the circle of radius tan beta that touches it at the point nearest to toLight,
//            at tan(psi - beta)
//   exact if the ball's centre is straight in front of the lamp's; otherwise the error is at most 0.1 spread^2, which
//   is 1e-4 for a spread of 0.03; the spread of the sun is 0.0047
float lampBesideBall(vec3 p, vec3 toLight, float spread, vec3 centre, float radius)
{
    vec3 toBall = centre - p;
    float along = dot(toBall, toLight), aside = length(toBall - along * toLight);
    float touching = sqrt(max(dot(toBall, toBall) - radius * radius, 1e-12));
    float ball = radius / touching;                                       // tan beta
    float edge = (aside - along * ball) / max(along + aside * ball, 1e-6); // tan(psi - beta)
    return discBesideDisc(edge / spread, ball / spread);
}

// ---- One march ----

// Two bounds of the free angle around a ray, as the sine (most) and the tangent (least) of an angle. Both are 0 if the
// ray itself is blocked.
struct Clearance {
    float most;  // no larger angle is free: the smallest distance / t of the march
    float least; // everything within this angle is free, as far as the march went
};

// March once towards the light and record how wide the free path was.
//   ray         from shadowRay
//   tMin, tMax  where to search, scene units; an empty interval is free
//   threshold, maxSteps  of the march
//   most        with an exact distance, the sine of the angle is the smallest of distance / t over all t;
//               the smallest over the steps is never less
//   least       two balls of empty space, of radius a around the previous step and h around this step, meet in a
//               circle of radius sqrt(h^2 - y^2), y = h^2 / (2 a) before this step: the tangent of the smallest
//               angle of such a circle, among those less than a right angle. This needs a lower bound of the
//               distance
// Sources: I. Quilez, 'Soft shadows in raymarched SDFs' (2010), for the first; S. Aaltonen, 'GPU-based clay
// simulation and ray-tracing tech in Claybook', Game Developers Conference 2018, for the second.
Clearance clearanceAlong(Ray ray, float tMin, float tMax, float threshold, int maxSteps)
{
    traceBegin(tMin, tMax);
    Clearance clearance = Clearance(1e6, 1e6);
    float t = tMin, before = 1e6;
    int steps = 0;
    bool found = false;
    bool searching = tMin < tMax;
    while (searching) {
        float distance = distanceAt(ray.origin + t * ray.direction);
        traceStep(steps, t, distance);
        steps++;
        found = distance < threshold;
        float back = 0.5 * distance * distance / before, along = t - back;
        float radius = sqrt(max(distance * distance - back * back, 0.0));
        clearance.most = min(clearance.most, t > 0.0 ? distance / t : 1e6);
        clearance.least = min(clearance.least, along > 0.0 ? radius / along : 1e6);
        before = distance;
        t += distance;
        searching = !found && t < tMax && steps < maxSteps;
    }
    traceMarch(steps, t, found ? END_HIT : (t >= tMax ? END_PASSED : END_STEPS));
    if (found)
        clearance = Clearance(0.0, 0.0);
    return clearance;
}

// ---- Many rays ----

// Map a point of the unit square to a point of the disc, and equal areas to equal areas.
//   square   both coordinates in [0, 1]
//   returns  x, y in the disc of radius 1
//   formula  sqrt(u) (cos 2 pi v, sin 2 pi v): a ring from r to r + dr has the area 2 pi r dr = pi d(r^2)
vec2 discPoint(vec2 square)
{
    float turn = 2.0 * PI * square.y;
    return sqrt(square.x) * vec2(cos(turn), sin(turn));
}

// The direction to a point of the lamp.
//   toLight  direction of the lamp's centre, length 1
//   point    in the disc of radius 1
//   returns  length 1
vec3 lampDirection(vec3 toLight, float spread, vec2 point)
{
    vec3 axis = abs(toLight.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    vec3 right = normalize(cross(toLight, axis)), up = cross(right, toLight);
    return normalize(toLight + spread * (point.x * right + point.y * up));
}

// The share of side x side rays that reach the lamp. The unit square of discPoint is divided into side x side cells,
// and each ray goes to a random point of a different cell.
//   ray        from shadowRay, towards the lamp's centre
//   spread     radius of the lamp's disc, > 0
//   side       >= 0; with 0, no ray is marched and the result is 1
//   distance, threshold, maxSteps  as for lightReaching
//   dimension  the first of 2 side^2 dimensions of pixelRandom that are used
// As the number of samples grows, the mean of the result over the samples of a pixel tends to the visible share.
float lampReaching(Ray ray, float distance, float spread, int side, float threshold, int maxSteps,
                   int dimension)
{
    float arrived = 0.0;
    for (int i = 0; i < side * side; i++) {
        vec2 lot = vec2(pixelRandom(dimension + 2 * i), pixelRandom(dimension + 2 * i + 1));
        vec2 square = (vec2(i % side, i / side) + lot) / float(side);
        Ray there = Ray(ray.origin, lampDirection(ray.direction, spread, discPoint(square)));
        arrived += lightReaching(there, distance, threshold, maxSteps);
    }
    return side > 0 ? arrived / float(side * side) : 1.0;
}
