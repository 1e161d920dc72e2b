// soft_shadow.glsl - how much of a lamp with a size a point sees.
//
// The lamp is a disc of radius spread, one unit in front of the point and across the way to it: the sun, or
// a round lamp of radius spread times its distance that faces the point. A place on the disc is given in its
// radii, (0, 0) its middle. docs/13_soft_shadows.md proves what is claimed here.
#include "random.glsl"
#include "shadow.glsl"

const float PI = 3.14159265;

// ---- What is seen, in closed form ----

// The share of the disc that a straight edge leaves to be seen.
//   clear    how far the middle of the disc stands clear of the edge, in radii; negative behind it
//   returns  0 up to clear = -1, 1/2 at 0, 1 from 1 on
//   formula  1/2 + (asin(c) + c sqrt(1 - c^2)) / pi, c = clear in [-1, 1]: what is left of the disc's area
//            beside a circular segment. Exact
float discBesideEdge(float clear)
{
    float c = clamp(clear, -1.0, 1.0);
    float root = sqrt(1.0 - c * c);
    return 0.5 + (atan(c, root) + c * root) / PI;
}

// The area of a circular segment, in a circle of radius 1: what a chord cuts off.
//   angle    half the angle under which the middle sees its chord, in [0, pi]
//   formula  a - sin(a) cos(a); for small angles the first terms of its series, 2 a^3 / 3 - 2 a^5 / 15
float segmentArea(float angle)
{
    float square = angle * angle;
    float series = angle * square * (2.0 / 3.0 - 2.0 / 15.0 * square);
    return angle < 0.1 ? series : angle - sin(angle) * cos(angle);
}

// The share of the disc that another disc leaves to be seen.
//   clear    how far the middle of the first stands clear of the other's rim, in radii of the first;
//            negative behind it, at least -radius
//   radius   of the other, in the same unit, > 0; for a large one it is discBesideEdge
//   formula  1 - (S(a) + radius^2 S(b)) / pi, S = segmentArea: two segments on one chord. With d = clear +
//            radius from middle to middle, the chord stands at x = cos a = (d^2 + 1 - radius^2) / (2 d) from
//            the one and at d - x = radius cos b from the other. Exact for discs in one plane
float discBesideDisc(float clear, float radius)
{
    float between = max(clear + radius, 1e-6);
    float x = clamp(0.5 * (clear * clear + 2.0 * clear * radius + 1.0) / between, -1.0, 1.0);
    float chord = sqrt(1.0 - x * x); // half of it
    float a = atan(chord, x), b = atan(chord, between - x);
    return 1.0 - (segmentArea(a) + radius * radius * segmentArea(b)) / PI;
}

// The share of the lamp that is seen past a straight edge in space.
//   p        point, scene units
//   toLight  direction of the lamp's middle, length 1
//   spread   radius of the lamp's disc, > 0
//   onEdge   a point of the edge
//   along    its direction, of any length, so that cross(onEdge - p, along) points to the free side
//   exact: plane through p and the edge meets the disc's plane in a line
float lampBesideEdge(vec3 p, vec3 toLight, float spread, vec3 onEdge, vec3 along)
{
    vec3 free = normalize(cross(onEdge - p, along));
    float up = dot(free, toLight);
    return discBesideEdge(up / (spread * sqrt(max(1.0 - up * up, 1e-12))));
}

// The share of the lamp that is seen past a ball.
//   p, toLight, spread  as above
//   centre, radius      of the ball, which does not hold p and lies, with all its outline, before p's
//                       horizon across toLight
//   formula  the ball hides directions up to b = asin(radius / distance) from its middle's, which stands
//            s from toLight. On the disc's plane that is an ellipse (or more); taken for it is the circle
//            of radius tan b that touches it at its point nearest to toLight, at tan(s - b)
//   exact where the ball's middle is straight before the lamp's; else off by at most 0.1 spread^2, which
//   is 1e-4 at the spread 0.03; the sun's is 0.0047
float lampBesideBall(vec3 p, vec3 toLight, float spread, vec3 centre, float radius)
{
    vec3 toBall = centre - p;
    float along = dot(toBall, toLight), aside = length(toBall - along * toLight);
    float touching = sqrt(max(dot(toBall, toBall) - radius * radius, 1e-12));
    float ball = radius / touching;                                       // tan b
    float edge = (aside - along * ball) / max(along + aside * ball, 1e-6); // tan(s - b)
    return discBesideDisc(edge / spread, ball / spread);
}

// ---- What one march knows ----

// The angle round a ray in which nothing stands, as its tangent or sine, between two bounds. Both are 0
// where the ray itself is stopped.
struct Clearance {
    float most;  // no larger angle is free: the smallest distance / t of the march
    float least; // all within this angle is free, as far as the march went
};

// March once towards the light and note how wide the way was.
//   ray         from shadowRay
//   tMin, tMax  where to look, scene units; an empty interval is free
//   threshold, maxSteps  of the march
//   most        the sine of the angle would be the smallest of distance / t over all t, by an exact distance;
//               over the steps it is that or more
//   least       two balls of empty space, of radius a round the last step and h round this, meet in a circle
//               of radius sqrt(h^2 - y^2), y = h^2 / (2 a) before this step: the tangent of the angle of
//               the smallest such circle, where it is not beyond a right angle. Needs a lower bound of the
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

// ---- What many rays find ----

// From a point of the unit square to one of the disc: equal areas to equal areas.
//   square   each in [0, 1]
//   returns  x, y in the disc of radius 1
//   formula  sqrt(u) (cos 2 pi v, sin 2 pi v): a ring from r to r + dr has the area 2 pi r dr = pi d(r^2)
vec2 discPoint(vec2 square)
{
    float turn = 2.0 * PI * square.y;
    return sqrt(square.x) * vec2(cos(turn), sin(turn));
}

// The direction of a point of the lamp.
//   toLight  of its middle, length 1
//   point    in the disc of radius 1
//   returns  length 1
vec3 lampDirection(vec3 toLight, float spread, vec2 point)
{
    vec3 axis = abs(toLight.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0);
    vec3 right = normalize(cross(toLight, axis)), up = cross(right, toLight);
    return normalize(toLight + spread * (point.x * right + point.y * up));
}

// The share of side x side rays to the lamp that arrive: the square of discPoint is cut into so many cells,
// and each ray goes to a place in one of them, drawn by lot.
//   ray        from shadowRay, towards the lamp's middle
//   spread     radius of the lamp's disc, > 0
//   side       >= 0; with 0 nothing is looked for, and 1 returned
//   distance, threshold, maxSteps  as of lightReaching
//   dimension  the first of 2 side^2 dimensions of pixelRandom that it uses
// Its mean over the samples of a pixel tends to the share that is seen.
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
