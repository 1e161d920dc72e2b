// Solution to exercise 11.4: whole balls, five along each side. The repetition is limited, and
// nothing is cut.
//
// The experiment's sceneDistance is renamed.
#include "main.glsl"
#define sceneDistance cutDistance
#include "experiments/11_lattice.frag"
#undef sceneDistance

float sceneDistance(vec3 p)
{
    vec3 q = vec3(opRepeatLimited(p.x, 1.0, -2.0, 2.0), opRepeatLimited(p.y, 1.0, -2.0, 2.0),
                  opRepeatLimited(p.z, 1.0, -2.0, 2.0));
    return sdSphere(q, radius);
}
