// room.h - keeps the camera out of the ground and the water.
#ifndef ROOM_H
#define ROOM_H

#include "picture/renderer_pass.h"

// Keep a camera where the shader's cameraRoom leaves room for it, as described in
// shaders/room.glsl. If the shader has no such function, the camera can go anywhere. The first call
// has the driver start compiling a program; the camera can go anywhere until the program is
// compiled, and from then on each call waits for the GPU.
//   inputs  the inputs of the picture that is shown, with the camera before the move
//   to      the camera's destination, scene units; receives the point where the camera stops
// If the program does not link or the driver cannot create a target for it, reports the error and
// returns false; the destination is then unchanged.
bool room_keep(struct renderer *renderer, const struct renderer_inputs *inputs, float to[3]);

#endif
