// symmetry.glsl - mirrors: space folded along planes, and the tetrahedra that folds make cheap.
#include "scene.glsl"

// Fold space along a plane: a point behind the plane is replaced by its mirror image, and a point in front stays.
// The fold is one-sided: the part of a scene behind the plane is lost, and the part in front appears twice.
//   p        point, scene units
//   normal   of the plane, length 1, pointing to the side that is kept
//   offset   scene units; the plane is dot(p, normal) = -offset
//   formula  p - 2 min(dot(p, normal) + offset, 0) normal; with (-normal, -offset) the plane is the same, and
//            the other side is kept
// The fold is 1-Lipschitz: a distance evaluated at the folded point is a lower bound of the distance to the visible
// scene, and is exact outside if no part of the scene lies behind the plane. If the length of the normal is not 1, the
// plane is not a mirror, and if the length is more than 1, the distance is not a bound.
// Source: report, section 2.2.4.
vec3 opReflect(vec3 p, vec3 normal, float offset)
{
    return p - 2.0 * min(dot(p, normal) + offset, 0.0) * normal;
}

// A regular tetrahedron with the corners (1, 1, 1), (1, -1, -1), (-1, 1, -1) and (-1, -1, 1) times
// size: alternate corners of a cube. Exact inside; outside a lower bound: if d is the true distance, the result is
// d in front of a face, at least d / sqrt(3) in front of an edge, and at least d / 3 in front of a corner.
//   p        point, scene units
//   size     half the side of that cube, scene units, > 0; an edge is sqrt(8) size long
//   formula  the largest of the signed distances to the planes of the four faces, each
//            (dot(p, n) - size) / sqrt(3) with n = (-1, -1, -1), (-1, 1, 1), (1, -1, 1), (1, 1, -1)
// Source: report, section 3.3 and its engine.
float sdTetrahedronPlanes(vec3 p, float size)
{
    float largest = max(abs(p.x + p.y) - p.z, abs(p.x - p.y) + p.z);
    return (largest - size) * 0.57735027;
}

// The tetrahedron of sdTetrahedronPlanes. Exact everywhere.
//   p, size  as for sdTetrahedronPlanes
// Three folds bring p in front of the face x + y + z = -size. The nearest of that face's edges is the one
// on which the smallest coordinate is -size. Beyond that edge, the distance to the edge is returned; otherwise, the
// distance to the face's plane. The vector from the edge to p has the components sqrt(2) middle and low + size
// perpendicular to the edge, and sqrt(2) past along the edge, beyond its end.
float sdTetrahedron(vec3 p, float size)
{
    p.xy -= max(p.x + p.y, 0.0);
    p.xz -= max(p.x + p.z, 0.0);
    p.yz -= max(p.y + p.z, 0.0);
    float low = min(p.x, min(p.y, p.z));
    float high = max(p.x, max(p.y, p.z));
    float sum = p.x + p.y + p.z;
    float middle = 0.5 * (sum - low);
    float past = max(high - middle - size, 0.0);
    float edge = length(vec3(1.41421356 * vec2(middle, past), low + size));
    return middle - low > size ? edge : -(sum + size) * 0.57735027;
}

// One level of the pyramid: three folds, after which the corner (1, 1, 1) is the nearest of the four.
// No fold has to be repeated, because each fold moves a point towards the kept sides of the other two.
//   q        point, scene units, measured from that corner
//   size     of the tetrahedron that is divided into four, scene units
//   formula  opReflect with the normals (1, 1, 0), (1, 0, 1), (0, 1, 1) divided by sqrt(2) and the offset
//            sqrt(2) size, written out: the roots cancel
vec3 foldToCorner(vec3 q, float size)
{
    q.xy -= min(q.x + q.y + 2.0 * size, 0.0);
    q.xz -= min(q.x + q.z + 2.0 * size, 0.0);
    q.yz -= min(q.y + q.z + 2.0 * size, 0.0);
    return q;
}

// The Sierpinski pyramid: 4^levels tetrahedra from three folds per level, with halving offsets. Exact inside;
// outside between d / 3 and d, as for sdTetrahedronPlanes, on which it is built.
//   p        point, scene units
//   size     of the whole pyramid, as for sdTetrahedronPlanes
//   levels   >= 0; 0 is the tetrahedron itself. At most 15, because the size of the smallest tetrahedra is
//            size / 2^levels and floats are rounded
// Source: W. Sierpinski (1915), in the plane; report, section 3.3 and its engine.
float sdSierpinskiPlanes(vec3 p, float size, int levels)
{
    vec3 q = p - size;
    for (int i = 0; i < levels; i++) {
        q = foldToCorner(q, size);
        size *= 0.5;
    }
    return sdTetrahedronPlanes(q + size, size);
}

// The pyramid of sdSierpinskiPlanes. Exact everywhere.
//   p, size, levels  as for sdSierpinskiPlanes
float sdSierpinski(vec3 p, float size, int levels)
{
    vec3 q = p - size;
    for (int i = 0; i < levels; i++) {
        q = foldToCorner(q, size);
        size *= 0.5;
    }
    return sdTetrahedron(q + size, size);
}

// The interval in which a ray is inside the tetrahedron: boxInterval of bounds.glsl with four planes.
//   size     as for sdTetrahedronPlanes; to enclose a pyramid, a little more than its size
//   returns  (entry, exit) along the ray, entry >= 0; entry >= exit if the ray misses the tetrahedron
//   formula  a plane is crossed at (size - dot(origin, n)) / dot(direction, n), inwards where
//            dot(direction, n) < 0, outwards where it is > 0; where it is 0 the plane is left out, so
//            the interval may be too long, never too short. The four n add up to 0, so a ray enters
//            through three planes at most, and the entry of the fourth stays 0
vec2 tetrahedronInterval(Ray ray, float size)
{
    mat4x3 outwards = mat4x3(-1.0, -1.0, -1.0, -1.0, 1.0, 1.0, 1.0, -1.0, 1.0, 1.0, 1.0, -1.0);
    vec4 along = ray.direction * outwards;
    vec4 crossing = (size - ray.origin * outwards) / along;
    vec4 entry = mix(vec4(0.0), crossing, lessThan(along, vec4(0.0)));
    vec4 leave = mix(vec4(1e9), crossing, greaterThan(along, vec4(0.0)));
    return vec2(max(max(entry.x, entry.y), max(entry.z, entry.w)),
                min(min(leave.x, leave.y), min(leave.z, leave.w)));
}
