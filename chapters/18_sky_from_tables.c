// Chapter 18: a sky from tables. A pine on an islet under a sky computed in advance.
//
// The page is docs/18_sky_from_tables.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "18_sky_from_tables",
        .title = "18 A sky from tables",
        .shows = "A pine on an islet in a calm sea, under a sky read from computed tables.",
        .camera = {.position = {0.0f, 1.7f, 0.0f}, .pan = 14.0f, .tilt = 10.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
