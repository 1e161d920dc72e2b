// Experiment of chapter 23: the exact root. Along a ray, the interpolated distance in one cell is a cubic, whose first
// root can be found without a threshold. The march goes to the end of a cell wherever that is farther than a safe step.
#include "main.glsl"
#include "cone.glsl"
#include "stored.glsl"

uniform bool exact; // true: rays end at the root of the cubic; false: where the march of the chapter ends

StoredCell here; // the cell of the last point at which the clay was evaluated
bool inCube;     // whether this point was in the cube

// storedDistance, which also records the cell.
float cellDistance(sampler3D values, vec3 p)
{
    vec3 q = clamp(p, -1.0, 1.0);
    here = storedCell(values, q);
    inCube = q == p;
    return inCube ? trilinear(here) : length(vec2(length(p - q), trilinear(here)));
}

Hit marchToRoot(Ray ray, float tMin, float tMax, float threshold, float spread, int maxSteps);

#define storedDistance cellDistance
#define marchCone marchToRoot
#include "23_stored_distances.frag"
#undef marchCone

// The interpolation along a ray: a cubic in t, the path from the position cell.share, measured in cells.
//   along    direction of length 1 in the elephant's coordinates
//   formula  each of the three interpolations of trilinear multiplies by a linear function of t
//   returns  the coefficients of 1, t, t^2 and t^3, scene units
vec4 cubicAlong(StoredCell cell, vec3 along)
{
    vec3 s = cell.share;
    vec4 a = mix(cell.near, cell.far, s.z), b = along.z * (cell.far - cell.near); // a + b t: on the four edges along z
    vec2 da = a.zw - a.xy, db = b.zw - b.xy;
    vec2 c0 = a.xy + s.y * da, c1 = b.xy + s.y * db + along.y * da, c2 = along.y * db; // two quadratics
    vec3 low = vec3(c0.x, c1.x, c2.x), rise = vec3(c0.y, c1.y, c2.y) - low;
    return vec4(low + s.x * rise, 0.0) + along.x * vec4(0.0, rise);
}

float cubicAt(vec4 c, float t)
{
    return c.x + t * (c.y + t * (c.z + t * c.w));
}

// The first root of a cubic in (0, last], or -1 if there is none.
//   c        from cubicAlong; the cubic is positive at 0
//   formula  the extrema cut the interval into at most three monotone pieces; the first piece whose end is not positive
//            contains the root, and 20 bisections find it
//   returns  cells; exact to last / 2^21, apart from the rounding of the cubic
float firstRoot(vec4 c, float last)
{
    float square = c.z * c.z - 3.0 * c.w * c.y;
    float q = -c.z - (c.z < 0.0 ? -1.0 : 1.0) * sqrt(max(square, 0.0));
    float one = square > 0.0 && c.w != 0.0 ? clamp(q / (3.0 * c.w), 0.0, last) : last;
    float other = square > 0.0 && q != 0.0 ? clamp(c.y / q, 0.0, last) : last;
    vec3 ends = vec3(min(one, other), max(one, other), last);
    float low = 0.0, high = -1.0;
    for (int k = 0; k < 3 && high < 0.0; k++) {
        high = cubicAt(c, ends[k]) <= 0.0 ? ends[k] : -1.0;
        low = high < 0.0 ? ends[k] : low;
    }
    for (int k = 0; k < 20 && high >= 0.0; k++) {
        float middle = 0.5 * (low + high);
        bool outside = cubicAt(c, middle) > 0.0;
        low = outside ? middle : low;
        high = outside ? high : middle;
    }
    return high < 0.0 ? -1.0 : 0.5 * (low + high);
}

// The path to the face through which a ray leaves its cell, in cells.
//   share  position in the cell
float cellExit(vec3 share, vec3 along)
{
    vec3 far = step(0.0, along) - share;
    vec3 path = vec3(along.x == 0.0 ? 2.0 : far.x / along.x, along.y == 0.0 ? 2.0 : far.y / along.y,
                     along.z == 0.0 ? 2.0 : far.z / along.z);
    return max(min(min(path.x, path.y), min(path.z, 2.0)), 0.0);
}

// marchCone, except that on the clay it ends at the root of the cubic instead of near the surface.
Hit marchToRoot(Ray ray, float tMin, float tMax, float threshold, float spread, int maxSteps)
{
    if (!exact)
        return marchCone(ray, tMin, tMax, threshold, spread, maxSteps);
    vec3 along = onTurntable(ray.direction);
    traceBegin(tMin, tMax);
    float t = tMin;
    int steps = 0;
    bool found = false, searching = tMin < tMax;
    while (searching) {
        vec3 p = ray.origin + t * ray.direction;
        float distance = distanceAt(p), stand = turntableDistance(p);
        traceStep(steps, t, distance);
        steps++;
        found = distance <= 0.0 || stand < threshold + spread * t;
        if (!found) {
            float cell = inCube ? STORED_CELL * cellExit(here.share, along) : 0.0, reach = min(cell, stand);
            float root = distance < reach ? firstRoot(cubicAlong(here, along), reach / STORED_CELL) : -1.0;
            found = root >= 0.0;
            t += found ? STORED_CELL * root : min(max(distance, cell + 2e-6), stand); // just into the next cell
        }
        searching = !found && t < tMax && steps < maxSteps;
    }
    traceMarch(steps, t, found ? END_HIT : (t >= tMax ? END_PASSED : END_STEPS));
    return Hit(found, t);
}
