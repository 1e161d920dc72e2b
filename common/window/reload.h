// reload.h - from a file that has changed, or that was dropped on the window, to a new picture.
#ifndef WINDOW_RELOAD_H
#define WINDOW_RELOAD_H

#include "window/state.h"

// Watch the files of the scene's shaders.
void window_watch_files(struct window *window);

// Open the file that was dropped on the window since the last call, if there is one. If it can be
// opened or if watched files have changed, begin to compile the shaders; if that is done, show
// their picture. If it fails, the last good picture and the error are shown, and window->broken is
// true.
//   changed  a watched file has changed
void window_reload(struct window *window, bool changed);

#endif
