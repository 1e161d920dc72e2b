// Chapter 15: the picture. Fog, lens, exposure, film: the courtyard of chapter 14 as a photograph.
//
// The page is docs/15_the_picture.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "15_the_picture",
        .title = "15 The picture",
        .shows = "A courtyard early in the morning: low sun through the arcade into thin mist.",
        .camera = {.position = {-4.2f, 1.5f, -5.9f}, .pan = 145.0f, .tilt = 3.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
