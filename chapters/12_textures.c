// Chapter 12: textures. Stones, a plank and a cloth, none of which has texture coordinates.
//
// The page is docs/12_textures.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "12_textures",
        .title = "12 Textures",
        .shows = "A bench of stones and a plank, with a cloth over it, on a cold morning.",
        .camera = {.position = {-1.2f, 1.54f, 2.75f}, .pan = 19.0f, .tilt = -16.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
