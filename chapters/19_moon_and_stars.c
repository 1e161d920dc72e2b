// Chapter 19: moon and stars. A lake under a young moon, and a night sky that turns about its pole.
//
// The page is docs/19_moon_and_stars.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "19_moon_and_stars",
        .title = "19 Moon and stars",
        .shows = "A lake at dusk, a young moon over an observatory, and stars that come out.",
        .camera = {.position = {0.0f, 1.7f, 0.0f}, .pan = 6.0f, .tilt = 1.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
