// Experiment of chapter 09: each cell knows its own tower alone, with nothing said of the neighbours.
// Over a low block a ray takes steps as long as the way to the low roof, and flies through the high
// tower beside it.
//
// The chapter's own sceneDistance is kept aside under another name; everything else is the chapter's.
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
