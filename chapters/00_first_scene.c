// Chapter 00: a first scene. A lamp in the frame of a box.
//
// The complete ray marcher is in one file, 00_first_scene.frag. The camera of this shader moves
// around the scene, so the keys that move the eye have no effect here. The page is
// docs/00_first_scene.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "00_first_scene",
        .title = "00 First scene",
        .shows = "A lamp in the frame of a box: a complete ray marcher in one file.",
        .camera = {.position = {0.0f, 0.0f, 0.0f}},
    };
    return chapter_run(&chapter, argc, argv);
}
