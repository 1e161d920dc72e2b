// Solution of exercise 06.2: 6^n octahedra. Three folds bring a point to the octant where all coordinates
// are positive, two more to the side of the corner (1, 0, 0).
//
// The chapter's calls into the library are turned into calls of the functions here.
#include "main.glsl"
#include "symmetry.glsl"
#include "bounds.glsl"

// The octahedron with corners at size along the axes. Inside exact; outside between d / sqrt(3) and d.
float sdOctahedronPlanes(vec3 p, float size)
{
    p = abs(p);
    return (p.x + p.y + p.z - size) * 0.57735027;
}

// As foldToCorner, q is measured from size (1, 1, 1), where no corner is here.
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
