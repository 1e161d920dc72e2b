// Experiment of chapter 06: the pyramid with a wrong fold.
//
// A macro renames the chapter's sceneDistance, which is not used. Rays are not clipped to the
// pyramid's hull, because a wrong pyramid need not stay inside it. Everything else is as in the
// chapter.
#include "main.glsl"
#include "symmetry.glsl"

vec2 everywhere(Ray ray, float size)
{
    return vec2(0.0, 20.0);
}

#define tetrahedronInterval everywhere
#define sceneDistance chapterSceneDistance
#include "06_sierpinski_symmetry.frag"
#undef sceneDistance

uniform int mistake; // 1 in [0, 2]: 0 none, 1 the sign of the offset, 2 normals of length sqrt(2)

vec3 wrongFold(vec3 q, vec3 direction, float size)
{
    vec3 normal = direction * 0.70710678;
    float offset = 1.41421356 * size;
    if (mistake == 1) // the sign of the report's section 2.1.2, dot(p, normal) - offset, used in section 2.2.4
        return opReflect(q, normal, -offset);
    if (mistake == 2) // the plane, dot(q, direction) = -2 size, is right, but the normal's length is sqrt(2)
        return opReflect(q, direction, 2.0 * size);
    return opReflect(q, normal, offset);
}

float sceneDistance(vec3 p)
{
    vec3 q = pyramidPoint(p) - SIZE;
    float size = SIZE;
    for (int i = 0; i < levels; i++) {
        q = wrongFold(q, vec3(1.0, 1.0, 0.0), size);
        q = wrongFold(q, vec3(1.0, 0.0, 1.0), size);
        q = wrongFold(q, vec3(0.0, 1.0, 1.0), size);
        size *= 0.5;
    }
    return min(slabDistance(p), sdTetrahedronPlanes(q + size, size));
}
