// Solution to exercise 10.3: the exact distance to a regular hexagon. The point is folded into a
// twelfth of the plane, which contains only half a side.
#include "main.glsl"
#define sceneDistance chapterDistance
#include "10_distance_in_the_plane.frag"
#undef sceneDistance

// A hexagon with its flat sides above and below.
//   apothem  from the centre to a side, units
float sdHexagon(vec2 p, float apothem)
{
    const vec2 mirror = vec2(-0.8660254, 0.5); // normal of the line at 60 degrees
    p = abs(p);
    p -= 2.0 * min(dot(p, mirror), 0.0) * mirror;
    p.x = abs(p.x);
    vec2 away = p - vec2(clamp(p.x, 0.0, apothem * 0.57735027), apothem);
    return away.y > 0.0 ? length(away) : -length(away);
}

float sceneDistance(vec3 p)
{
    return sdHexagon(p.xy, 0.75);
}
