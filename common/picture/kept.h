// kept.h - the pictures that one pass keeps from frame to frame: floats of 32 bits, if the driver
// can draw into them, or bytes, in a pair of targets. Each frame is drawn into the target that the
// last frame has not used, while it reads the last frame from the other one.
#ifndef KEPT_H
#define KEPT_H

#include <stdbool.h>

#include "picture/target.h"

// A zero-initialised struct keeps nothing yet.
struct kept {
    struct target target[2]; // frame k is in target[k % 2]
    int frames;              // number of frames that have been drawn
    char *key;               // what these frames depend on, apart from their time; owned
};

// The target that contains a frame, the last or the one before. The frame -1 is 0 everywhere.
struct target *kept_frame(struct kept *kept, int frame);

// Begin again with frame 0 if the key has changed, or if a frame is asked for that was followed by
// others.
//   key    taken over
//   frame  the frame that is needed
void kept_follow(struct kept *kept, char *key, int frame);

// Set both targets to 0, before frame 0. Later, no target is cleared: while a frame is drawn, its
// target still contains the frame before the last. A shader may discard its pixel, and in Shadertoy
// the pixel then has this value.
//   bytes  keep bytes instead of floats
// Returns false without reporting an error if the driver cannot create the targets.
bool kept_begin(struct kept *kept, const struct gl *gl, bool bytes, int width, int height);

// Free the pictures.
void kept_free(struct kept *kept, const struct gl *gl);

#endif
