// Chapter @number@: @small@. One sentence on what it shows.
//
// The page is docs/@stem@.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "@stem@",
        .title = "@number@ @title@",
        .shows = "A ball on the ground.",
        .camera = {.position = {0.0f, 1.4f, 5.0f}, .pan = 0.0f, .tilt = -12.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
