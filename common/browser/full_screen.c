// Replaces window/full_screen.c in a browser, where only a page's script may switch to full screen.
#include "window/full_screen.h"

void window_toggle_full_screen(struct window *window)
{
    (void)window;
}
