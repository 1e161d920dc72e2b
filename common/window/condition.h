// condition.h - what the keys of a window can act on.
#ifndef WINDOW_CONDITION_H
#define WINDOW_CONDITION_H

#include <stdbool.h>

#include "shader/inputs.h"

struct window;

// When a row's keys act, and the overlay lists them.
enum key_condition {
    KEY_ALWAYS,
    KEY_WITH_CAMERA, // the shader reads where the camera is and where it looks
    KEY_WITH_LENS,   // the shader reads the focal length
    KEY_WITH_MARCH,  // the shader records its march
    KEY_WITH_TIME,   // the picture changes with time
    KEY_WITH_EDITOR, // not in a web page
    KEY_WITH_RAY,
    KEY_WITH_PARAMETERS,
    KEY_WITH_HANDLES,
    KEY_WITH_TOOL,
    KEY_WITH_PROJECTIONS,
    KEY_WITH_COMPARISON,
    KEY_WITH_SCENES,   // in a course or a lecture
    KEY_WITH_CONTENTS, // in the course, while no ray is selected
    KEY_IN_LECTURE
};

// True if the picture on the screen depends on the time, or on frames that are kept.
bool window_uses_time(const struct window *window);

// Pause a picture that depends on the time, or resume it. No other picture is paused. In a mean of
// frames nothing moves, so a pause makes it finer instead of stopping it.
void window_pause(struct window *window);

// True if the window's scenes have contents, as those of the course do.
bool window_has_contents(const struct window *window);

// True in a course or a lecture, where keys change the scene.
bool window_has_scenes(const struct window *window);

// True if what the window shows, or keeps of a frame, reads one of some inputs.
//   first, last  of these inputs, in the order of input_meaning
bool window_reads(const struct window *window, enum input_meaning first, enum input_meaning last);

// True if the keys of a row act on what the window shows.
bool window_key_acts(struct window *window, enum key_condition condition);

// If the keys of a row do nothing here, and have no other meaning, let the overlay say why, once.
void window_explain_key(struct window *window, enum key_condition condition);

// Show a line in the overlay for some seconds, or until the next key.
//   heading  the line above it, which must outlive the note
//   words    copied
void window_note(struct window *window, const char *heading, const char *words);

#endif
