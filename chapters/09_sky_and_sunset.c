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
        .camera = {.position = {2.95f, 1.05f, 0.3f}, .pan = -5.0f, .tilt = 4.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
