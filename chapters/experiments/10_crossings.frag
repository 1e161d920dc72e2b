// Experiment of chapter 10: a polygon whose sides include both of their ends. At the height of a
// corner, the half-line from p to the right meets two sides where it crosses the outline once, so
// inside and outside are exchanged.
#include "main.glsl"
#include "plane.glsl"

float closedPolygon(vec2 p, vec2 corner[POLYGON_CORNERS], int count);

#define sdPolygon closedPolygon
#include "10_distance_in_the_plane.frag"
#undef sdPolygon

float closedPolygon(vec2 p, vec2 corner[POLYGON_CORNERS], int count)
{
    float nearest = 1e20;
    bool inside = false;
    vec2 a = corner[count - 1];
    for (int i = 0; i < count; i++) {
        vec2 b = corner[i], way = b - a, from = p - a;
        nearest = min(nearest, sdSegment(p, a, b));
        bool rises = a.y <= p.y && p.y <= b.y, falls = b.y <= p.y && p.y <= a.y;
        float left = way.x * from.y - way.y * from.x;
        inside = inside != ((rises && left > 0.0) || (falls && left < 0.0));
        a = b;
    }
    return inside ? -nearest : nearest;
}
