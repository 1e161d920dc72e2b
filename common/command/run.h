// run.h - one run of a chapter: what its command line asks for, what was read for that, and what
// works on it.
#ifndef RUN_H
#define RUN_H

#include "command/options.h"
#include "context/context.h"
#include "picture/image.h"
#include "picture/probe.h"
#include "picture/renderer.h"
#include "picture/second.h"
#include "platform.h"
#include "window/window.h"

// Exit statuses: done; it could not be done; the command line is wrong; no window can be opened
// here.
enum { RUN_DONE = 0, RUN_NOT_DONE = 1, RUN_WRONG_COMMAND_LINE = 2, RUN_NO_WINDOW = 3 };

// One of zeros is closed.
struct run {
    const char *stem;  // of the chapter
    const char *title; // of the chapter, or the name of the file that runs in place of its shader
    struct options options;
    char root[PLATFORM_PATH];   // the project's folder
    char shader[PLATFORM_PATH]; // the shader to run
    struct shader_request request;
    // What was read of it, until the renderer takes it over.
    struct shader_source source;
    struct parameters parameters;
    struct second second; // of --compare
    // What works until run_close.
    struct context context;
    struct renderer renderer;
    struct window_start start;
    struct window *window; // NULL where none was asked for
};

// Read the command line.
//   stem, title, camera  the chapter's; the strings must outlive the run, as argv must
// Returns false, reported: it is wrong.
bool run_parse(struct run *run, const char *stem, const char *title, const struct camera *camera,
               int argc, char **argv);

void run_close(struct run *run);

// ---- Files (run_files.c) ----

// Find the project's folder: --root, or the nearest folder above the program that holds shaders/,
// so that programs run from any directory. Returns false, reported.
bool run_find_root(struct run *run);

// Find the shader, when the root is known. Returns false, reported.
bool run_find_shader(struct run *run);

// Read the shader and its parameters, with values and pictures of the command line. Returns the
// exit status.
int run_read_shader(struct run *run);

// True when every file of --output can be written, before the work of rendering, and is none that
// this run has read: a picture in its place would destroy a person's work. Reported.
bool run_check_targets(const struct run *run);

// ---- What needs no window (run_still.c) ----

// What the picture of a command line is drawn from. No clock: it is a function of its options
// alone.
struct renderer_inputs run_still_inputs(const struct options *options);

// Where the ray of --probe starts, if that is not at the camera.
//   eye  must outlive the inputs
void run_start_ray(const struct options *options, const struct renderer *renderer,
                   struct renderer_inputs *inputs, struct renderer_eye *eye);

// Draw a picture with what stands over it. The caller frees image.
//   probe  of the pixel that --probe names, or NULL
// Returns false, reported.
bool run_draw(const struct run *run, struct renderer *renderer,
              const struct renderer_inputs *inputs, const struct probe *probe, struct image *image);

// The tables of --probe, then the picture of --output, or the pictures of --frames.
//   renderer  has loaded the shader
// Returns false, reported.
bool run_still(const struct run *run, struct renderer *renderer);

#endif
