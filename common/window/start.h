// start.h - what a window is opened with.
#ifndef WINDOW_START_H
#define WINDOW_START_H

#include <stdbool.h>

#include "camera.h"
#include "shader/source.h"

// How a window begins, and what R returns to.
struct window_start {
    const char *title;  // of the chapter, for the title bar
    const char *stem;   // of the chapter: screenshots are STEM-0001.png, ... in the current folder
    const char *shader; // path of the shader's file: loaded again when it or an include changes
    const char *second; // path of the file beside it, which is loaded again too; NULL or "": none
    const struct shader_request *request; // what its readings are asked besides
    struct camera camera;                 // where the eye starts
    double time;                          // seconds
    int samples;                          // along each side of a pixel
    double overlay_scale;                 // 0: as the picture's height asks
    bool overlay_kept;                    // screenshots have the overlay too
};

#endif
