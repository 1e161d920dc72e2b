// room.h - the camera stops at the ground and at the water.
#ifndef ROOM_H
#define ROOM_H

#include "picture/renderer.h"

// Keep a camera where the shader's cameraRoom has room for it, as described in shaders/room.glsl.
// The camera can go anywhere if the shader has no such function, and until the driver has compiled
// the program, which the first call begins. Each call waits for the GPU.
//   inputs  of the picture that is shown, with the camera before the move
//   to      where the camera is going; receives where it stops
// If the program does not link, reports the error, leaves to unchanged and returns false.
bool room_keep(struct renderer *renderer, const struct renderer_inputs *inputs, float to[3]);

#endif
