// events.h - random input for a window: sequences of events that can be carried out, and printed as
// the lines of C that carry them out again.
#ifndef TESTS_EVENTS_H
#define TESTS_EVENTS_H

#include <stdint.h>
#include <stdio.h>

// A random number from 0 to count - 1. The same state gives the same sequence of numbers on every
// system.
//   state  any number at first; each call changes it
int events_random(uint64_t *state, int count);

// What an event does, with its numbers: i and k are whole numbers, x and y are not. own is the stem
// of the chapter for events_save, and turn runs an iteration of the program's main loop.
#define EVENTS(X)                                                                                  \
    X(TURNS, for (int n = 0; n < i; n++) turn())                                                   \
    X(PRESS, user_press(i, k))                                                                     \
    X(RELEASE, user_release(i))                                                                    \
    X(REPEAT, user_repeat(i, k))                                                                   \
    X(LETTER, user_type((char[]){(char)i, '\0'}))                                                  \
    X(POINT, user_point(x, y))                                                                     \
    X(BUTTON, user_button(i, k))                                                                   \
    X(WHEEL, user_wheel(x))                                                                        \
    X(RESIZE, user_resize(i, k))                                                                   \
    X(DENSITY, user.density = i)                                                                   \
    X(FOCUS, user_focus(i))                                                                        \
    X(HIDE, user.hidden = i)                                                                       \
    X(ENTER, user_enter(i))                                                                        \
    X(DAMAGE, user.calls.damage(NULL))                                                             \
    X(CLOCK, user.now += x)                                                                        \
    X(COST, user.pixel_seconds = x)                                                                \
    X(COPY, user.clipboard = events_clipboard(i))                                                  \
    X(DROP, user_drop(events_dropped(i)))                                                          \
    X(SAVE, events_save(own, i, k))

enum event_kind {
#define EVENTS_KIND(name, code) EVENTS_##name,
    EVENTS(EVENTS_KIND)
#undef EVENTS_KIND
};

struct event {
    enum event_kind kind;
    int i, k;
    double x, y;
};

// The names of the files that a sequence may change, in the scratch folder.
enum { EVENTS_FILES = 2 };
extern const char *const events_file[EVENTS_FILES];

// Write one of the texts to a file. Text 0 is the shader of a chapter, which compiles, and text 1
// has an error; the event SAVE writes any of them, or removes the file.
//   own  the stem of the chapter
void events_save(const char *own, int file, int text);

// Fill events with random gestures: keys with and without Shift, drags that leave the window, the
// wheel, new sizes down to 1x1, the loss of the focus, edits of the shader, dropped files. The
// first event says how long a pixel takes to draw, and belongs before the program is opened.
//   state   the state of events_random
//   count   how many events
void events_make(uint64_t *state, struct event *events, int count);

// One of some texts for the clipboard, or NULL.
const char *events_clipboard(int text);

// The path of one of some files that are dropped on the window: the first is a shader of
// EVENTS_FILES, and the others are pictures and files that cannot be shown.
const char *events_dropped(int file);

// Carry out an event; turn and own are those of EVENTS.
void events_do(const struct event *event, void (*turn)(void), const char *own);

// Print an event as a line of C, in which turn stays a function, but own is replaced too.
void events_print(const struct event *event, const char *own, FILE *to);

#endif
