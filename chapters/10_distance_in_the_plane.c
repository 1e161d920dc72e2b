// Chapter 10: distance in the plane. A figure, the lines of equal distance around it, and one ray.
//
// The page is docs/10_distance_in_the_plane.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "10_distance_in_the_plane",
        .title = "10 Distance in the plane",
        .shows = "A leaf in the plane, lines of equal distance, and one ray with its circles.",
        .camera = {.position = {0.0f, 0.0f, 2.4f}, .pan = 0.0f, .tilt = 0.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
