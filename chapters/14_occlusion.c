// Chapter 14: occlusion. The lamp is the whole sky, and only a share of it is visible from a point.
//
// The page is docs/14_occlusion.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "14_occlusion",
        .title = "14 Occlusion",
        .shows = "An overcast courtyard, with no sun and yet with dark corners.",
        .camera = {.position = {0.75f, 1.45f, 5.9f}, .pan = 3.5f, .tilt = 0.5f},
    };
    return chapter_run(&chapter, argc, argv);
}
