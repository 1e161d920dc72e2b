// Chapter 04: colours by hue, and volumes made of volumes. A wheel of hues around a smooth union.
//
// The page is docs/04_hue_colour.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "04_hue_colour",
        .title = "04 Hue and combination",
        .shows = "A wheel of twelve hues, and in its middle a ball that rises out of a block.",
        .camera = {.position = {1.15f, 4.45f, 4.3f}, .pan = -15.0f, .tilt = -49.8f},
    };
    return chapter_run(&chapter, argc, argv);
}
