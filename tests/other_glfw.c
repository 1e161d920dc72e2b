// other_glfw.c - GLFW as it behaves on systems that the tests do not have. A shared library that is
// loaded before GLFW; the environment says what it does:
//
//   GLFW_HOLD=FILE  while the file exists, events are dealt with and no function returns: so
//                   Windows and macOS wait as long as a hand drags the window's edge; FILE.held
//                   appears meanwhile
//   GLFW_DENSE=1    a screen coordinate is two pixels wide and high, as on a Mac's Retina display
//   GLFW_LOG=FILE   receives the hints of glfwInitHint and glfwWindowHint, one a line
#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#define STRING(name) #name
// Declares the real function of a name.
#define REAL(name)                                                                                 \
    __typeof__(&(name)) real;                                                                      \
    find(STRING(name), &real)

static void find(const char *name, void *function)
{
    static void *library;
    if (library == NULL)
        library = dlopen("libglfw.so.3", RTLD_LAZY);
    void *found = library != NULL ? dlsym(library, name) : NULL;
    if (found == NULL) {
        fprintf(stderr, "other_glfw: %s: not found\n", name);
        abort();
    }
    memcpy(function, &found, sizeof found);
}

static double dense(void)
{
    return getenv("GLFW_DENSE") != NULL ? 2.0 : 1.0;
}

// ---- A hand on the window's edge ----

static void hold(void)
{
    const char *file = getenv("GLFW_HOLD");
    REAL(glfwWaitEventsTimeout);
    char held[4096];
    if (file == NULL || access(file, F_OK) != 0)
        return;
    snprintf(held, sizeof held, "%s.held", file);
    FILE *told = fopen(held, "w");
    while (told != NULL && access(file, F_OK) == 0)
        real(0.02);
    if (told != NULL)
        fclose(told);
}

void glfwPollEvents(void)
{
    REAL(glfwPollEvents);
    real();
    hold();
}

void glfwWaitEventsTimeout(double timeout)
{
    REAL(glfwWaitEventsTimeout);
    real(timeout);
    hold();
}

// ---- A dense display ----

static GLFWcursorposfun pointed;

GLFWwindow *glfwCreateWindow(int width, int height, const char *title, GLFWmonitor *monitor,
                             GLFWwindow *share)
{
    REAL(glfwCreateWindow);
    return real((int)dense() * width, (int)dense() * height, title, monitor, share);
}

void glfwGetWindowSize(GLFWwindow *window, int *width, int *height)
{
    REAL(glfwGetWindowSize);
    real(window, width, height);
    *width /= (int)dense();
    *height /= (int)dense();
}

void glfwGetCursorPos(GLFWwindow *window, double *x, double *y)
{
    REAL(glfwGetCursorPos);
    real(window, x, y);
    *x /= dense();
    *y /= dense();
}

static void point(GLFWwindow *window, double x, double y)
{
    pointed(window, x / dense(), y / dense());
}

GLFWcursorposfun glfwSetCursorPosCallback(GLFWwindow *window, GLFWcursorposfun callback)
{
    REAL(glfwSetCursorPosCallback);
    pointed = callback;
    return real(window, point);
}

// ---- What is asked for ----

static void log_hint(int hint, int value)
{
    const char *path = getenv("GLFW_LOG");
    FILE *file = path != NULL ? fopen(path, "a") : NULL;
    if (file == NULL)
        return;
    fprintf(file, "%#x %#x\n", (unsigned)hint, (unsigned)value);
    fclose(file);
}

void glfwInitHint(int hint, int value)
{
    REAL(glfwInitHint);
    log_hint(hint, value);
    real(hint, value);
}

void glfwWindowHint(int hint, int value)
{
    REAL(glfwWindowHint);
    log_hint(hint, value);
    real(hint, value);
}
