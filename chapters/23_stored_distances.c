// Chapter 23: stored distances. A clay elephant whose distance is kept in a grid.
//
// The page is docs/23_stored_distances.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "23_stored_distances",
        .title = "23 Stored distances",
        .shows = "A clay elephant on a turntable: its distance is kept in a grid.",
        .camera = {.position = {0.0f, 0.38f, 2.4f}, .pan = 0.0f, .tilt = -12.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
