// Chapter 08: the orthographic view, with parallel rays, and the transition to it from perspective.
//
// The page is docs/08_orthographic_view.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "08_orthographic_view",
        .title = "08 Orthographic view",
        .shows = "A level channel feeds its own waterfall until you switch to perspective (Tab).",
        .camera = {.position = {-3.55f, 6.05f, 5.05f}, .pan = 45.0f, .tilt = -35.26439f},
    };
    return chapter_run(&chapter, argc, argv);
}
