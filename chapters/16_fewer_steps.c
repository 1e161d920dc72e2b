// Chapter 16: fewer steps. What the steps of a march are spent on, and five methods to save steps.
//
// The page is docs/16_fewer_steps.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "16_fewer_steps",
        .title = "16 Fewer steps",
        .shows = "A pier in a lagoon, coloured by the number of steps that two methods take.",
        .camera = {.position = {0.0f, 1.45f, 7.6f}, .pan = 0.0f, .tilt = -2.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
