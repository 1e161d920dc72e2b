// Chapter 06: symmetry. Folds along planes, and the pyramid that they make.
//
// The page is docs/06_sierpinski_symmetry.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "06_sierpinski_symmetry",
        .title = "06 Symmetry",
        .shows = "Sierpinski's pyramid from folds, in the evening light.",
        .camera = {.position = {-0.3f, 0.8f, 3.4f}, .pan = -2.0f, .tilt = 4.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
