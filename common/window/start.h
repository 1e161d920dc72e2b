// start.h - what a window is opened with.
#ifndef WINDOW_START_H
#define WINDOW_START_H

#include <stdbool.h>

#include "picture/loader.h"

// The state in which a window opens, and to which R returns.
struct window_start {
    const char *title;       // of the chapter, for the title bar
    const char *stem;        // screenshots are STEM-0001.png, ... in the current folder
    struct loader *picture;  // compiled; each is reloaded when its files change. Not owned
    int pictures;            // 1, or 2 with a comparison
    struct camera camera;    // where the eye starts
    double time;             // seconds
    bool paused;             // the time stands still until Escape is pressed
    int samples;             // along each side of a pixel
    struct strokes *strokes; // of the command line; the pointer adds more. Not owned
    double overlay_scale;    // 0 if the picture's height decides
    bool overlay_kept;       // screenshots show the overlay too
    int shown; // steps of the middle ray, which is then selected; 0 if no ray is selected
    const char *selected; // "NAME=VALUE", the parameter that is selected; NULL for the first one
    const char *caption;  // of a lecture's scene, for the speaker; NULL if there is no lecture
};

#endif
