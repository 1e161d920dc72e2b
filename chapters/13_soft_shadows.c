// Chapter 13: soft shadows. The lamp is a disc, and only a share of it is visible from a point in
// the penumbra.
//
// The page is docs/13_soft_shadows.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "13_soft_shadows",
        .title = "13 Soft shadows",
        .shows = "A terrace by the sea, late in the afternoon, with shadows that are sharpest at "
                 "their foot.",
        .camera = {.position = {0.95f, 1.35f, 5.1f}, .pan = -3.0f, .tilt = -6.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
