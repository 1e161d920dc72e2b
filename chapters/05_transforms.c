// Chapter 05: transformations. Objects are moved, turned and twisted by evaluating their distances
// at another point.
//
// The page is docs/05_transforms.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "05_transforms",
        .title = "05 Transformations",
        .shows = "A twisted ring, a ball and a crate, afloat on the sea at sunrise.",
        .camera = {.position = {0.0f, 1.5f, 5.2f}, .pan = 0.0f, .tilt = -9.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
