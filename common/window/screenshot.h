// screenshot.h - writes screenshots.
#ifndef WINDOW_SCREENSHOT_H
#define WINDOW_SCREENSHOT_H

#include "window/state.h"

// True if a screenshot was requested, and the picture has full resolution or has been sharpened.
bool window_screenshot_due(const struct window *window);

// Write the screenshot. An error is reported, and the window stays open.
void window_screenshot(struct window *window);

#endif
