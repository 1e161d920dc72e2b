// start.h - the state in which a window opens.
#ifndef WINDOW_START_H
#define WINDOW_START_H

#include <stdbool.h>

#include "picture/loader.h"

// The contents of a course: its scenes, each of which is a chapter.
struct contents {
    const struct contents_item {
        const char *name, *shows; // its title, and a sentence about what its picture shows
        char *picture;            // path of a PNG, which may be missing
    } * item;
    int count;
};

// The state in which a window opens. R returns to its time, and Shift+R to its camera too.
struct window_start {
    const char *title;       // for the title bar and the panel
    const char *stem;        // screenshots are STEM-0001.png, ... in the current folder
    struct loader *picture;  // compiled pictures, reloaded when their files change; not owned
    int pictures;            // 1, or 2 with a comparison
    struct camera camera;    // the initial camera
    double time;             // the initial time, in seconds
    int frame;               // the frame at which a shader that keeps frames stops; -1 for none
    double rate;             // frames per second of such a shader; 0 for PASSES_RATE
    bool paused;             // the time is stopped until Escape is pressed
    int samples;             // samples along each side of a pixel
    bool smooths;            // a picture at rest is drawn again with smooth edges
    struct strokes *strokes; // strokes from the command line; the pointer adds more; not owned
    double overlay_scale;    // 0 to derive the scale from the picture's height and pixel density
    bool overlay_kept;       // screenshots show the overlay too
    int shown; // number of steps of the middle ray to show, which selects the ray; 0 for no ray
    const char *selected; // "NAME=VALUE", the parameter that is selected; NULL for the first one
    const char *caption;  // caption of a lecture's scene for the speaker; NULL outside a lecture
    const struct contents *contents; // of the course that has this scene; NULL outside a course
    int scene;                       // its index there
};

#endif
