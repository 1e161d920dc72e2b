// selection.h - the view, and the selected parameter: the one that the keys change and the title
// bar shows.
#ifndef WINDOW_SELECTION_H
#define WINDOW_SELECTION_H

#include "window/state.h"

// The selected parameter if the shader still has it, otherwise the first one; NULL if there is
// none.
struct parameter *window_selected(const struct window *window);

// Select a parameter.
void window_select(struct window *window, const struct parameter *parameter);

// The parameter that the last press on the panel grabbed, or NULL, and the grabbed components: from
// *first up to, but not including, *behind.
struct parameter *window_grabbed(const struct window *window, int *first, int *behind);

// Call it after the value of a parameter has changed.
void window_parameter_changed(struct window *window);

// Switch to a view. One that the shader does not have is refused in the overlay, where the reader
// is looking.
//   view  of enum shader_view
void window_show_view(struct window *window, int view);

#endif
