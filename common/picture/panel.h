// panel.h - what the overlay says: chapter, rate, view, parameters, keys, one ray's march, an
// error.
#ifndef PANEL_H
#define PANEL_H

#include <stdbool.h>

#include "picture/overlay.h"
#include "picture/renderer.h"

// A key's label and what it does.
struct panel_key {
    char label[64];
    const char *does;
};

// NULL, 0 and "" leave a part out.
struct panel {
    const char *title;               // of the chapter
    const struct renderer *renderer; // its view and parameters
    const struct parameter *chosen;  // what the arrows change
    double rate, milliseconds;       // frames a second, of one frame
    bool timed;                      // the picture depends on the time
    double time;                     // seconds
    int resolution; // percent of each side at which the picture is drawn; 0 and 100: full
    int sharp;      // percent of it that is sharp all the same
    bool paused;
    bool ranges;      // range and unit of all parameters, where the picture has room for them
    bool folded;      // leave out all but the ray's march, in the slice that too, and the error
    const char *hint; // what to press; NULL or "": none
    const struct panel_key *keys;
    int key_count;
    int pixel[2];              // whose march is shown, 0,0 bottom left; -1,-1: none
    float shown;               // how many of its steps, as renderer_inputs.shown
    const struct probe *probe; // its march, or NULL: then why says why there is none
    const char *why;
    const char *error; // its lines ended by '\n'; NULL or "": none
    bool broken;       // the error is that of a reload; else it says why a view is refused
};

// Gather the panel into the overlay's new frame.
//   width, height  of the whole picture, pixels
//   scale          as overlay_begin
void panel_gather(const struct panel *panel, struct overlay *overlay, int width, int height,
                  float scale);

#endif
