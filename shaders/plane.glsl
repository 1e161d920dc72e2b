// plane.glsl - signed distances of the elementary figures of the plane.
//
// The distances are positive outside, negative inside, and in scene units. Each is exact everywhere: it is the
// distance to the nearest point of the boundary. A figure without an interior, such as a segment or an arc, has a
// distance that is never negative; opRound gives it a width. The operations of combine.glsl work in the plane too.

// A disc around the origin. Exact everywhere.
//   p        point, scene units
//   radius   > 0, scene units
//   formula  |p| - radius
// Source: report, section 2.1.1, in the plane; the workshop's 'sdCircle'.
float sdCircle(vec2 p, float radius)
{
    return length(p) - radius;
}

// A segment, which has no interior. Exact everywhere.
//   p, a, b  the point and both ends, scene units, a != b
//   formula  |p - a - s (b - a)|, s = clamp((p - a) . (b - a) / |b - a|^2, 0, 1)
float sdSegment(vec2 p, vec2 a, vec2 b)
{
    vec2 way = b - a;
    float share = clamp(dot(p - a, way) / dot(way, way), 0.0, 1.0);
    return length(p - a - share * way);
}

// A rectangle around the origin with sides along the axes. Exact everywhere.
//   p         point, scene units
//   halfSize  half of width and height, scene units, each >= 0
//   formula   with q = |p| - halfSize, component by component: |max(q, 0)| + min(max(q.x, q.y), 0)
// Source: report, section 2.1.3, in the plane.
float sdRectangle(vec2 p, vec2 halfSize)
{
    vec2 q = abs(p) - halfSize;
    return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0);
}

// A triangle. Exact everywhere.
//   p        point, scene units
//   a, b, c  corners, scene units, in either order, not collinear
//   formula  the smallest of the three distances to a side, negative where p is on the inner side of
//            all three lines
float sdTriangle(vec2 p, vec2 a, vec2 b, vec2 c)
{
    vec2 ab = b - a, bc = c - b, ca = a - c, pa = p - a, pb = p - b, pc = p - c;
    vec2 fromAB = pa - clamp(dot(pa, ab) / dot(ab, ab), 0.0, 1.0) * ab;
    vec2 fromBC = pb - clamp(dot(pb, bc) / dot(bc, bc), 0.0, 1.0) * bc;
    vec2 fromCA = pc - clamp(dot(pc, ca) / dot(ca, ca), 0.0, 1.0) * ca;
    float nearest = sqrt(min(dot(fromAB, fromAB), min(dot(fromBC, fromBC), dot(fromCA, fromCA))));
    float turn = sign(ab.x * bc.y - ab.y * bc.x); // 1 if the corners are in counter-clockwise order
    vec3 inside = turn * vec3(ab.x * pa.y - ab.y * pa.x, bc.x * pb.y - bc.y * pb.x, ca.x * pc.y - ca.y * pc.x);
    return min(inside.x, min(inside.y, inside.z)) > 0.0 ? -nearest : nearest;
}

// The largest number of corners that a polygon may have.
const int POLYGON_CORNERS = 16;

// A polygon of 3 to 16 corners, convex or not. Exact everywhere. If its sides cross, the interior consists of the
// points from which a half-line meets the sides an odd number of times.
//   p        point, scene units
//   corner   the corners in order, clockwise or counter-clockwise, scene units, no two neighbours equal; elements
//            from count on are not read
//   count    number of corners, at most POLYGON_CORNERS
//   formula  the smallest distance to a side; its sign from the crossings of the half-line from p to the
//            right. A side contains its lower end but not its upper end, so that a corner counts once
// Source: M. Shimrat, 'Algorithm 112: position of point relative to polygon', Communications of the ACM
// 5 (1962), for the crossings.
float sdPolygon(vec2 p, vec2 corner[POLYGON_CORNERS], int count)
{
    float nearest = 1e20; // square of the smallest distance so far
    bool inside = false;
    vec2 a = corner[count - 1];
    for (int i = 0; i < count; i++) {
        vec2 b = corner[i], way = b - a, from = p - a;
        vec2 away = from - clamp(dot(from, way) / dot(way, way), 0.0, 1.0) * way;
        nearest = min(nearest, dot(away, away));
        bool begins = a.y <= p.y, ends = b.y <= p.y; // is this end at most as high as p?
        float left = way.x * from.y - way.y * from.x; // > 0 where p is on the left of the side
        inside = inside != (begins != ends && begins == left > 0.0);
        a = b;
    }
    return inside ? -sqrt(nearest) : sqrt(nearest);
}

// An arc of the circle around the origin, centred on the positive y axis; it has no interior. Exact everywhere.
//   p          point, scene units
//   radius     of the circle, > 0, scene units
//   halfAngle  from the arc's middle to either end, radians, in (0, pi); for a whole circle use opOnion
//   formula    with q = (|x|, y) and e = (sin halfAngle, cos halfAngle): | |q| - radius | where q.x e.y <=
//              q.y e.x, that is, where q is in the arc's sector; otherwise |q - radius e|
float sdArc(vec2 p, float radius, float halfAngle)
{
    vec2 q = vec2(abs(p.x), p.y);
    vec2 end = vec2(sin(halfAngle), cos(halfAngle));
    bool within = q.x * end.y <= q.y * end.x;
    return abs(length(within ? q : q - radius * end) - (within ? radius : 0.0)); // one square root for both cases
}

// A figure enlarged by a radius: all points within this distance of the figure. A segment or an arc becomes
// a stroke with round ends.
//   d        distance of the figure, scene units
//   radius   >= 0, scene units
//   formula  d - radius
//   exact outside if d is exact outside; inside, exact if d is exact and the figure convex, otherwise a
//   lower bound of the depth. To round a rectangle but keep its size, first make it smaller by radius
float opRound(float d, float radius)
{
    return d - radius;
}

// A shell along the boundary of a figure, on both sides of it.
//   d        distance of the figure, scene units
//   radius   half the shell's width, >= 0, scene units
//   formula  |d| - radius
//   exact outside the shell, on both sides of it, if d is exact on both sides; within the shell, it is a
//   lower bound of the depth
float opOnion(float d, float radius)
{
    return abs(d) - radius;
}
