// Chapter 03: shadows, found with a second march, from the surface to the lamp.
//
// The page is docs/03_shadows.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "03_shadows",
        .title = "03 Shadows",
        .shows = "The stage of chapter 02, with the shadows that the circling lamp casts.",
        .camera = {.position = {2.5f, 2.85f, 5.15f}, .pan = -29.0f, .tilt = -24.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
