// Solution to exercise 09.3: the other method of chapter 07. It evaluates the towers of the cell
// and of its nearer neighbours, four in all, and caps the result at GAP plus the distance to the
// outer border of these four cells.
#include "main.glsl"
#define sceneDistance oneCellDistance
#include "09_sky_and_sunset.frag"
#undef sceneDistance

float sceneDistance(vec3 p)
{
    vec3 local = blockAt(p).local;
    vec2 side = vec2(local.x < 0.0 ? -PERIOD : PERIOD, local.z < 0.0 ? -PERIOD : PERIOD);
    float wall = min(cellWall(p.x, PERIOD), cellWall(p.z, PERIOD));
    float distance = wall + GAP;
    for (int i = 0; i < 4; i++) {
        vec3 shift = vec3(i % 2 == 0 ? 0.0 : side.x, 0.0, i < 2 ? 0.0 : side.y);
        Block block = blockAt(p + shift);
        block.local -= shift;
        vec3 shaft = outsideShaft(block), base = outsideBase(block);
        distance = min(distance, min(max(shaft.x, max(shaft.y, shaft.z)), max(base.x, max(base.y, base.z))));
    }
    vec3 q = pavement(local);
    return min(distance, min(lampDistance(q), treeDistance(q)));
}
