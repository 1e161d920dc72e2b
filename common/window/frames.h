// frames.h - the frames of a shader that reads what it has kept of the last one. Such a shader has
// a fixed time from frame to frame, whatever the clock says, so that what the window shows is the
// picture of a command line with --frame.
#ifndef WINDOW_FRAMES_H
#define WINDOW_FRAMES_H

#include "window/state.h"

// True if the window's shader keeps frames.
bool window_keeps(const struct window *window);

// The inputs of the window's picture at a resolution level.
struct renderer_inputs window_inputs_at(const struct window *window, int level);

// The inputs of the picture that is shown, if its march or its pixels are needed again: frames that
// are kept have the size at which they were drawn, and any other picture has the window's size.
struct renderer_inputs window_inputs_shown(const struct window *window);

// True if the kept frames do not depend on the time, so that later ones only refine a mean.
bool window_averages(const struct window *window);

// The frame at which the window stops, or -1 if it goes on: that of the command line, or the last
// of a mean.
int window_last_frame(const struct window *window);

// Go on to the next frame, unless the present one has not been drawn yet, or is the last that was
// asked for. Returns true if there is another frame to draw.
bool window_next_frame(struct window *window);

// If the shader keeps frames, set the time of the present one. If they begin again, because
// something on which they depend has changed, this is frame 0.
//   level  the resolution level at which the picture is drawn
void window_follow_frames(struct window *window, int level);

// Choose the resolution level of the window's next frame. Frames that are kept hold theirs after a
// few, because they begin again with another one. But a level that was chosen while the driver was
// still compiling is far too coarse, so a much finer one is taken while the frames are still few.
int window_choose_level(struct window *window);

#endif
