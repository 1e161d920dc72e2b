// driver.h - what a backend offers to context.c. One that was not compiled in, for make found no
// library of it, is absent.
#ifndef CONTEXT_DRIVER_H
#define CONTEXT_DRIVER_H

#include "context/gl.h"

#define CONTEXT_WHY 512 // size of a phrase, bytes

enum context_backend { CONTEXT_ANY, CONTEXT_GLFW, CONTEXT_EGL, CONTEXT_OSMESA };

struct context_driver {
    enum context_backend backend;
    const char *name; // "glfw", "egl", "osmesa"
    // Make a 3.3 core context current, with nothing on the screen. Returns the backend's own state,
    // or NULL and one phrase in why (what was tried, what the library answered).
    void *(*open_offscreen)(char why[CONTEXT_WHY]);
    // The same with a visible, resizable window, which is the state. NULL for a backend that has
    // none.
    //   width, height  in screen coordinates
    void *(*open_window)(const char *title, int width, int height, char why[CONTEXT_WHY]);
    gl_function (*find)(const char *name);
    // Which of the backend's own platforms was taken ("surfaceless"); NULL where it has one only.
    const char *(*platform)(const void *state);
    void (*close)(void *state);
};

// Each is defined where its library was found: HAVE_GLFW, HAVE_EGL, HAVE_OSMESA.
extern const struct context_driver context_driver_glfw;   // in glfw.c
extern const struct context_driver context_driver_egl;    // in egl.c
extern const struct context_driver context_driver_osmesa; // in osmesa.c

#endif
