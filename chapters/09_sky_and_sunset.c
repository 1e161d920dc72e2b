// Chapter 09: sky and sunset. A city by day and by night, under a sky made of air and sunlight.
//
// The page is docs/09_sky_and_sunset.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "09_sky_and_sunset",
        .title = "09 Sky and sunset",
        .shows = "A city whose sky, light and windows follow the time of day.",
        .camera = {.position = {3.3f, 0.7f, 1.2f}, .pan = -4.0f, .tilt = 8.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
