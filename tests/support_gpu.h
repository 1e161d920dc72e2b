// support_gpu.h - a context and a renderer for tests: draw a shader, get its numbers back.
#ifndef SUPPORT_GPU_H
#define SUPPORT_GPU_H

#include <stdbool.h>

#include "../common/context/context.h"
#include "../common/picture/renderer.h"

struct gpu {
    struct context context;
    struct renderer renderer;
    char root[4096]; // the project's folder: PROJECT_ROOT, or "."
};

// The project's folder: the environment's PROJECT_ROOT, or ".".
const char *gpu_project_root(void);

// Open a context without a window and a renderer in it. False, reported. Close with gpu_close.
bool gpu_open(struct gpu *gpu);
void gpu_close(struct gpu *gpu);

// Load a shader, a path below the project's folder, with its parameters as the shader says. False,
// reported.
bool gpu_load(struct gpu *gpu, const char *shader);

// Draw the loaded shader and read the float target: 4 * width * height floats, bottom row first,
// which the caller frees. NULL, reported.
float *gpu_numbers(struct gpu *gpu, const struct renderer_inputs *inputs);

// What the numeric test shaders get from C: the function, and four numbers of its own.
//   function  the shader's Time
//   numbers   its iMouse
float *gpu_call(struct gpu *gpu, int width, int height, int function, const float numbers[4]);

#endif
