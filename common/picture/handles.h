// handles.h - parameters that are points in the picture: where they are, and how they follow the
// pointer.
#ifndef HANDLES_H
#define HANDLES_H

#include "picture/renderer_pass.h"

enum { HANDLES_MOST = 8 }; // per shader; further handles cannot be dragged

// A handle in a picture. Pixels are counted from the bottom left of the whole picture.
struct handle {
    struct parameter *parameter; // not owned
    float pixel[2];              // position of the handle
    float move[2][2]; // pixels that the handle moves per scene unit along either axis of its plane
    float axis[2][3]; // unit vectors along these axes, in the scene's coordinates
    bool seen;        // a ray passes through the handle; otherwise pixel and move are undefined
};

// Find the positions of a shader's handles in a picture, whatever pixelRay the shader defines.
//   formula  shaders/positions.glsl finds the pixels of the points p, p + e a and p + e b, where a
//            and b are the axes, and e is a hundredth of the distance to the camera, but at least
//            0.001; move is the difference divided by e, which is the derivative up to terms of
//            order e. A shader that has its own main and no pixelRay has no points in space: there
//            a vec2 is a place on the screen, in halves of its height from the middle, and a vec3
//            is not seen
// Returns the number of handles, or -1 after reporting the error.
int handles_find(struct renderer *renderer, const struct renderer_inputs *inputs,
                 struct handle handle[HANDLES_MOST]);

// Move a handle in its plane to a pixel, or as close as its range allows, and find all handles
// again.
//   handle   the handles, as handles_find left them
//   moved    the index of the handle to move
//   to       the pixel, from the bottom left
//   formula  Newton's method, with steps of at most an eighth of the picture's height, so that in
//            perspective the handle does not jump behind the camera. A step that loses the handle
//            is undone, and later steps are at most a quarter as long. Values are rounded to a
//            thousandth of a unit
// Returns true if the handle's value changed.
bool handles_drag(struct renderer *renderer, const struct renderer_inputs *inputs,
                  struct handle handle[HANDLES_MOST], int moved, const double to[2]);

#endif
