#include "context/context.h"

#include <stdio.h>
#include <stdlib.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "platform.h"
#include "report.h"

#define HIDDEN_SIZE 16 // pixels; pictures are drawn into off-screen targets

// Describe GLFW's last error, whose text is valid only until glfwTerminate.
static void last_error(char why[CONTEXT_WHY], const char *step)
{
    const char *text = NULL;
    int code = glfwGetError(&text);
    snprintf(why, CONTEXT_WHY, "%s: %s (0x%08X)", step, text != NULL ? text : "no reason given",
             (unsigned)code);
}

static bool initialise(bool visible, char why[CONTEXT_WHY])
{
    enum platform_display display = platform_display();
    // Without this check, GLFW would try libwayland first, which may print a message.
    if (display == PLATFORM_NO_DISPLAY) {
        snprintf(why, CONTEXT_WHY, "no display: DISPLAY and WAYLAND_DISPLAY are not set");
        return false;
    }
#ifdef GLFW_PLATFORM // since 3.4, GLFW tries Wayland first even if only DISPLAY is set
    if (display == PLATFORM_X11)
        glfwInitHint(GLFW_PLATFORM, GLFW_PLATFORM_X11);
#endif
    // On macOS, the menu comes with an icon in the Dock, which a hidden window must not have.
    glfwInitHint(GLFW_COCOA_MENUBAR, visible ? GLFW_TRUE : GLFW_FALSE);
    if (glfwInit())
        return true;
    last_error(why, "glfwInit");
    return false;
}

// End the program. exit() would close the window, which needs the display.
static void end(const char *what)
{
    report("window: the display %s: start the program again", what);
    fflush(stdout);
    _Exit(EXIT_FAILURE);
}

static GLFWwindow *open_window(bool visible, const char *title, int width, int height,
                               char why[CONTEXT_WHY])
{
    if (!initialise(visible, why))
        return NULL;
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE); // macOS has no other core profile
    glfwWindowHint(GLFW_VISIBLE, visible ? GLFW_TRUE : GLFW_FALSE);
    // Without a depth buffer, llvmpipe copies frames into a window several times as fast.
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    // If a screen coordinate is one pixel, this hint enlarges a window on a high-density display.
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, visible ? GLFW_TRUE : GLFW_FALSE);
    GLFWwindow *window = glfwCreateWindow(width, height, title, NULL, NULL);
    if (window != NULL) {
        glfwMakeContextCurrent(window);
        if (glfwGetCurrentContext() == window) {
            platform_watch_display(end);
            return window;
        }
    }
    last_error(why, window == NULL ? "glfwCreateWindow" : "glfwMakeContextCurrent");
    glfwTerminate();
    return NULL;
}

static void *open_offscreen(char why[CONTEXT_WHY])
{
    return open_window(false, "", HIDDEN_SIZE, HIDDEN_SIZE, why);
}

static void *open_visible(const char *title, int width, int height, char why[CONTEXT_WHY])
{
    return open_window(true, title, width, height, why);
}

static gl_function find(const char *name)
{
    return glfwGetProcAddress(name);
}

static void close_window(void *state)
{
    glfwDestroyWindow(state);
    glfwTerminate();
}

const struct context_driver context_driver_glfw = {.backend = CONTEXT_GLFW,
                                                   .name = "glfw",
                                                   .open_offscreen = open_offscreen,
                                                   .open_window = open_visible,
                                                   .find = find,
                                                   .close = close_window};
