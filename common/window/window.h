// window.h - the interactive loop: keys, mouse, reload, the title bar.
#ifndef WINDOW_H
#define WINDOW_H

#include <stdbool.h>

#include "context/context.h"
#include "options.h"
#include "picture/renderer.h"

// Run until the window is closed.
//   context   with a visible window
//   renderer  with the shader loaded and the view set
//   options   the starting size, time, camera and samples
//   title     of the chapter, for the title bar and the names of screenshots
//   stem      of the chapter: screenshots are STEM-0001.png, ... in the current folder
//   shader    path of the shader's file, watched and loaded again when it or an include changes
// Returns false, reported, when drawing failed.
bool window_run(struct context *context, struct renderer *renderer, const struct options *options,
                const char *title, const char *stem, const char *shader);

#endif
