// Chapter 17: glass. Rays that go into solids, through them and out again.
//
// The page is docs/17_glass.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "17_glass",
        .title = "17 Glass",
        .shows =
            "A tumbler, a prism and a ball, which bend, mirror and gather the light of a lamp.",
        .camera = {.position = {0.0f, 2.1f, 3.15f}, .pan = 0.0f, .tilt = -26.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
