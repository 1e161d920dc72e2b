// Solution to exercise 07.2: twelve framed balls around the origin. The angle is repeated: rotating
// by a multiple of a twelfth of a turn brings every point into the sector around the x axis. On the
// y axis, where GLSL leaves atan(0, 0) undefined, the angle is 0.
//
// A macro renames the experiment's sceneDistance, which is not used.
#include "main.glsl"
#define sceneDistance latticeDistance
#include "experiments/07_lattice.frag"
#undef sceneDistance

const float SECTOR = 6.283185307 / 12.0;

float sceneDistance(vec3 p)
{
    float angle = opRepeat(atan(p.z, p.x + float(p.xz == vec2(0.0))), SECTOR);
    vec3 q = length(p.xz) * vec3(cos(angle), 0.0, sin(angle)) - vec3(4.5, 0.0, 0.0);
    q.y = p.y;
    return min(sdSphere(q, 0.45), sdBoxFrame(q, vec3(0.8), 0.07));
}
