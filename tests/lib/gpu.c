#include "lib/gpu.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "lib/mirror.h"
#include "lib/scratch.h"

struct gpu gpu;

const char *gpu_project_root(void)
{
    const char *root = getenv("PROJECT_ROOT");
    return root != NULL && root[0] != '\0' ? root : ".";
}

bool gpu_open(void)
{
    memset(&gpu, 0, sizeof gpu);
    snprintf(gpu.root, sizeof gpu.root, "%s", gpu_project_root());
    return context_open_offscreen(&gpu.context, CONTEXT_ANY) &&
           renderer_open(&gpu.renderer, &gpu.context.gl, gpu.root);
}

void gpu_close(void)
{
    renderer_close(&gpu.renderer);
    context_close(&gpu.context);
}

int gpu_setup(void **state)
{
    return scratch_setup(state) == 0 && gpu_open() ? 0 : -1;
}

int gpu_teardown(void **state)
{
    gpu_close();
    return scratch_teardown(state);
}

bool gpu_load_file(struct renderer *renderer, const char *path)
{
    gpu.called[0] = '\0';
    struct shader_source source = {0};
    struct parameters parameters = {0};
    bool loaded = shader_read(&source, path, renderer->root) &&
                  parameters_read(&parameters, &source) &&
                  renderer_load(renderer, &source, &parameters);
    shader_free(&source);
    parameters_free(&parameters);
    return loaded;
}

// Every shader starts with the default values of its parameters.
static void reset_parameters(void)
{
    for (int i = 0; i < gpu.renderer.parameters.count; i++)
        parameter_reset(&gpu.renderer.parameters.item[i]);
}

bool gpu_load(const char *shader)
{
    char path[8192];
    snprintf(path, sizeof path, "%s/%s", gpu.root, shader);
    if (!gpu_load_file(&gpu.renderer, path))
        return false;
    reset_parameters(); // a reload keeps the values of the previous shader
    return true;
}

void gpu_open_shader(const char *shader)
{
    assert_true(gpu_load(shader));
}

struct camera gpu_camera(const char *stem)
{
    struct camera camera;
    assert_true(mirror_camera(gpu.root, stem, &camera));
    return camera;
}

struct camera gpu_open_chapter(const char *stem)
{
    char path[256];
    snprintf(path, sizeof path, "chapters/%s.frag", stem);
    gpu_open_shader(path);
    return gpu_camera(stem);
}

void gpu_set(const char *name, double value)
{
    struct parameter *parameter = parameters_find(&gpu.renderer.parameters, name);
    assert_non_null(parameter);
    parameter->value[0] = value;
}

bool gpu_load_text(const char *text)
{
    return gpu_load_file(&gpu.renderer, scratch_write("shader.frag", text));
}

struct renderer_inputs gpu_inputs(int width, int height, int samples)
{
    return (struct renderer_inputs){
        .width = width,
        .height = height,
        .camera = {.position = {1.5f, 2.75f, 5.3f}, .pan = -17.0f, .tilt = -22.5f},
        .samples = samples};
}

float *gpu_numbers(const struct renderer_inputs *inputs)
{
    float *values = malloc(4 * sizeof *values * (size_t)inputs->width * (size_t)inputs->height);
    assert_non_null(values);
    assert_true(renderer_draw(&gpu.renderer, inputs, 0, inputs->height));
    target_read(&gpu.renderer.picture, gpu.renderer.gl, values);
    return values;
}

float *gpu_call(const char *shader, int width, int height, int function, const float numbers[4])
{
    struct renderer_inputs inputs = {
        .width = width, .height = height, .time = function, .samples = 1};
    memcpy(inputs.mouse, numbers, sizeof inputs.mouse);
    if (strcmp(gpu.called, shader) == 0) {
        reset_parameters();
    } else {
        assert_true(gpu_load(shader));
        snprintf(gpu.called, sizeof gpu.called, "%s", shader);
    }
    return gpu_numbers(&inputs);
}

bool gpu_sharpen(struct renderer *renderer, const struct renderer_inputs *inputs, int bottom,
                 int rows)
{
    struct renderer_piece piece = {0, inputs->width / 3, bottom, bottom + rows};
    if (!renderer_sharpen(renderer, inputs, &piece))
        return false;
    piece.left = piece.right;
    piece.right = inputs->width;
    return renderer_sharpen(renderer, inputs, &piece);
}
