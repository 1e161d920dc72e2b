// Solution to exercise 07.3: towers with heights from 0.5 to 12, which almost fill their cells.
// Four towers are evaluated, and no step goes beyond the border of the block that their cells form.
//
// A macro renames the experiment's sceneDistance, which is not used.
#include "main.glsl"
#define sceneDistance latticeDistance
#include "experiments/07_lattice.frag"
#undef sceneDistance

uniform bool walled; // true: no step is longer than the distance to the block's wall

const float CELL = 2.0;

// The distance to the tower of a cell, which stands on y = -6 and is 1.6 wide.
float towerDistance(vec3 p, vec2 cell)
{
    float tall = 0.25 + 5.75 * cellRandom(ivec3(cell.x, 0, cell.y));
    vec3 q = vec3(p.x - CELL * cell.x, p.y + 6.0 - tall, p.z - CELL * cell.y);
    return sdBox(q, vec3(0.8, tall, 0.8));
}

float sceneDistance(vec3 p)
{
    vec2 own = vec2(cellOf(p.x, CELL), cellOf(p.z, CELL));
    vec2 next = vec2(cellNeighbour(p.x, CELL), cellNeighbour(p.z, CELL));
    float nearest = walled ? min(cellWall(p.x, CELL), cellWall(p.z, CELL)) : 1000.0;
    for (int i = 0; i < 4; i++)
        nearest = min(nearest, towerDistance(p, vec2(i % 2 == 0 ? own.x : next.x, i / 2 == 0 ? own.y : next.y)));
    return nearest;
}
