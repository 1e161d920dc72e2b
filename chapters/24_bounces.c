// Chapter 24: light that bounces. A room with one window, in which most of the light has met a wall
// before.
//
// The page is docs/24_bounces.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "24_bounces",
        .title = "24 Light that bounces",
        .shows = "A room with one window, in which most of the light has bounced.",
        .camera = {.position = {0.74f, 1.26f, 0.52f}, .pan = -1.0f, .tilt = -11.5f},
    };
    return chapter_run(&chapter, argc, argv);
}
