// Solution to exercise 10.7: the exact distance to the intersection of two discs. Beyond the tips,
// the nearest point is a tip.
#include "main.glsl"
#define sceneDistance chapterDistance
#include "10_distance_in_the_plane.frag"
#undef sceneDistance

// The lens of two discs with centres at (-apart, 0) and (apart, 0).
//   radius, apart  units, 0 < apart < radius
float sdLens(vec2 p, float radius, float apart)
{
    p = abs(p);
    float tip = sqrt(radius * radius - apart * apart);
    // On the right the outline is an arc around the left centre, up to the tip. p is in the arc's
    // sector if it lies under the line from that centre through the tip.
    vec2 q = p + vec2(apart, 0.0);
    return q.y * apart <= q.x * tip ? length(q) - radius : length(p - vec2(0.0, tip));
}

float sceneDistance(vec3 p)
{
    return sdLens(p.xy, 1.0, 0.6);
}
