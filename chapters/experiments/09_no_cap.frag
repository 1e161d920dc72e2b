// Experiment of chapter 09: only the tower of the cell is evaluated, without a cap for the
// neighbours. Over a low tower, a ray takes steps as long as the distance to its roof, and passes
// through the high tower beside it.
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
