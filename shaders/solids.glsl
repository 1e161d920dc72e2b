// solids.glsl - from the plane to space: a figure extruded along a line or revolved about an axis, and the
// solids made in this way.
//
// A figure is a signed distance in the plane, negative inside, scene units: plane.glsl has several. The
// solids are upright along the y axis, centred at the origin. docs/10_distance_in_the_plane.md proves
// which of them are exact.
#include "plane.glsl"

// ---- From the plane to space ----

// Extrusion: a figure moved along a straight line perpendicular to its plane.
//   figure      signed distance of the figure at the two coordinates perpendicular to the line, scene units
//   along       the third coordinate, from the middle of the solid, scene units
//   halfLength  half the length of the solid, scene units, >= 0
//   formula     |max(q, 0)| + min(max(q.x, q.y), 0), q = (figure, |along| - halfLength)
//   exact outside if figure is, exact inside if figure is; if figure is a lower bound, outside
//   or inside, so is the result; 1-Lipschitz if figure is
// For a solid along y: opExtrude(sdFigure(p.xz), p.y, halfHeight).
// Source: I. Quilez, 'Distance functions'.
float opExtrude(float figure, float along, float halfLength)
{
    vec2 q = vec2(figure, abs(along) - halfLength);
    return length(max(q, 0.0)) + min(max(q.x, q.y), 0.0);
}

// Revolution: map a point in space back to the plane of a figure that is revolved about the y axis. The half-plane
// through the axis and the point becomes the plane of the figure: x away from the axis, y upwards.
//   p        point, scene units
//   offset   scene units: the figure's origin moves on a circle of this radius; with 0, it is on the axis
//   formula  (|(x, z)| - offset, y); 1-Lipschitz
//   sd(opRevolve(p, offset))  a lower bound if sd is one, for every figure. The part of the figure,
//            moved by offset, at x < 0 is not drawn but still counts. Therefore the result is
//            exact outside if sd is and each point of the figure at x < 0 has its mirror image in the figure
//            (there is no such point, or the figure is symmetric, or the larger part is drawn);
//            exact inside if sd is and each point outside the figure at x < 0 has its mirror image outside
//            the figure, too, or the figure stays away from the axis
// Source: I. Quilez, 'Distance functions'.
vec2 opRevolve(vec3 p, float offset)
{
    return vec2(length(p.xz) - offset, p.y);
}

// ---- Solids ----

// A cylinder. Exact everywhere.
//   p           point, scene units
//   radius      >= 0, scene units
//   halfHeight  >= 0, scene units
//   formula     opExtrude of a disc, which equals opRevolve of a rectangle
float sdCylinder(vec3 p, float radius, float halfHeight)
{
    return opExtrude(sdCircle(p.xz, radius), p.y, halfHeight);
}

// A prism with six equal sides, two of them perpendicular to the x axis. Exact everywhere.
//   p           point, scene units
//   apothem     from the axis to the middle of a side, > 0, scene units; an edge is 2 / sqrt(3) times as far
//   halfHeight  >= 0, scene units
// The hexagon is symmetric about the planes x = 0, z = 0 and z = x / sqrt(3). Once the point is folded along these
// planes, one side is the nearest: at x = apothem, extending apothem / sqrt(3) in both directions.
float sdHexPrism(vec3 p, float apothem, float halfHeight)
{
    vec2 q = abs(p.xz);
    q -= 2.0 * min(dot(q, vec2(0.5, -0.86602540)), 0.0) * vec2(0.5, -0.86602540);
    q -= vec2(apothem, clamp(q.y, -0.57735027 * apothem, 0.57735027 * apothem));
    return opExtrude(q.x < 0.0 ? q.x : length(q), p.y, halfHeight);
}

// A cone with its tip cut off, or a whole cone. Exact everywhere.
//   p           point, scene units
//   below       radius at y = -halfHeight, >= 0, scene units
//   above       radius at y = halfHeight, >= 0, scene units; one of the two radii may be 0, for a tip
//   halfHeight  > 0, scene units
// The revolved figure is a trapezoid, symmetric about the axis. In the half with x >= 0 its boundary has
// three parts, two caps and the wall: the nearer of the wall and the cap on the point's side counts.
float sdCappedCone(vec3 p, float below, float above, float halfHeight)
{
    vec2 q = opRevolve(p, 0.0);
    vec2 cap = vec2(max(q.x - (q.y < 0.0 ? below : above), 0.0), abs(q.y) - halfHeight);
    vec2 foot = q - vec2(below, -halfHeight), slant = vec2(above - below, 2.0 * halfHeight);
    vec2 wall = foot - slant * clamp(dot(foot, slant) / dot(slant, slant), 0.0, 1.0);
    float distance = sqrt(min(dot(cap, cap), dot(wall, wall)));
    return cap.y < 0.0 && wall.x < 0.0 ? -distance : distance;
}

// All points within a radius of a segment: a rod with round ends. Exact everywhere.
//   p       point, scene units
//   a, b    ends of the segment, scene units, a != b
//   radius  >= 0, scene units
//   formula |p - nearest point of the segment| - radius
float sdCapsule(vec3 p, vec3 a, vec3 b, float radius)
{
    vec3 ap = p - a, ab = b - a;
    return length(ap - ab * clamp(dot(ap, ab) / dot(ab, ab), 0.0, 1.0)) - radius;
}
