#version 330 core
// For symmetry.c and cone.c: folds, tetrahedra, pyramids and cones at random points and along random rays.
//
// Each item takes 4 pixels of a row. Time selects the function; iMouse contains its arguments.

in float Time;
out vec4 FragColor;

#include "random.glsl"
#include "primitives.glsl"
#include "cone.glsl"
#include "symmetry.glsl"

const float SIZE = 0.75;

// The scene of the rays, selected by iMouse.x: 0 is a ball, 1 a plane, 2 a pyramid of two levels.
float sceneDistance(vec3 p)
{
    int which = int(iMouse.x);
    if (which == 0)
        return sdSphere(p, 1.0);
    return which == 1 ? sdPlane(p, vec3(0.0, 1.0, 0.0), 0.0) : sdSierpinskiPlanes(p, SIZE, 2);
}

// Not used here, but the library declares this function.
Ray pixelRay(vec2 screen)
{
    return Ray(vec3(screen, 0.0), vec3(0.0, 0.0, -1.0));
}

float asked(vec3 p)
{
    int which = int(Time), levels = int(iMouse.x);
    if (which == 0)
        return sdTetrahedronPlanes(p, SIZE);
    if (which == 1)
        return sdTetrahedron(p, SIZE);
    return which == 2 ? sdSierpinskiPlanes(p, SIZE, levels) : sdSierpinski(p, SIZE, levels);
}

vec3 folded(vec3 p)
{
    return int(Time) == 10 ? opReflect(p, iMouse.xyz, iMouse.w) : foldToCorner(p, SIZE);
}

// One of the tetrahedron's corners, numbered 0 to 3.
vec3 corner(int number)
{
    return number == 0 ? vec3(1.0) : 2.0 * vec3(number == 1, number == 2, number == 3) - 1.0;
}

// A random point on the surface of a pyramid, on one face of one of its tetrahedra.
vec3 surfacePoint(int levels)
{
    vec3 centre = vec3(0.0);
    float size = SIZE;
    for (int i = 0; i < levels; i++) {
        size *= 0.5;
        centre += size * corner(int(nextBits() >> 30));
    }
    int first = int(nextBits() >> 30);
    vec3 share = abs(nextVector()) + 0.001;
    share /= share.x + share.y + share.z;
    return centre + size * (share.x * corner((first + 1) % 4) + share.y * corner((first + 2) % 4) +
                            share.z * corner((first + 3) % 4));
}

// If iMouse.w is 2, the points are on the surface; if it is 3, they are uniformly distributed in the cube around the
// solid. Otherwise, of every eight points, four are in a cube around the solid, one is far away, one near a corner, one
// straight in front of a corner, and one in a plane of symmetry.
vec3 point(int item)
{
    if (iMouse.w == 2.0 && Time < 10.0)
        return surfacePoint(int(iMouse.x));
    if (iMouse.w == 3.0 && Time < 10.0)
        return SIZE * nextVector();
    vec3 p = 1.5 * nextVector();
    int kind = item % 8;
    if (kind == 4)
        p *= 64.0;
    if (kind == 5)
        p = SIZE * corner(item / 8 % 4) + 0.1 * p;
    if (kind == 6)
        p = SIZE * corner(item / 8 % 4) * (1.0 + abs(p.x));
    if (kind == 7)
        p.x = -p.y;
    return p;
}

// A ray from a random point in a cube to a random point near the centre.
Ray randomRay()
{
    vec3 origin = 4.0 * nextVector();
    vec3 direction = 1.2 * nextVector() - origin;
    return Ray(origin, direction / max(length(direction), 0.001));
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    int item = pixel.x / 4 + 256 * pixel.y;
    int slot = pixel.x % 4;
    seed = uint(item) * 9781u + 17u;
    traceReset(-1);
    vec4 result[4] = vec4[4](vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0));
    if (Time < 20.0) {
        vec3 p = point(item);
        vec3 q = p + exp2(-16.0 * abs(nextSigned())) * nextVector();
        result[0] = vec4(p, asked(p));
        result[1] = vec4(q, asked(q));
        result[2] = vec4(folded(p), 0.0);
        result[3] = vec4(folded(q), 0.0);
    } else {
        // iMouse: scene, threshold, spread, maximum number of steps
        Ray ray = randomRay();
        result[0] = vec4(ray.origin, pixelSpread());
        result[1] = vec4(ray.direction, march(ray, 0.0, 12.0, iMouse.y, int(iMouse.w)).t);
        int before = trace.allSteps;
        Hit hit = marchCone(ray, 0.0, 12.0, iMouse.y, iMouse.z, int(iMouse.w));
        result[2] = vec4(hit.t, hit.found, trace.allSteps - before, trace.steps);
        result[3].xy = tetrahedronInterval(ray, SIZE);
        result[3].z = coneReaching(ray, 0.0, 12.0, iMouse.y, iMouse.z, int(iMouse.w));
        result[3].w = float(trace.marches);
    }
    FragColor = result[slot];
}
