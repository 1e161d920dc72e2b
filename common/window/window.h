// window.h - the interactive loop: keys, mouse, reload, the title bar.
#ifndef WINDOW_H
#define WINDOW_H

#include <stdbool.h>

#include "camera.h"
#include "context/context.h"
#include "picture/renderer.h"

// How a window begins, and what Home and R return to.
struct window_start {
    const char *title;  // of the chapter, for the title bar
    const char *stem;   // of the chapter: screenshots are STEM-0001.png, ... in the current folder
    const char *shader; // path of the shader's file: loaded again when it or an include changes
    struct camera camera; // where the eye starts
    double time;          // seconds
    int samples;          // along each side of a pixel
    double overlay_scale; // 0: as the picture's height asks
    bool overlay_kept;    // screenshots have the overlay too
};

// Run until the window is closed.
//   context   with a visible window
//   renderer  with the shader loaded and the view set
//   start     must outlive the call
// Returns false, reported, when drawing failed.
bool window_run(struct context *context, struct renderer *renderer,
                const struct window_start *start);

#endif
