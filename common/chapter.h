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
    const char *shows;                 // one sentence: what the picture shows
    struct camera camera;              // the initial view
    const struct sculpture_tool *tool; // changes a texture under the pointer; may be NULL
};

// Carry out the command line: options -> shader -> context -> renderer -> picture or window.
// Returns the exit status: 0 success; 1 failure; 2 the command line is wrong; 3 no window can be
// opened here. All but the first are reported.
int chapter_run(const struct chapter *chapter, int argc, char **argv);

// ---- For callers with their own main loop ----

struct run;
struct window;

// Carry out the command line up to the window's loop.
//   run            receives what chapter_close frees, whatever the status is
//   chapter, argv  must outlive the run
// Returns the exit status so far, as chapter_run does.
int chapter_open(struct run **run, const struct chapter *chapter, int argc, char **argv);

// Read the shaders of a command line, and have the driver start compiling them. When chapter_ready
// returns true, chapter_open, called with another run, no longer waits for the compiler. An error
// is reported here, and again by chapter_open.
//   run  receives what chapter_close frees
void chapter_begin(struct run **run, const struct chapter *chapter, int argc, char **argv);
bool chapter_ready(const struct run *run);

// The window, whose loop the caller runs; NULL if none was requested or none could be opened.
struct window *chapter_window(const struct run *run);

void chapter_close(struct run *run);

// Visit every path that is looked up while the shaders of a command line are read. No picture is
// drawn.
//   visit  is called with to and each path
void chapter_visit_files(const struct chapter *chapter, int argc, char **argv,
                         void (*visit)(void *to, const char *path), void *to);

#endif
