// Experiment of chapter 09: only the tower in the point's own cell is evaluated, and no step is
// capped by the distance to the neighbouring cells. Over a low tower, a ray takes steps as long as
// the distance to the tower's roof, and passes through a high tower in the next cell.
//
// The chapter's sceneDistance is renamed; everything else is as in the chapter.
#include "main.glsl"
#define sceneDistance chapterSceneDistance
#include "09_sky_and_sunset.frag"
#undef sceneDistance

float sceneDistance(vec3 p)
{
    Block block = blockAt(p);
    vec3 q = pavement(block.local), shaft = outsideShaft(block), base = outsideBase(block);
    float tower = min(max(shaft.x, max(shaft.y, shaft.z)), max(base.x, max(base.y, base.z)));
    return min(tower, min(lampDistance(q), treeDistance(q)));
}
