// Chapter 02: lighting. Lambert's law, several lamps, colour as a product, and sRGB encoding.
//
// The page is docs/02_lighting.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "02_lighting",
        .title = "02 Lighting",
        .shows = "A frame on a stage under a warm, circling lamp and a cold, fixed one.",
        .camera = {.position = {2.5f, 2.85f, 5.15f}, .pan = -29.0f, .tilt = -24.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
