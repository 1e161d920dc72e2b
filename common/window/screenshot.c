#include "window/screenshot.h"

#include <math.h>
#include <stdio.h>

#include "picture/image.h"
#include "picture/comparison.h"
#include "memory.h"
#include "platform.h"
#include "report.h"
#include "window/condition.h"
#include "window/frames.h"

#define LAST 9999 // the highest number of a screenshot

bool window_screenshot_due(const struct window *window)
{
    return window->shooting && (window->pace.resolution.level == 0 || window_keeps(window) ||
                                window->sharpening.rows == window->sharpening.inputs.height);
}

// Find the first unused name. Returns false after reporting the error if there is none.
static bool find_name(const struct window *window, char path[256])
{
    struct platform_file there;
    int number = 1;
    do
        snprintf(path, 256, "%.200s-%04d.png", window->start->stem, number);
    while (platform_look(path, &there) && ++number <= LAST);
    return number <= LAST ||
           report("%s: all names up to this one are used: move some screenshots away", path);
}

// Add the labels and the divider of a comparison, as in a picture of --output. An overlay that
// screenshots show already contains them.
static void add_labels(struct window *window)
{
    struct renderer *renderer = window->renderer;
    struct overlay *overlay = &window->panel.overlay;
    if (renderer->comparison == NULL || window->start->overlay_kept)
        return;
    comparison_gather(renderer, overlay, window->inputs.width, window->inputs.height,
                      overlay->scale);
    renderer->overlay = overlay;
}

void window_screenshot(struct window *window)
{
    struct image image = {0};
    char path[256];
    const struct renderer_inputs inputs = window_inputs_shown(window);
    bool small = inputs.width < window->inputs.width;
    bool sharpened = window->pace.resolution.level > 0 && !window_keeps(window);
    window->shooting = false;
    add_labels(window);
    if (small) // the overlay has the size of the window
        window->renderer->overlay = NULL;
    bool drawn = sharpened ? renderer_sharp_picture(window->renderer, &image)
                           : renderer_picture(window->renderer, &inputs, &image);
    if (drawn && find_name(window, path) && image_write_png(&image, path)) {
        report_result("%s: written, %dx%d\n", path, image.width, image.height);
        fflush(stdout);
        if (small)
            memory_append(path, sizeof path,
                          ", %d %% of the window's width: so its frames are kept",
                          (int)round(100.0 * image.width / window->inputs.width));
        window_note(window, "Screenshot", path);
    }
    image_free(&image);
    // Drawing the screenshot has overwritten the picture that the window shows.
    window->stale |= !sharpened;
}
