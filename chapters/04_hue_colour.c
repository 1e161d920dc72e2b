// Chapter 04: colours from hues, and solids built from other solids. A wheel of hues surrounds a
// smooth union.
//
// The page is docs/04_hue_colour.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "04_hue_colour",
        .title = "04 Hue and combination",
        .shows = "A wheel of twelve hues around a ball that rises out of a block.",
        .camera = {.position = {1.15f, 4.45f, 4.3f}, .pan = -15.0f, .tilt = -49.8f},
    };
    return chapter_run(&chapter, argc, argv);
}
