// glfw.c - the part of GLFW that the harness uses, implemented on the canvas of a page, which is
// the only window. Input that the page's script reports (canvas.h) is passed to the harness's
// callbacks.
//
// No function here waits, because the page owns the loop. The clock is stopped while the page or
// the canvas is hidden.
#include "browser/canvas.h"

#include <stdio.h>
#include <string.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "browser/page.h"
#include "context/gl.h"
#include "platform.h"

// Emscripten's library exports each OpenGL function by name, so that a declaration is enough.
#define WEB_DECLARE(type, name, arguments) type gl##name arguments;
GL_FUNCTIONS(WEB_DECLARE)
#undef WEB_DECLARE

struct GLFWwindow {
    void *user;
    GLFWkeyfun on_key;
    GLFWcharfun on_type;
    GLFWmousebuttonfun on_button;
    GLFWcursorposfun on_pointer;
    GLFWcursorenterfun on_enter;
    GLFWscrollfun on_wheel;
    GLFWwindowfocusfun on_focus;
    GLFWdropfun on_drop; // never called, because the page receives the files
    GLFWwindowrefreshfun on_damage;
    double pointer[2];
    bool focused, ended;
};

struct GLFWcursor {
    int shape;
};

static struct {
    struct GLFWwindow window;
    bool open, hidden, cleared, threads;
    int size[2], pixels[2]; // of the canvas in CSS pixels; of its drawing buffer in pixels
    double hidden_at, away; // seconds: start of the last hidden period; total of the earlier ones
    const char *why;        // reason for the last failure
} web = {.size = {960, 540}, .pixels = {960, 540}, .why = ""};

// ---- The functions of OpenGL ----

// WebGL's finish only flushes. Reading a pixel waits until everything before it has been drawn.
static void finish(void)
{
    GLint target = 0;
    float pixel[4];
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &target);
    glReadPixels(0, 0, 1, 1, GL_RGBA, target == 0 ? GL_UNSIGNED_BYTE : GL_FLOAT, pixel);
}

// A browser clears the canvas before the first draw call of a frame, but a blit does not count as
// one. If the overlay's draw call came first, the picture that was blitted before it would be lost,
// so the canvas is cleared before the blit.
static GLint drawn(void)
{
    GLint target = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
    return target;
}

static void draw(GLenum mode, GLint first, GLsizei count)
{
    web.cleared |= drawn() == 0;
    glDrawArrays(mode, first, count);
}

static void blit(GLint left, GLint bottom, GLint right, GLint top, GLint to_left, GLint to_bottom,
                 GLint to_right, GLint to_top, GLbitfield mask, GLenum filter)
{
    if (drawn() == 0 &&
        page_draws_copy((const int[]){left, bottom, right, top},
                        (const int[]){to_left, to_bottom, to_right, to_top}, (int)filter) != 0) {
        web.cleared = true;
        return;
    }
    if (drawn() == 0 && !web.cleared) {
        glClear(GL_COLOR_BUFFER_BIT);
        web.cleared = true;
    }
    glBlitFramebuffer(left, bottom, right, top, to_left, to_bottom, to_right, to_top, mask, filter);
}

// Without KHR_parallel_shader_compile, the browser would never report that a program is compiled.
static void get_program(GLuint program, GLenum name, GLint *value)
{
    if (name == GL_COMPLETION_STATUS_KHR && !web.threads)
        *value = GL_TRUE;
    else
        glGetProgramiv(program, name, value);
}

GLFWglproc glfwGetProcAddress(const char *name)
{
    static const struct {
        const char *name;
        GLFWglproc function;
    } ours[] = {{"glFinish", (GLFWglproc)finish},
                {"glBlitFramebuffer", (GLFWglproc)blit},
                {"glDrawArrays", (GLFWglproc)draw},
                {"glGetProgramiv", (GLFWglproc)get_program}};
    for (size_t i = 0; i < sizeof ours / sizeof *ours; i++)
        if (strcmp(name, ours[i].name) == 0)
            return ours[i].function;
#define WEB_FIND(type, function, arguments)                                                        \
    if (strcmp(name, "gl" #function) == 0)                                                         \
        return (GLFWglproc)gl##function;
    GL_FUNCTIONS(WEB_FIND)
#undef WEB_FIND
    return NULL;
}

// ---- The window ----

GLFWwindow *glfwCreateWindow(int width, int height, const char *title, GLFWmonitor *monitor,
                             GLFWwindow *share)
{
    static const char *const reasons[] = {
        [PAGE_NO_WEBGL] = "this browser has no WebGL 2",
        [PAGE_NO_FLOATS] =
            "this device cannot draw into float targets (EXT_color_buffer_half_float)"};
    (void)title, (void)monitor, (void)share;
    page_size(width, height);
    int found = page_open_context();
    web.open = found == PAGE_CONTEXT;
    if (!web.open) {
        web.why = reasons[found];
        return NULL;
    }
    web.window = (struct GLFWwindow){.focused = web.window.focused};
    web.threads = page_has_threads() != 0;
    return &web.window;
}

void glfwMakeContextCurrent(GLFWwindow *window)
{
    (void)window; // the context is always current
}

GLFWwindow *glfwGetCurrentContext(void)
{
    return web.open ? &web.window : NULL;
}

void glfwDestroyWindow(GLFWwindow *window)
{
    (void)window;
    page_capture(0);
    page_close_context();
    web.window = (struct GLFWwindow){.focused = web.window.focused}; // forgets the callbacks
    web.open = false;
}

int glfwGetError(const char **description)
{
    *description = web.why;
    return GLFW_API_UNAVAILABLE;
}

int glfwInit(void)
{
    return GLFW_TRUE;
}

void glfwTerminate(void)
{
}

void glfwDefaultWindowHints(void)
{
}

void glfwInitHint(int hint, int value)
{
    (void)hint, (void)value;
}

void glfwWindowHint(int hint, int value)
{
    (void)hint, (void)value;
}

void glfwSwapInterval(int interval)
{
    (void)interval;
}

// The browser shows the frame when this iteration of the page's loop ends.
void glfwSwapBuffers(GLFWwindow *window)
{
    (void)window;
    web.cleared = false;
}

void glfwGetWindowSize(GLFWwindow *window, int *width, int *height)
{
    (void)window;
    *width = web.size[0];
    *height = web.size[1];
}

void glfwGetFramebufferSize(GLFWwindow *window, int *width, int *height)
{
    (void)window;
    *width = web.pixels[0];
    *height = web.pixels[1];
}

int glfwGetWindowAttrib(GLFWwindow *window, int attribute)
{
    return attribute == GLFW_FOCUSED     ? window->focused
           : attribute == GLFW_ICONIFIED ? web.hidden
                                         : GLFW_FALSE;
}

void glfwSetWindowTitle(GLFWwindow *window, const char *title)
{
    (void)window;
    page_title(title);
}

int glfwWindowShouldClose(GLFWwindow *window)
{
    return window->ended;
}

void glfwSetWindowShouldClose(GLFWwindow *window, int value)
{
    window->ended = value != GLFW_FALSE;
}

// ---- Time ----

double glfwGetTime(void)
{
    return (web.hidden ? web.hidden_at : platform_seconds()) - web.away;
}

void live_hide(int hidden)
{
    double now = platform_seconds();
    if (hidden && !web.hidden)
        web.hidden_at = now;
    if (!hidden && web.hidden)
        web.away += now - web.hidden_at;
    web.hidden = hidden != 0;
}

void glfwPollEvents(void)
{
}

void glfwWaitEventsTimeout(double timeout)
{
    (void)timeout;
}

// ---- Input ----

void *glfwGetWindowUserPointer(GLFWwindow *window)
{
    return window->user;
}

void glfwSetWindowUserPointer(GLFWwindow *window, void *pointer)
{
    window->user = pointer;
}

// Each glfwSet...Callback sets a function and returns the previous one.
#define WEB_CALLBACK(name, type, member)                                                           \
    type glfwSet##name##Callback(GLFWwindow *window, type callback)                                \
    {                                                                                              \
        type before = window->member;                                                              \
        window->member = callback;                                                                 \
        return before;                                                                             \
    }
WEB_CALLBACK(Key, GLFWkeyfun, on_key)
WEB_CALLBACK(Char, GLFWcharfun, on_type)
WEB_CALLBACK(MouseButton, GLFWmousebuttonfun, on_button)
WEB_CALLBACK(CursorPos, GLFWcursorposfun, on_pointer)
WEB_CALLBACK(CursorEnter, GLFWcursorenterfun, on_enter)
WEB_CALLBACK(Scroll, GLFWscrollfun, on_wheel)
WEB_CALLBACK(WindowFocus, GLFWwindowfocusfun, on_focus)
WEB_CALLBACK(Drop, GLFWdropfun, on_drop)
WEB_CALLBACK(WindowRefresh, GLFWwindowrefreshfun, on_damage)
#undef WEB_CALLBACK

void glfwGetCursorPos(GLFWwindow *window, double *x, double *y)
{
    *x = window->pointer[0];
    *y = window->pointer[1];
}

void glfwSetInputMode(GLFWwindow *window, int mode, int value)
{
    (void)window;
    if (mode == GLFW_CURSOR)
        page_capture(value == GLFW_CURSOR_DISABLED);
}

// The shapes from the arrow to the vertical resize arrow are six consecutive constants of GLFW.
GLFWcursor *glfwCreateStandardCursor(int shape)
{
    static struct GLFWcursor cursors[GLFW_VRESIZE_CURSOR - GLFW_ARROW_CURSOR + 1];
    if (shape < GLFW_ARROW_CURSOR || shape > GLFW_VRESIZE_CURSOR)
        return NULL;
    cursors[shape - GLFW_ARROW_CURSOR].shape = shape;
    return &cursors[shape - GLFW_ARROW_CURSOR];
}

void glfwSetCursor(GLFWwindow *window, GLFWcursor *cursor)
{
    (void)window;
    page_cursor(cursor != NULL ? cursor->shape : 0);
}

// Return a key's label on the user's keyboard, or NULL if the browser does not provide it.
const char *glfwGetKeyName(int key, int scancode)
{
    static char label[16];
    (void)scancode;
    page_key_label(key, label, sizeof label);
    return label[0] != '\0' ? label : NULL;
}

// Only the page's script may read the clipboard, and only asynchronously.
const char *glfwGetClipboardString(GLFWwindow *window)
{
    (void)window;
    return NULL;
}

void live_size(int width, int height, int across, int down)
{
    web.size[0] = width;
    web.size[1] = height;
    web.pixels[0] = across;
    web.pixels[1] = down;
    if (web.window.on_damage != NULL)
        web.window.on_damage(&web.window); // a resized canvas is empty
}

void live_key(int key, int action, int modifiers)
{
    if (web.window.on_key != NULL)
        web.window.on_key(&web.window, key, 0, action, modifiers);
}

void live_type(unsigned code)
{
    if (web.window.on_type != NULL)
        web.window.on_type(&web.window, code);
}

void live_pointer(double x, double y)
{
    web.window.pointer[0] = x;
    web.window.pointer[1] = y;
    if (web.window.on_pointer != NULL)
        web.window.on_pointer(&web.window, x, y);
}

void live_button(int button, int pressed, int modifiers)
{
    if (web.window.on_button != NULL)
        web.window.on_button(&web.window, button, pressed ? GLFW_PRESS : GLFW_RELEASE, modifiers);
}

void live_wheel(double notches)
{
    if (web.window.on_wheel != NULL)
        web.window.on_wheel(&web.window, 0.0, notches);
}

void live_focus(int focused)
{
    web.window.focused = focused != 0;
    if (web.window.on_focus != NULL)
        web.window.on_focus(&web.window, focused);
}

// ---- What a page does itself ----

bool platform_edit(const char *path)
{
    (void)path;
    return false;
}
