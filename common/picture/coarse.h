// coarse.h - the coarse pass: before a picture, one march for each block of 8 x 8 of its pixels,
// which says up to where their rays meet nothing.
//
// shaders/coarse.glsl says what is computed, and proves it.
#ifndef COARSE_H
#define COARSE_H

#include "picture/pass.h"

#define COARSE_BLOCK 8 // side of a block in pixels, as in shaders/coarse.glsl

// Does a linked view read the pass, and is the parameter coarsePass on? A shader without that
// parameter has it on.
bool coarse_wanted(const struct renderer *renderer, enum shader_view view);

// Where the view wants it, run the pass for the blocks that hold a rectangle of the picture's
// pixels; what the other blocks hold is not said. The table is renderer->coarse, one texel a block
// of the whole picture: the start, the evaluations that it took, the pixels of the block, -.
//   view      the linked view that is drawn next
//   low, high opposite corners of the rectangle, pixels, the upper one not included
// Returns false, reported.
bool coarse_run(struct renderer *renderer, const struct renderer_inputs *inputs,
                enum shader_view view, const int low[2], const int high[2]);

// Give the table to the program of the view, which is in use. Call it after pass_use.
void coarse_bind(const struct renderer *renderer, enum shader_view view);

#endif
