// Chapter 01: normal colouring. The distance field, the march, the normal and the camera.
//
// The colour of a point shows the direction in which its surface faces. The page is
// docs/01_normal_colouring.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "01_normal_colouring",
        .title = "01 Normal colouring",
        .shows = "A frame, a ball and an orbit of balls, coloured by the direction they face.",
        .camera = {.position = {1.65f, 1.6f, 3.4f}, .pan = -26.0f, .tilt = -23.5f},
    };
    return chapter_run(&chapter, argc, argv);
}
