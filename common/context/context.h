// context.h - one OpenGL 3.3 core context from one of three backends.
#ifndef CONTEXT_H
#define CONTEXT_H

#include <stdbool.h>
#include <stddef.h>

#include "context/gl.h"

#define CONTEXT_WHY 512 // bytes of a phrase that explains a failure

enum context_backend { CONTEXT_ANY, CONTEXT_GLFW, CONTEXT_EGL, CONTEXT_OSMESA };

// A backend: glfw.c, egl.c or osmesa.c. A backend whose library make did not find is absent.
struct context_driver {
    enum context_backend backend;
    const char *name; // "glfw", "egl", "osmesa"
    // Create a 3.3 core context without a visible window and make it current. Returns the backend's
    // state, or NULL after writing to why a phrase that says what was tried and what the library
    // answered.
    void *(*open_offscreen)(char why[CONTEXT_WHY]);
    // Do the same with a visible, resizable window, whose handle is the state. A backend that
    // cannot open windows has NULL here.
    //   width, height  in screen coordinates
    void *(*open_window)(const char *title, int width, int height, char why[CONTEXT_WHY]);
    gl_function (*find)(const char *name);
    // Return the platform that the backend chose, such as "surfaceless". A backend with only one
    // platform has NULL here.
    const char *(*platform)(const void *state);
    void (*close)(void *state);
};

extern const struct context_driver context_driver_glfw, context_driver_egl, context_driver_osmesa;

struct GLFWwindow;

struct context {
    const struct context_driver *driver;
    void *state;               // the backend's state, freed by context_close
    struct GLFWwindow *window; // the visible window, or NULL if there is none
    struct gl gl;              // the functions of this context
};

// Open a context without a visible window, for drawing into off-screen targets.
//   wanted   CONTEXT_ANY tries egl, then osmesa, then a hidden glfw window
// If no context can be opened, reports in one line why each backend failed, and returns false.
bool context_open_offscreen(struct context *context, enum context_backend wanted);

// Open a visible, resizable window with a current context.
//   wanted         CONTEXT_ANY or CONTEXT_GLFW; no other backend can show a window
//   width, height  in screen coordinates; on a high-density display the framebuffer is larger
// Returns false after reporting the error, such as no display or no OpenGL 3.3.
bool context_open_window(struct context *context, enum context_backend wanted, const char *title,
                         int width, int height);

// Close a context that context_open_* opened. A zero-initialised context is allowed.
void context_close(struct context *context);

// Describe the context in one line of at most size bytes, such as
// "egl (surfaceless), OpenGL 3.3 (Core Profile) Mesa 22.3.6, llvmpipe (...)".
void context_describe(const struct context *context, char *text, size_t size);

// Convert a name, such as "egl", to the backend. Returns false without reporting an error if the
// name is unknown.
bool context_backend_from_name(const char *name, enum context_backend *backend);

#endif
