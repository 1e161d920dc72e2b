// normal.glsl - the direction in which the distance grows fastest.
#include "scene.glsl"

// The unit normal of the surface at p: the normalised gradient of the scene's distance, from central
// differences.
//   p        near the surface, scene units
//   h        step of the differences, scene units, > 0
//   formula  normalize(f(p + h e_i) - f(p - h e_i)), i = x, y, z; the truncation error is O(h^2), the
//            rounding error O(1 / h)
//   returns  length 1; (0, 0, 0) where the differences cancel, as in a sheet without thickness
// A loop around one call of the scene compiles faster than six calls.
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
