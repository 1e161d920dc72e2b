// Solution to exercise 10.2: a star of five crossing sides, filled where the outline winds around a
// point.
#include "main.glsl"
#define sceneDistance chapterDistance
#include "10_distance_in_the_plane.frag"
#undef sceneDistance

const vec2 CROSSED[POLYGON_CORNERS] = vec2[POLYGON_CORNERS](
    vec2(0.0, 0.95), vec2(0.559, -0.769), vec2(-0.904, 0.294), vec2(0.904, 0.294), vec2(-0.559, -0.769), vec2(0.0),
    vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0), vec2(0.0));

// The distance to the nearest side. A point p is inside if the outline winds around it: a rising
// side to the right of p adds one anticlockwise turn, a falling side one clockwise turn.
float windingPolygon(vec2 p, vec2 corner[POLYGON_CORNERS], int count)
{
    float nearest = 1e6;
    int turns = 0;
    vec2 a = corner[count - 1];
    for (int i = 0; i < count; i++) {
        vec2 b = corner[i], way = b - a, from = p - a;
        nearest = min(nearest, sdSegment(p, a, b));
        float left = way.x * from.y - way.y * from.x;
        if (a.y <= p.y && p.y < b.y && left > 0.0)
            turns++;
        if (b.y <= p.y && p.y < a.y && left < 0.0)
            turns--;
        a = b;
    }
    return turns != 0 ? -nearest : nearest;
}

float sceneDistance(vec3 p)
{
    return windingPolygon(p.xy, CROSSED, 5);
}
