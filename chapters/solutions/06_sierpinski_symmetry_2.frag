// Solution to exercise 06.2: 6^m octahedra after m levels. At each level, three folds bring a point
// to the octant where all coordinates are positive, and two more make x the largest coordinate.
//
// Macros replace the chapter's calls to the library with calls to the functions here.
#include "main.glsl"
#include "symmetry.glsl"
#include "bounds.glsl"

// The octahedron with its corners on the axes, at the distance size from the centre. If d is the
// true distance, the result is d inside and between d / sqrt(3) and d outside.
float sdOctahedronPlanes(vec3 p, float size)
{
    p = abs(p);
    return (p.x + p.y + p.z - size) * 0.57735027;
}

// As in foldToCorner, q is measured from size (1, 1, 1), where the octahedron has no corner.
vec3 foldToTip(vec3 q, float size)
{
    vec3 p = abs(q + size);
    p.xy += vec2(1.0, -1.0) * max(p.y - p.x, 0.0);
    p.xz += vec2(1.0, -1.0) * max(p.z - p.x, 0.0);
    p.x -= 0.5 * size;
    return p - 0.5 * size;
}

float sdOctahedra(vec3 p, float size, int levels)
{
    vec3 q = p - size;
    for (int i = 0; i < levels; i++) {
        q = foldToTip(q, size);
        size *= 0.5;
    }
    return sdOctahedronPlanes(q + size, size);
}

vec2 octahedronInterval(Ray ray, float size)
{
    return boxInterval(ray, vec3(-size), vec3(size));
}

#define foldToCorner foldToTip
#define sdTetrahedronPlanes sdOctahedronPlanes
#define sdSierpinskiPlanes sdOctahedra
#define tetrahedronInterval octahedronInterval
#include "06_sierpinski_symmetry.frag"
