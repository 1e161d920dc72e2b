#include "support_gpu.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *gpu_project_root(void)
{
    const char *root = getenv("PROJECT_ROOT");
    return root != NULL && root[0] != '\0' ? root : ".";
}

bool gpu_open(struct gpu *gpu)
{
    memset(gpu, 0, sizeof *gpu);
    snprintf(gpu->root, sizeof gpu->root, "%s", gpu_project_root());
    return context_open_offscreen(&gpu->context, CONTEXT_ANY) &&
           renderer_open(&gpu->renderer, &gpu->context.gl, gpu->root);
}

void gpu_close(struct gpu *gpu)
{
    renderer_close(&gpu->renderer);
    context_close(&gpu->context);
}

bool gpu_load(struct gpu *gpu, const char *shader)
{
    char path[8192];
    snprintf(path, sizeof path, "%s/%s", gpu->root, shader);
    if (!renderer_load(&gpu->renderer, path))
        return false;
    // A reload keeps the values of the shader before; a test starts from the shader's own.
    for (int i = 0; i < gpu->renderer.parameters.count; i++)
        parameter_reset(&gpu->renderer.parameters.item[i]);
    return true;
}

float *gpu_numbers(struct gpu *gpu, const struct renderer_inputs *inputs)
{
    float *values = malloc(4 * sizeof *values * (size_t)inputs->width * (size_t)inputs->height);
    if (values != NULL && renderer_draw(&gpu->renderer, inputs, 0, inputs->height)) {
        renderer_read(&gpu->renderer, values);
        return values;
    }
    free(values);
    return NULL;
}

float *gpu_call(struct gpu *gpu, int width, int height, int function, const float numbers[4])
{
    struct renderer_inputs inputs = {
        .width = width, .height = height, .time = function, .samples = 1};
    memcpy(inputs.mouse, numbers, sizeof inputs.mouse);
    return gpu_numbers(gpu, &inputs);
}
