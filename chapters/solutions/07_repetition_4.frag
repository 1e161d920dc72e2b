// Solution to exercise 07.4: a spiral staircase. The treads of a sector are 4.2 apart in height; those
// of three sectors are evaluated, and no step goes beyond the planes that bound the three.
//
// A macro renames the experiment's sceneDistance, which is not used.
#include "main.glsl"
#define sceneDistance latticeDistance
#include "experiments/07_lattice.frag"
#undef sceneDistance

uniform bool walled; // true: no step is longer than the distance to the planes

const float SECTOR = 6.283185307 / 12.0;
const float RISE = 0.35;

// The distance to the nearest of the treads number, number + 12, number - 12 and so on.
float treadDistance(vec3 p, float number)
{
    float c = cos(SECTOR * number), s = sin(SECTOR * number);
    vec3 q = vec3(c * p.x + s * p.z, opRepeat(p.y - RISE * number, 12.0 * RISE), c * p.z - s * p.x);
    return sdBox(q - vec3(2.5, 0.0, 0.0), vec3(1.5, 0.06, 0.25));
}

float sceneDistance(vec3 p)
{
    float radius = length(p.xz), angle = atan(p.z, p.x + float(radius == 0.0));
    float own = cellOf(angle, SECTOR);
    float nearest = radius - 1.0;
    for (int i = -1; i <= 1; i++)
        nearest = min(nearest, treadDistance(p, own + float(i)));
    float wall = radius * sin(1.5 * SECTOR - abs(angle - SECTOR * own));
    return walled ? min(nearest, wall) : nearest;
}
