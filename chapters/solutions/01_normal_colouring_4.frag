// Solution to exercise 01.4: the normal from four evaluations at the corners of a tetrahedron.
//
// The chapter's rayColour is renamed and not used; everything else is as in the chapter.
#include "main.glsl"
#define rayColour chapterColour
#include "01_normal_colouring.frag"
#undef rayColour

// The normalised gradient from four corners of a cube.
//   p, h     as for normalAt
//   formula  normalize(sum of k f(p + h k)), k = (1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1);
//            the sum is 4 h times the gradient with an error of h (H_yz, H_xz, H_xy) + O(h^2), where
//            H contains the second derivatives
vec3 tetrahedronNormal(vec3 p, float h)
{
    vec3 gradient = vec3(0.0);
    for (int i = 0; i < 4; i++) {
        vec3 corner = vec3(i < 2 ? 1.0 : -1.0, i % 2 == 0 ? 1.0 : -1.0, i == 0 || i == 3 ? 1.0 : -1.0);
        gradient += corner * distanceAt(p + h * corner);
    }
    vec3 normal = normalize(gradient);
    traceNormal(normal);
    return normal;
}

vec3 rayColour(Ray ray)
{
    Hit hit = march(ray, 0.0, FAR, hitThreshold, maxSteps);
    if (!hit.found)
        return SKY;
    vec3 normal = tetrahedronNormal(ray.origin + hit.t * ray.direction, normalStep);
    return biased ? 0.5 * normal + 0.5 : normal;
}
