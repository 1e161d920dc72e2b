// selection.h - the view, and the selected parameter, which the keys change and the title bar
// shows.
#ifndef WINDOW_SELECTION_H
#define WINDOW_SELECTION_H

#include "window/state.h"

// Return the selected parameter if the shader still has it, otherwise the first parameter, or NULL
// if the shader has none.
struct parameter *window_selected(const struct window *window);

// Return the selected component of the selected parameter, or -1 for all.
int window_selected_part(const struct window *window);

// Select a parameter.
//   part  one of its components; -1 for all
void window_select(struct window *window, const struct parameter *parameter, int part);

// Copy the values of a parameter's components.
//   part  one of them; -1 for all
void window_copy_parts(struct parameter *parameter, const double value[4], int part);

// Return the selected parameter, and the range of its components that the last press on the panel
// grabbed: from *first up to, but not including, *end. Returns NULL if the shader has no such
// component.
struct parameter *window_grabbed(const struct window *window, int *first, int *end);

// Call this after the value of the selected parameter has changed.
void window_parameter_changed(struct window *window);

// If a parameter is the hour at which the picture's time begins, begin again, so that the picture
// shows the hour that somebody has just chosen.
void window_begin_hour(struct window *window, const struct parameter *parameter);

// Switch to a view. If the shader does not have the view, the error is also shown in the overlay.
//   view  an enum shader_view
void window_show_view(struct window *window, int view);

#endif
