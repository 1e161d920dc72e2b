// Experiment of chapter 16: a frame of chapter 06 in less time. Where a ray cannot meet the
// pyramid, only the slab is evaluated. The normal comes from both distances only if the ray has
// ended where both were evaluated, and shadow rays evaluate only the pyramid.
//
// Up to the end of the pyramid's bounds, a march takes the same steps as in chapter 06. Beyond the
// bounds, its steps may be longer, but nearly all rays end at the same point. The coarse pass is
// not used, because it gains nothing in this scene.
#include "main.glsl"
#define sceneDistance chapterDistance
#define rayColour chapterRayColour
#include "06_sierpinski_symmetry.frag"
#undef sceneDistance
#undef rayColour

// The distance to the pyramid, without the slab.
float sceneDistance(vec3 p)
{
    return sdSierpinskiPlanes(pyramidPoint(p), SIZE, levels);
}

// The distance to the pyramid at t on a ray that was rotated to the pyramid's axes once for all its steps.
float turnedDistance(Ray turned, float t)
{
    trace.evaluations++;
    return sdSierpinskiPlanes(turned.origin + t * turned.direction, SIZE, levels);
}

// boxInterval of bounds.glsl for the slab, with multiplications instead of most of its divisions.
vec2 inSlab(Ray ray)
{
    vec3 inverse = 1.0 / ray.direction;
    vec3 middle = inverse * (SLAB - ray.origin), aside = abs(inverse) * (SLAB_HALF + MARGIN);
    vec3 entry = middle - aside, leave = middle + aside;
    return vec2(max(0.0, max(entry.x, max(entry.y, entry.z))), min(leave.x, min(leave.y, leave.z)));
}

// Where a ray ends: within the pyramid's bounds the march takes the smaller of the distances to the
// pyramid and the slab, and after that only the distance to the slab.
struct End {
    float t;
    bool met, near; // whether the ray hit something; whether it did so where both distances were evaluated
};

End endOf(Ray ray, float spread)
{
    Ray turned = Ray(pyramidPoint(ray.origin), TO_PYRAMID * ray.direction);
    vec2 pyramid = tetrahedronInterval(turned, SIZE + 1.7320508 * MARGIN), slab = inSlab(ray);
    float t = intervalUnion(pyramid, slab).x;
    traceBegin(t, pyramid.y);
    int steps = 0;
    bool near = false, searching = pyramid.x < pyramid.y;
    while (searching) {
        float distance = min(turnedDistance(turned, t), ray.origin.y + t * ray.direction.y);
        traceStep(steps, t, distance);
        steps++;
        near = distance < hitThreshold + spread * t;
        t += near ? 0.0 : distance;
        searching = !near && t < pyramid.y && steps < maxSteps;
    }
    traceMarch(steps, t, near ? END_HIT : END_PASSED);

    bool met = near;
    searching = !near && t < slab.y;
    while (searching) {
        float distance = length(max(abs(ray.origin + t * ray.direction - SLAB) - SLAB_HALF, 0.0));
        met = distance < hitThreshold + spread * t;
        t += met ? 0.0 : distance;
        steps++;
        searching = !met && t < slab.y && steps < maxSteps;
    }
    return End(t, met, near);
}

// The normal from both distances. The pyramid is well inside the slab's outline, so near the pyramid the distance to
// the slab is the height.
//   asked  if false, the loop ends at once, and the result is undefined
vec3 bothNormal(vec3 p, float h, bool asked)
{
    vec3 gradient = vec3(0.0);
    for (int i = 0; i < 6 && asked; i++) {
        float side = i < 3 ? h : -h;
        vec3 axis = side * vec3(i == 0 || i == 3, i == 1 || i == 4, i == 2 || i == 5);
        gradient += axis * min(distanceAt(p + axis), p.y + axis.y);
    }
    return normalize(gradient);
}

// The normal of the slab. It points upwards, and near an edge a little to the side, about as the
// normal from differences with the step h does.
vec3 slabNormal(vec3 p, float h)
{
    vec3 q = p - SLAB, reach = max(abs(q) - SLAB_HALF + h, 0.0);
    return normalize(reach * reach * sign(q));
}

vec3 rayColour(Ray ray)
{
    float spread = footprint * pixelSpread();
    End end = endOf(ray, spread);
    vec3 p = ray.origin + end.t * ray.direction, toSun = sunDirection();
    vec3 light = skyLight(ray.direction, toSun);
    if (end.met) {
        float radius = hitThreshold + spread * end.t, step = normalStep + spread * end.t;
        vec3 both = bothNormal(p, step, end.near), normal = end.near ? both : slabNormal(p, step);
        traceNormal(normal);
        traceMarch(trace.steps, end.t, END_HIT);
        Trail trail = foldTrail(p);
        vec3 ambient = mix(EARTH_COLOUR, SKY_COLOUR, (0.5 + 0.5 * normal.y) * trail.open);
        vec3 stone = hsvToRGB(46.0 - 60.0 * trail.address, tint, 0.85);
        vec3 colour = end.near && p.y >= radius ? stone : slabColour(p, ray.direction, radius);
        light = colour * (ambient + sunLight(p, normal, toSun, radius));
    }
    return encodeSRGB(light);
}
