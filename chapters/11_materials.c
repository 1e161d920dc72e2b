// Chapter 11: materials. The material of a hit is found once, where the march has ended.
//
// The page is docs/11_materials.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "11_materials",
        .title = "11 Materials",
        .shows =
            "A still life by a window: clay, glaze, silver, fruit, ivory and a chequered cloth.",
        .camera = {.position = {0.3f, 1.65f, 4.15f}, .pan = 0.0f, .tilt = -11.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
