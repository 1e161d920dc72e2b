// window.h - the interactive loop: keys, mouse, reload, the title bar.
#ifndef WINDOW_H
#define WINDOW_H

#include <stdbool.h>

#include "context/context.h"
#include "picture/renderer.h"
#include "window/start.h"

// Run until the window is closed.
//   context   with a visible window
//   renderer  with the shader loaded and the view set
//   start     must outlive the call
// Returns false, reported, when drawing failed.
bool window_run(struct context *context, struct renderer *renderer,
                const struct window_start *start);

#endif
