// Solution to exercise 10.6: the wall's function is divided by its largest slope, for any twist and
// taper.
#include "main.glsl"
#define sceneDistance experimentDistance
#include "experiments/10_twisted.frag"
#undef sceneDistance

// The length of (1, |g| sqrt(taper^2 + twist^2)), where g, the nearest point of the figure, is at
// most REACH from its centre.
float steepest()
{
    return sqrt(1.0 + REACH * REACH * (taper * taper + twist * twist));
}

float sceneDistance(vec3 p)
{
    float column = opIntersection(wallFunction(p) / steepest(), p.y - HEIGHT);
    return opUnion(column, p.y);
}
