// Chapter 10: distance in the plane. The workbench: a figure, its field, and one ray.
//
// The page is docs/10_distance_in_the_plane.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "10_distance_in_the_plane",
        .title = "10 Distance in the plane",
        .shows = "A leaf in the plane, its field in lines, and one ray with its circles.",
        .camera = {.position = {0.0f, 0.0f, 2.4f}, .pan = 0.0f, .tilt = 0.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
