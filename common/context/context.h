// context.h - one OpenGL 3.3 core context from one of three backends.
#ifndef CONTEXT_H
#define CONTEXT_H

#include <stdbool.h>
#include <stddef.h>

#include "context/gl.h"

enum context_backend { CONTEXT_ANY, CONTEXT_GLFW, CONTEXT_EGL, CONTEXT_OSMESA };

struct GLFWwindow;

// What a backend offers. The three tables live in context_glfw.c, context_egl.c, context_osmesa.c;
// one that was not compiled in (its library was not found by make) is absent.
struct context_driver {
    enum context_backend backend;
    const char *name; // "glfw", "egl", "osmesa"
    // Make a 3.3 core context current, with nothing on the screen. Returns the backend's own state,
    // or NULL and one phrase in why (what was tried, what the library answered).
    void *(*open_offscreen)(char *why, size_t why_size);
    gl_function (*find)(const char *name);
    // Which of the backend's own platforms was taken ("surfaceless"); NULL where it has one only.
    const char *(*platform)(const void *state);
    void (*close)(void *state);
};

struct context {
    const struct context_driver *driver;
    void *state;               // the backend's own, freed by context_close
    struct GLFWwindow *window; // the visible window, or NULL when there is none
    struct gl gl;              // the functions of this context
};

// Open a context that draws into targets of its own, without a window.
//   wanted   CONTEXT_ANY tries egl, then osmesa, then a hidden glfw window
// Returns false after one reported line that names each backend tried and why it could not.
bool context_open_offscreen(struct context *context, enum context_backend wanted);

// Open a visible, resizable window with a current context (glfw alone can).
//   wanted          CONTEXT_ANY or CONTEXT_GLFW; another is reported as unable to show a window
//   width, height   in screen coordinates; on a high-density display the framebuffer is larger
// Returns false, reported: no display, no OpenGL 3.3, ...
bool context_open_window(struct context *context, enum context_backend wanted, const char *title,
                         int width, int height);

// Destroy what context_open_* made. A context of zeros is allowed.
void context_close(struct context *context);

// One line: "egl (surfaceless), OpenGL 3.3 (Core Profile) Mesa 22.3.6, llvmpipe (...)".
void context_describe(const struct context *context, char *text, size_t size);

// The backend of a name given on the command line; false (not reported) for an unknown one.
bool context_backend_from_name(const char *name, enum context_backend *backend);

// The drivers, each defined where its library was found (HAVE_GLFW, HAVE_EGL, HAVE_OSMESA).
extern const struct context_driver context_driver_glfw;
extern const struct context_driver context_driver_egl;
extern const struct context_driver context_driver_osmesa;

// For context_open_window, in context_glfw.c: the window with its context, or NULL and a phrase.
void *context_glfw_open_window(const char *title, int width, int height, char *why,
                               size_t why_size);
struct GLFWwindow *context_glfw_window(void *state);

#endif
