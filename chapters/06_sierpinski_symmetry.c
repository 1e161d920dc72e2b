// Chapter 06: symmetry. Folds in planes, and the pyramid that they make.
//
// The page is docs/06_sierpinski_symmetry.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "06_sierpinski_symmetry",
        .title = "06 Symmetry",
        .shows = "A Sierpinski pyramid, made with folds, in the evening light.",
        .camera = {.position = {-1.5f, 0.9f, 3.5f}, .pan = 22.0f, .tilt = 2.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
