// Chapter 16: fewer steps. Where the steps of a march go, and six methods to save them.
//
// The page is docs/16_fewer_steps.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "16_fewer_steps",
        .title = "16 Fewer steps",
        .shows = "A pier in a lagoon as the march sees it: its steps, before and after.",
        .camera = {.position = {0.0f, 1.45f, 7.6f}, .pan = 0.0f, .tilt = -2.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
