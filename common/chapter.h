// chapter.h - all that a chapter's program needs.
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

#include "camera.h"

// What a chapter is. Its shader is chapters/STEM.frag.
struct chapter {
    const char *stem;     // "01_normal_colouring"
    const char *title;    // for the window's title bar and --help
    const char *shows;    // one sentence: what the picture shows
    struct camera camera; // where the eye starts
};

// Carry out the command line: options -> context -> shader -> renderer -> image or window.
// Returns the exit status: 0 done; 1 it could not be done; 2 the command line is wrong; 3 no window
// can be opened here. All but the first are reported.
int chapter_run(const struct chapter *chapter, int argc, char **argv);

// ---- For who has a loop of his own ----

struct run;
struct window;

// Carry out the command line up to the window's loop.
//   run       receives what chapter_close frees, whatever the status is
//   chapter, argv  must outlive it
// Returns the exit status so far, as chapter_run.
int chapter_open(struct run **run, const struct chapter *chapter, int argc, char **argv);

// The window that waits for its turns; NULL where none was asked for, or none could be opened.
struct window *chapter_window(const struct run *run);

void chapter_close(struct run *run);

// Tell which files a command line asks for: every path that is looked at while its shader is read.
// No picture is drawn.
//   see  is called with each path, and with to
void chapter_see(const struct chapter *chapter, int argc, char **argv,
                 void (*see)(void *to, const char *path), void *to);

#endif
