// normal.glsl - the direction in which the distance grows fastest.
#include "scene.glsl"

// The unit normal of the surface at p: the gradient of the scene's distance by central differences,
// made of length 1.
//   p        near the surface, scene units
//   h        step of the differences, scene units, > 0
//   formula  normalize(f(p + h e_i) - f(p - h e_i)), i = x, y, z; error O(h^2) from the formula,
//            O(1 / h) from rounding
//   returns  length 1; (0, 0, 0) where the differences cancel, as in a sheet without thickness
// A loop around one call of the scene, not six calls: it compiles faster.
// Source: report, section 1.5.1.
vec3 normalAt(vec3 p, float h)
{
    vec3 gradient = vec3(0.0);
    for (int i = 0; i < 6; i++) {
        float side = i < 3 ? 1.0 : -1.0;
        vec3 axis = vec3(i == 0 || i == 3, i == 1 || i == 4, i == 2 || i == 5);
        gradient += side * axis * distanceAt(p + side * h * axis);
    }
    float size = length(gradient);
    vec3 normal = size > 0.0 ? gradient / size : vec3(0.0);
    traceNormal(normal);
    return normal;
}
