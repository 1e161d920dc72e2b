// Chapter 21: a landscape. A lake between mountains, at every hour and in all weathers.
//
// The page is docs/21_a_landscape.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "21_a_landscape",
        .title = "21 A landscape",
        .shows = "A lake between mountains, at every hour and in all weathers.",
        .camera = {.position = {0.0f, 0.14f, 0.0f}, .pan = -65.0f, .tilt = 4.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
