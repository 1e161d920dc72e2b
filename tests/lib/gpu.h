// gpu.h - a context and a renderer for tests, which draw shaders and read back their numbers.
#ifndef TESTS_GPU_H
#define TESTS_GPU_H

#include <stdbool.h>

#include "context/context.h"
#include "picture/renderer.h"

// Each test program has one context and one renderer.
extern struct gpu {
    struct context context;
    struct renderer renderer;
    char root[4096];   // the project's folder: PROJECT_ROOT, or "."
    char called[4096]; // the shader that gpu_call loaded; "" if another was loaded since
} gpu;

// The project's folder: the environment variable PROJECT_ROOT or, if it is unset or empty, ".".
const char *gpu_project_root(void);

// Open a context without a window, and a renderer in it. Returns false after reporting the error.
// Close both with gpu_close.
bool gpu_open(void);
void gpu_close(void);

// cmocka's setup and teardown for a group of tests: call gpu_open and gpu_close, and make and
// remove a scratch folder (scratch.h).
int gpu_setup(void **state);
int gpu_teardown(void **state);

// Read a shader from a file and load it into a renderer. Returns false after reporting the error.
bool gpu_load_file(struct renderer *renderer, const char *path);

// Load a shader, given as a path below the project's folder, with the shader's default parameters.
// Returns false after reporting the error.
bool gpu_load(const char *shader);

// If one of these functions fails, it fails the test or ends the program. gpu_open_shader loads a
// shader like gpu_load. gpu_camera and gpu_open_chapter return the starting camera of a chapter;
// gpu_open_chapter also loads the chapter's shader. gpu_set sets a parameter of the loaded shader
// to a number, which may be outside the parameter's range.
void gpu_open_shader(const char *shader);
struct camera gpu_camera(const char *stem);
struct camera gpu_open_chapter(const char *stem);
void gpu_set(const char *name, double value);

// Write the text of a shader to a file in the scratch folder, and load it. Returns false after
// reporting the error.
bool gpu_load_text(const char *text);

// The first lines of a text for gpu_load_text, to which only rayColour has to be added: a parallel
// view of the plane z = 0.
#define GPU_COURSE                                                                                 \
    "#include \"main.glsl\"\n"                                                                     \
    "Ray pixelRay(vec2 screen) { return Ray(vec3(screen, 0.0), vec3(0.0, 0.0, -1.0)); }\n"         \
    "float sceneDistance(vec3 p) { return p.z; }\n"

// The inputs of a picture, with a camera that sees the solids of chapters 01 to 03.
struct renderer_inputs gpu_inputs(int width, int height, int samples);

// Draw the loaded shader and read the float target: 4 * width * height floats, bottom row first,
// which the caller frees. Fails the test, or ends the program, if that is impossible.
float *gpu_numbers(const struct renderer_inputs *inputs);

// Sharpen rows [bottom, bottom + rows) of a picture in two pieces. Returns false after reporting
// the error.
bool gpu_sharpen(struct renderer *renderer, const struct renderer_inputs *inputs, int bottom,
                 int rows);

// Load a shader, unless the last call loaded the same shader, call one of its functions with four
// numbers, and read the target like gpu_numbers. Fails the test if that is impossible.
//   function  the function's index, passed as the shader's Time
//   numbers   the arguments, passed as the shader's iMouse
float *gpu_call(const char *shader, int width, int height, int function, const float numbers[4]);

#endif
