// Experiment of chapter 10: one figure, repeated along x with the workshop's formula or with that
// of chapter 07.
#include "main.glsl"
#define sceneDistance chapterDistance
#include "10_distance_in_the_plane.frag"
#undef sceneDistance
#include "repetition.glsl" // opRepeat

uniform bool  workshop; // true: mod(x, N) - N / 2; false: opRepeat
uniform float period;   // 2.2 in [1, 4] step 0.1, units: N, the distance between copies

float sceneDistance(vec3 p)
{
    p.x = workshop ? mod(p.x, period) - 0.5 * period : opRepeat(p.x, period);
    return chapterDistance(p);
}
