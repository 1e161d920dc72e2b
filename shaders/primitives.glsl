// primitives.glsl - signed distances of the elementary volumes, each centred at the origin.
//
// The distances are positive outside, negative inside, and in scene units. Each is 1-Lipschitz: between two points
// its value changes by at most the distance between the points.

// A ball. Exact everywhere.
//   p        point, scene units
//   radius   > 0, scene units
//   formula  |p| - radius
// Source: report, section 2.1.1.
float sdSphere(vec3 p, float radius)
{
    return length(p) - radius;
}

// The half-space behind a plane. Exact everywhere.
//   p        point, scene units
//   normal   length 1, pointing out of the solid
//   height   of the plane along its normal, scene units
//   formula  dot(p, normal) - height
// Source: report, section 2.1.2.
float sdPlane(vec3 p, vec3 normal, float height)
{
    return dot(p, normal) - height;
}

// The signed distance of a box, computed from the distances to its three pairs of faces, each negative inside.
//   q        (|x| - a, |y| - b, |z| - c)
//   formula  |max(q, 0)| + min(max(q.x, q.y, q.z), 0)
float boxDistance(vec3 q)
{
    return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0);
}

// A box with axis-aligned faces. Exact everywhere.
//   p         point, scene units
//   halfSize  half of width, height and depth, scene units, each >= 0
// Source: report, section 2.1.3, whose 'taille' is this half size.
float sdBox(vec3 p, vec3 halfSize)
{
    return boxDistance(abs(p) - halfSize);
}

// The twelve edges of a box, as square beams. Exact outside; inside, where three beams meet at a corner, a lower
// bound of the depth.
//   p         point, scene units
//   halfSize  half of the outer width, height and depth, scene units
//   beam      half the thickness of a beam, scene units, in [0, smallest half size]
// Folded by |p|, the beams along x are one box: x within the outer size, y and z within half a beam's
// thickness of the beam's centre line. The same is true for y and z, and the result is the union of the three boxes.
// Source: report, annex A1.
float sdBoxFrame(vec3 p, vec3 halfSize, float beam)
{
    vec3 outer = abs(p) - halfSize;
    vec3 inner = abs(outer + beam) - beam;
    float alongX = boxDistance(vec3(outer.x, inner.y, inner.z));
    float alongY = boxDistance(vec3(inner.x, outer.y, inner.z));
    float alongZ = boxDistance(vec3(inner.x, inner.y, outer.z));
    return min(alongX, min(alongY, alongZ));
}
