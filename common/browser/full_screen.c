// Replaces window/full_screen.c in a browser, which allows full screen only to a page's script.
#include "window/full_screen.h"

void window_toggle_full_screen(struct window *window)
{
    (void)window;
}
