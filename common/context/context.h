// context.h - one OpenGL 3.3 core context from one of three backends.
#ifndef CONTEXT_H
#define CONTEXT_H

#include <stdbool.h>
#include <stddef.h>

#include "context/driver.h"
#include "context/gl.h"

struct GLFWwindow;

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

#endif
