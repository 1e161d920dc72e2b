// Chapter 22: many parts. A reef of thousands of parts that blend where they meet.
//
// The page is docs/22_many_parts.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "22_many_parts",
        .title = "22 Many parts",
        .shows = "A reef of thousands of parts that blend where they meet.",
        .camera = {.position = {0.0f, 0.75f, 5.3f}, .pan = 0.0f, .tilt = 6.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
