// Experiment of chapter 22: the flat loop, which evaluates every part at every step.
//
// Each iteration evaluates eight parts, because llvmpipe ends the loops of a pixel after 65,535 iterations in all.
#include "main.glsl"
#define sceneDistance chapterDistance
#include "22_many_parts.frag"
#undef sceneDistance

void takePart(int id, vec3 p)
{
    vec4 part = partAt(id, p);
    listValue = blended(listValue, length(part.xyz) - part.w);
}

float sceneDistance(vec3 p)
{
    listValue = 1e9;
    for (int i = 0; i < grid.count; i += 8) {
        takePart(i, p);
        takePart(i + 1, p);
        takePart(i + 2, p);
        takePart(i + 3, p);
        takePart(i + 4, p);
        takePart(i + 5, p);
        takePart(i + 6, p);
        takePart(i + 7, p);
    }
    here = Cell(vec3(-1e4), 2e4, 0, 1, 0.0); // one cell around everything
    return listValue;
}
