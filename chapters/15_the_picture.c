// Chapter 15: the picture. The courtyard of chapter 14 as a photograph: fog, lens, exposure and
// film.
//
// The page is docs/15_the_picture.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "15_the_picture",
        .title = "15 The picture",
        .shows = "A courtyard early in the morning: a low sun shines through the arcade into mist.",
        .camera = {.position = {-4.2f, 1.5f, -5.9f}, .pan = 145.0f, .tilt = 3.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
