// Chapter 20: clouds and weather. A lighthouse under clouds that follow the hour and the weather.
//
// The page is docs/20_clouds_and_weather.md.
#include "../common/chapter.h"

int main(int argc, char **argv)
{
    const struct chapter chapter = {
        .stem = "20_clouds_and_weather",
        .title = "20 Clouds and weather",
        .shows = "A lighthouse under clouds that drift, from fair weather to storm, at every hour.",
        .camera = {.position = {0.0f, 1.3f, 0.0f}, .pan = -90.0f, .tilt = 0.0f},
    };
    return chapter_run(&chapter, argc, argv);
}
