// Chapter 05: transformations. Things are turned and twisted by asking about another point.
//
// The page is docs/05_transforms.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "05_transforms",
        .title = "05 Transformations",
        .shows = "A sea at sunrise, on which a twisted ring, a ball and a crate float.",
        .camera = {.position = {0.0f, 1.5f, 5.2f}, .pan = 0.0f, .tilt = -9.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
