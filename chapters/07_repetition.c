// Chapter 07: repetition. There is only one lantern; folding x and z into its cell turns the
// lantern into an endless field.
//
// The page is docs/07_repetition.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "07_repetition",
        .title = "07 Repetition",
        .shows = "An endless field of lanterns, no two alike, in the mist at dusk.",
        .camera = {.position = {1.45f, 3.9f, 5.1f}, .pan = 13.5f, .tilt = -13.5f},
    };
    return chapter_run(&chapter, argc, argv);
}
