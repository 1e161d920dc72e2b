// Solution to exercise 06.1: the Sierpinski triangle in the plane. Two folds per level give three
// copies.
//
// experiments/06_fold.frag draws the triangle. A macro renames that file's sceneDistance, which is
// the distance to a letter.
#include "main.glsl"
#define sceneDistance letterDistance
#include "experiments/06_fold.frag"
#undef sceneDistance

uniform int levels; // 6 in [0, 12]: how often each triangle is divided into three

const float RADIUS = 1.7; // from the centre to a corner, units

// The distance to the triangle, computed from its three lines. If d is the true distance, the
// result is d inside and between d / 2 and d outside.
float sdTriangleLines(vec3 p, float radius)
{
    return max(0.8660254 * abs(p.x) + 0.5 * p.y, -p.y) - 0.5 * radius;
}

// The mirrors are halfway between the upper corner, from which q is measured, and the other two
// corners.
float sceneDistance(vec3 p)
{
    vec3 q = p - vec3(0.0, RADIUS - 0.35, 0.0);
    float radius = RADIUS;
    for (int i = 0; i < levels; i++) {
        q = opReflect(q, vec3(-0.5, 0.8660254, 0.0), 0.8660254 * radius);
        q = opReflect(q, vec3(0.5, 0.8660254, 0.0), 0.8660254 * radius);
        radius *= 0.5;
    }
    return sdTriangleLines(q + vec3(0.0, radius, 0.0), radius);
}
