// passes.h - the frames of a shader that reads what it has kept of the last one.
//
// Before each picture, a pass draws what the frame keeps, and the picture shows it. What frame n
// keeps depends on all frames before it. So that a picture nevertheless depends only on its inputs,
// frame n is always what drawing frames 0 to n one after the other at a fixed rate gives, whatever
// was shown before: a key of everything that the pass reads decides whether the kept frames
// continue, or begin again with frame 0.
#ifndef PASSES_H
#define PASSES_H

#include "picture/renderer_pass.h"

#define PASSES_RATE 60.0 // frames per second, if none is given

// True if the renderer's shader, or that of the other side of a comparison, reads what the last
// frame has kept.
bool passes_keep(const struct renderer *renderer);

// True if the frames are kept in half floats, because the driver cannot draw into floats.
bool passes_halves(const struct renderer *renderer);

// Return the inputs of another frame of the same film. In a file, whose year is 1970, the seconds
// of the date are the time.
struct renderer_inputs passes_inputs(const struct renderer_inputs *inputs, int frame);

// The number of frames of these inputs' film that are drawn, at most that of the inputs included,
// in both pictures of a comparison. 0 if they begin again with frame 0.
int passes_drawn(const struct renderer *renderer, const struct renderer_inputs *inputs);

// Draw what the frames keep, up to that of the inputs, in both pictures of a comparison. Does
// nothing if a shader keeps nothing, or if everything is drawn. What a frame keeps has one sample
// for each pixel, because the mean of several states is no state.
// Returns false after reporting the error.
bool passes_follow(struct renderer *renderer, const struct renderer_inputs *inputs);

#endif
