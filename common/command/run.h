// run.h - one run of a chapter: its command line, the shaders that were read for it, and the
// context that draws them.
#ifndef RUN_H
#define RUN_H

#include "command/options.h"
#include "context/context.h"
#include "picture/image.h"
#include "picture/loader.h"
#include "picture/comparison.h"
#include "picture/probe.h"
#include "platform.h"
#include "window/window.h"

// Exit statuses: success; failure; a wrong command line; no window can be opened here.
enum { RUN_DONE = 0, RUN_NOT_DONE = 1, RUN_WRONG_COMMAND_LINE = 2, RUN_NO_WINDOW = 3 };

// A zero-initialised run is closed.
struct run {
    const char *stem;                  // the chapter's stem
    const struct sculpture_tool *tool; // the chapter's tool; NULL if it has none
    // The chapter's title or, with --shader and without --labels, the clean name of the file.
    char title[256];
    struct options options;
    char root[PLATFORM_PATH];     // the project's folder
    char shader[PLATFORM_PATH];   // the path of the shader to run
    struct loader picture[2];     // the second picture exists only with --compare
    struct comparison comparison; // of the two pictures
    char label[2][128];           // the names of --labels
    struct context context;
    struct window_start start;
    struct window *window; // NULL without a window
};

// Read the command line.
//   stem, title, camera, tool  the chapter's; the strings, the tool and argv must outlive the run
// Returns false after reporting the error if the command line is wrong.
bool run_parse(struct run *run, const char *stem, const char *title, const struct camera *camera,
               const struct sculpture_tool *tool, int argc, char **argv);

void run_close(struct run *run);

// ---- Files ----

// Find the project's folder: --root, or the nearest folder above the program in which there is
// shaders/screen.vert. Programs therefore run from any directory. Returns false after reporting the
// error.
bool run_find_root(struct run *run);

// Find the shader, once the root is known. Returns false after reporting the error.
bool run_find_shader(struct run *run);

// Read the shaders, and set their parameters and textures from the command line. Returns the exit
// status, after reporting an error.
int run_read_shaders(struct run *run);

// Have the driver start compiling the shaders that were read; shader_ready tells when run_compile
// no longer has to wait. Returns false after reporting the error.
bool run_begin(struct run *run, const struct gl *gl);

// Compile the shaders that were read, and put the second picture beside the first. A renderer that
// is already open is kept, and a shader that it already has is not compiled again.
//   gl  must outlive the run
// Returns false after reporting the error; then open renderers draw what they drew before.
bool run_compile(struct run *run, const struct gl *gl);

// Return the initial state of this run's window. The state points into the run.
struct window_start run_window_start(struct run *run);

// Check before rendering that each file of --output can be written and that this run does not read
// it: a picture must never overwrite a shader or a texture. Returns false after reporting the
// error.
bool run_check_targets(const struct run *run);

// Return the exit status of the program: status, or RUN_NOT_DONE if standard output could not be
// written. The error is reported, unless standard output is a pipe that its reader has closed.
//   window  the program showed a window, whose status does not depend on the reader of a pipe
int run_end(int status, bool window);

// ---- Without a window (run_still.c) ----

// Return the inputs for the picture of a command line. No clock is read, so the picture depends
// only on the options.
struct renderer_inputs run_still_inputs(const struct options *options);

// If --from is given, set the eye from which the ray of --probe starts.
//   eye  must outlive the inputs
void run_start_ray(const struct options *options, const struct renderer *renderer,
                   struct renderer_inputs *inputs, struct renderer_eye *eye);

// Draw a picture, with the overlay if --overlay is given, otherwise with the labels of a
// comparison. The caller frees image.
//   probe  the march of the pixel that --probe names, or NULL
// Returns false after reporting the error.
bool run_draw(struct run *run, const struct renderer_inputs *inputs, const struct probe *probe,
              struct image *image);

// Print the tables of --probe, then write the picture of --output, or the pictures of --frames. The
// shaders must be compiled.
// Returns false after reporting the error.
bool run_still(struct run *run);

#endif
