// chapter.h - everything that a chapter's program needs.
//
//   #include "../common/chapter.h"
//
//   int main(int argc, char **argv)
//   {
//       const struct chapter chapter = { .stem = "01_normal_colouring", ... };
//       return chapter_run(&chapter, argc, argv);
//   }
#ifndef CHAPTER_H
#define CHAPTER_H

#include <stdbool.h>

#include "camera.h"
#include "picture/sculpture.h"

// A chapter. Its shader is chapters/STEM.frag.
struct chapter {
    const char *stem;                  // "01_normal_colouring"
    const char *title;                 // for the window's title bar and --help
    const char *shows;                 // one sentence about what the picture shows
    struct camera camera;              // the camera at the start
    const struct sculpture_tool *tool; // changes a texture under the pointer; may be NULL
};

// Execute the command line: options -> shader -> context -> renderer -> picture or window.
// Returns the exit status: 0 after success, 1 after a failure, 2 if the command line is wrong, and
// 3 if no window can be opened. Every status other than 0 is reported.
int chapter_run(const struct chapter *chapter, int argc, char **argv);

// ---- For callers with their own main loop ----

struct run;
struct window;

// Execute the command line up to the window's main loop.
//   run            receives the run; the caller closes it with chapter_close, whatever the status
//   chapter, argv  must outlive the run
// Returns the exit status so far, as chapter_run does.
int chapter_open(struct run **run, const struct chapter *chapter, int argc, char **argv);

// Read the shaders of a command line, and have the driver start compiling them. Once chapter_ready
// returns true, chapter_open, called with another run, no longer waits for the compiler. An error
// is reported here, and again by chapter_open.
//   run  receives the run; the caller closes it with chapter_close
void chapter_begin(struct run **run, const struct chapter *chapter, int argc, char **argv);
bool chapter_ready(const struct run *run);

// Return the window, whose loop the caller runs, or NULL if no window was requested or none could
// be opened.
struct window *chapter_window(const struct run *run);

void chapter_close(struct run *run);

// Visit every path that is looked up while the shaders of a command line are read. No picture is
// drawn.
//   visit  is called with to and each path
void chapter_visit_files(const struct chapter *chapter, int argc, char **argv,
                         void (*visit)(void *to, const char *path), void *to);

#endif
