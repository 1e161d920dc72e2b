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

#endif
