#include "lib/user.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "context/context.h"

// GLFW's functions have more parameters than are needed here. NOLINTBEGIN(misc-unused-parameters)
#pragma GCC diagnostic ignored "-Wunused-parameter"
#define GL_SCISSOR_BOX 0x0C10

struct user user;
struct GLFWwindow {
    struct context context; // without a display
    GLuint framebuffer, texture;
    int width, height;    // size of the texture, pixels
    double drawn, waited; // pixels drawn so far, and how many of these were waited for
};

struct GLFWmonitor {
    int left;
    GLFWvidmode mode;
};

static struct GLFWwindow the;
static struct GLFWmonitor monitors[] = {{0, {.width = 640, .height = 480, .refreshRate = 60}},
                                        {640, {.width = 800, .height = 600, .refreshRate = 60}}};
static GLFWmonitor *const monitor_list[] = {&monitors[0], &monitors[1]};

void user_reset(void)
{
    user = (struct user){.size = {320, 200}, .density = 1, .position = {40, 30}};
}

// ---- What the user does ----

void user_press(int key, int modifiers)
{
    user.calls.key(&the, key, 0, GLFW_PRESS, modifiers);
}

void user_release(int key)
{
    user.calls.key(&the, key, 0, GLFW_RELEASE, 0);
}

void user_key(int key, int modifiers)
{
    user_press(key, modifiers);
    user_release(key);
}

void user_repeat(int key, int modifiers)
{
    user.calls.key(&the, key, 0, GLFW_REPEAT, modifiers);
}

void user_type(const char *text)
{
    for (const char *c = text; *c != '\0'; c++)
        user.calls.letter(&the, (unsigned char)*c);
}

void user_point(double x, double y)
{
    user.pointer[0] = x;
    user.pointer[1] = y;
    user.calls.pointed(&the, x, y);
}

void user_button(int button, int action)
{
    user.calls.button(&the, button, action, 0);
}

void user_click(double x, double y, int button)
{
    user_point(x, y);
    user_button(button, GLFW_PRESS);
    user_button(button, GLFW_RELEASE);
}

void user_drag(double x, double y, double right, double down)
{
    user_point(x, y);
    user_button(GLFW_MOUSE_BUTTON_LEFT, GLFW_PRESS);
    user_point(x + 0.5 * right, y + 0.5 * down);
    user_point(x + right, y + down);
    user_button(GLFW_MOUSE_BUTTON_LEFT, GLFW_RELEASE);
}

void user_wheel(double notches)
{
    user.calls.wheel(&the, 0.0, notches);
}

void user_resize(int width, int height)
{
    user.size[0] = width;
    user.size[1] = height;
    user.calls.damage(&the);
}

void user_drop(const char *path)
{
    user.calls.drop(&the, 1, &path);
}

void user_focus(bool focused)
{
    user.unfocused = !focused;
    user.calls.focus(&the, focused);
}

void user_enter(bool entered)
{
    user.calls.entered(&the, entered);
}

// ---- What the window shows ----

// The window has no default framebuffer. Framebuffer 0 is replaced with a framebuffer whose texture
// has the window's size.
static void bind(GLenum target, GLuint framebuffer)
{
    const struct gl *gl = &the.context.gl;
    if (framebuffer != 0) {
        gl->BindFramebuffer(target, framebuffer);
        return;
    }
    int width = user.density * user.size[0], height = user.density * user.size[1];
    gl->BindFramebuffer(target, the.framebuffer);
    if (width == the.width && height == the.height)
        return;
    the.width = width;
    the.height = height;
    gl->DeleteTextures(1, &the.texture); // that of an earlier size
    gl->GenTextures(1, &the.texture);
    gl->BindTexture(GL_TEXTURE_2D, the.texture);
    gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, NULL);
    gl->BindTexture(GL_TEXTURE_2D, 0);
    gl->FramebufferTexture2D(target, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, the.texture, 0);
}

// Count the pixels of scissor boxes: pictures are drawn in tiles, and nothing else is drawn within
// a scissor box of many pixels.
static void draw(GLenum mode, GLint first, GLsizei count)
{
    GLboolean (*is_enabled)(GLenum) = (GLboolean(*)(GLenum))the.context.driver->find("glIsEnabled");
    GLint box[4];
    the.context.gl.GetIntegerv(GL_SCISSOR_BOX, box);
    if (is_enabled(GL_SCISSOR_TEST))
        the.drawn += (double)box[2] * box[3];
    the.context.gl.DrawArrays(mode, first, count);
}

static void finish(void)
{
    user.now += user.pixel_seconds * (the.drawn - the.waited);
    the.waited = the.drawn;
    the.context.gl.Finish();
}

static void link_program(GLuint program)
{
    user.links++;
    the.context.gl.LinkProgram(program);
}

// Count the objects of each kind that the program makes and deletes.
#define COUNT_OBJECTS(kind, Kind)                                                                  \
    static void make_##kind(GLsizei count, GLuint *names)                                          \
    {                                                                                              \
        user.objects += count;                                                                     \
        the.context.gl.Gen##Kind(count, names);                                                    \
    }                                                                                              \
    static void delete_##kind(GLsizei count, const GLuint *names)                                  \
    {                                                                                              \
        for (GLsizei i = 0; i < count; i++)                                                        \
            user.objects -= names[i] != 0;                                                         \
        the.context.gl.Delete##Kind(count, names);                                                 \
    }
COUNT_OBJECTS(textures, Textures)
COUNT_OBJECTS(framebuffers, Framebuffers)
COUNT_OBJECTS(buffers, Buffers)
COUNT_OBJECTS(vertex_arrays, VertexArrays)
#undef COUNT_OBJECTS

static GLuint create_program(void)
{
    user.objects++;
    return the.context.gl.CreateProgram();
}

static void delete_program(GLuint program)
{
    user.objects -= program != 0;
    the.context.gl.DeleteProgram(program);
}

static GLuint create_shader(GLenum kind)
{
    user.objects++;
    return the.context.gl.CreateShader(kind);
}

static void delete_shader(GLuint shader)
{
    user.objects -= shader != 0;
    the.context.gl.DeleteShader(shader);
}

void user_look(struct image *image)
{
    const struct gl *gl = &the.context.gl;
    float *values = malloc(4 * sizeof *values * (size_t)the.width * (size_t)the.height);
    if (values == NULL || !image_create(image, the.width, the.height))
        abort();
    gl->BindFramebuffer(GL_READ_FRAMEBUFFER, the.framebuffer);
    gl->ReadPixels(0, 0, the.width, the.height, GL_RGBA, GL_FLOAT, values);
    image_store(image, values, 0, the.height);
    free(values);
}

GLFWglproc glfwGetProcAddress(const char *name)
{
    static const struct {
        const char *name;
        GLFWglproc function;
    } replaced[] = {
        {"glBindFramebuffer", (GLFWglproc)bind},
        {"glDrawArrays", (GLFWglproc)draw},
        {"glFinish", (GLFWglproc)finish},
        {"glLinkProgram", (GLFWglproc)link_program},
        {"glCreateProgram", (GLFWglproc)create_program},
        {"glDeleteProgram", (GLFWglproc)delete_program},
        {"glCreateShader", (GLFWglproc)create_shader},
        {"glDeleteShader", (GLFWglproc)delete_shader},
        {"glGenTextures", (GLFWglproc)make_textures},
        {"glDeleteTextures", (GLFWglproc)delete_textures},
        {"glGenFramebuffers", (GLFWglproc)make_framebuffers},
        {"glDeleteFramebuffers", (GLFWglproc)delete_framebuffers},
        {"glGenBuffers", (GLFWglproc)make_buffers},
        {"glDeleteBuffers", (GLFWglproc)delete_buffers},
        {"glGenVertexArrays", (GLFWglproc)make_vertex_arrays},
        {"glDeleteVertexArrays", (GLFWglproc)delete_vertex_arrays},
    };
    for (size_t i = 0; i < sizeof replaced / sizeof *replaced; i++)
        if (strcmp(name, replaced[i].name) == 0)
            return replaced[i].function;
    return (GLFWglproc)the.context.driver->find(name);
}

// ---- The window ----

// In a test, these functions do little or nothing.
// clang-format off
int glfwInit(void) { return GLFW_TRUE; }
void glfwTerminate(void) { user.hints = 0; }
void glfwMakeContextCurrent(GLFWwindow *window) {}
void glfwDefaultWindowHints(void) {}
void glfwSwapInterval(int interval) {}
// clang-format on

GLFWwindow *glfwCreateWindow(int width, int height, const char *title, GLFWmonitor *monitor,
                             GLFWwindow *share)
{
    memset(&the, 0, sizeof the);
    if (!context_open_offscreen(&the.context, CONTEXT_EGL) &&
        !context_open_offscreen(&the.context, CONTEXT_OSMESA))
        return NULL;
    the.context.gl.GenFramebuffers(1, &the.framebuffer);
    user.size[0] = width;
    user.size[1] = height;
    user.open = true;
    snprintf(user.title, sizeof user.title, "%s", title);
    return &the;
}

void glfwDestroyWindow(GLFWwindow *window)
{
    context_close(&window->context);
    user.open = false;
}

GLFWwindow *glfwGetCurrentContext(void)
{
    return user.open ? &the : NULL;
}

int glfwGetError(const char **description)
{
    *description = "the test's window could not be opened";
    return GLFW_API_UNAVAILABLE;
}

void glfwWindowHint(int hint, int value)
{
    if (user.hints == USER_HINTS)
        abort();
    user.hint[user.hints][0] = hint;
    user.hint[user.hints++][1] = value;
}

void glfwInitHint(int hint, int value)
{
    glfwWindowHint(hint, value);
}

void glfwSwapBuffers(GLFWwindow *window)
{
    user.frames++;
    if (user.look != NULL)
        user.look();
}

void glfwGetWindowSize(GLFWwindow *window, int *width, int *height)
{
    *width = user.size[0];
    *height = user.size[1];
}

void glfwGetFramebufferSize(GLFWwindow *window, int *width, int *height)
{
    *width = user.density * user.size[0];
    *height = user.density * user.size[1];
}

int glfwGetWindowAttrib(GLFWwindow *window, int attribute)
{
    return attribute == GLFW_FOCUSED ? !user.unfocused : attribute == GLFW_ICONIFIED && user.hidden;
}

void glfwSetWindowTitle(GLFWwindow *window, const char *title)
{
    snprintf(user.title, sizeof user.title, "%s", title);
}

int glfwWindowShouldClose(GLFWwindow *window)
{
    return user.ended;
}

void glfwSetWindowShouldClose(GLFWwindow *window, int value)
{
    user.ended = value != GLFW_FALSE;
}

// ---- Monitors: two, side by side ----

GLFWmonitor **glfwGetMonitors(int *count)
{
    *count = 2;
    return (GLFWmonitor **)monitor_list;
}

GLFWmonitor *glfwGetPrimaryMonitor(void)
{
    return monitor_list[0];
}

GLFWmonitor *glfwGetWindowMonitor(GLFWwindow *window)
{
    return user.full ? monitor_list[0] : NULL;
}

const GLFWvidmode *glfwGetVideoMode(GLFWmonitor *monitor)
{
    return &monitor->mode;
}

void glfwGetMonitorPos(GLFWmonitor *monitor, int *x, int *y)
{
    *x = monitor->left;
    *y = 0;
}

void glfwGetWindowPos(GLFWwindow *window, int *x, int *y)
{
    *x = user.position[0];
    *y = user.position[1];
}

void glfwSetWindowMonitor(GLFWwindow *window, GLFWmonitor *monitor, int x, int y, int width,
                          int height, int rate)
{
    user.full = monitor != NULL;
    user.position[0] = x + (monitor != NULL ? monitor->left : 0);
    user.position[1] = y;
    user_resize(width, height);
}

// ---- Time and events ----

double glfwGetTime(void)
{
    return user.now;
}

void glfwPollEvents(void)
{
    user.waits++;
    if (user.wait != NULL)
        user.wait();
}

void glfwWaitEventsTimeout(double timeout)
{
    user.now += timeout;
    glfwPollEvents();
}

void *glfwGetWindowUserPointer(GLFWwindow *window)
{
    return user.calls.pointer;
}

void glfwSetWindowUserPointer(GLFWwindow *window, void *pointer)
{
    user.calls.pointer = pointer;
}

// glfwSet...Callback: each stores a function and returns the previous function.
#define KEEP(name, type, member)                                                                   \
    type glfwSet##name##Callback(GLFWwindow *window, type callback)                                \
    {                                                                                              \
        type before = user.calls.member;                                                           \
        user.calls.member = callback;                                                              \
        return before;                                                                             \
    }
KEEP(Key, GLFWkeyfun, key)
KEEP(Char, GLFWcharfun, letter)
KEEP(MouseButton, GLFWmousebuttonfun, button)
KEEP(CursorPos, GLFWcursorposfun, pointed)
KEEP(CursorEnter, GLFWcursorenterfun, entered)
KEEP(Scroll, GLFWscrollfun, wheel)
KEEP(WindowFocus, GLFWwindowfocusfun, focus)
KEEP(Drop, GLFWdropfun, drop)
KEEP(WindowRefresh, GLFWwindowrefreshfun, damage)
#undef KEEP

void glfwGetCursorPos(GLFWwindow *window, double *x, double *y)
{
    *x = user.pointer[0];
    *y = user.pointer[1];
}

void glfwSetInputMode(GLFWwindow *window, int mode, int value)
{
    user.captured = value == GLFW_CURSOR_DISABLED;
}

struct GLFWcursor {
    int shape;
};
GLFWcursor *glfwCreateStandardCursor(int shape)
{
    static struct GLFWcursor cursors[GLFW_VRESIZE_CURSOR - GLFW_ARROW_CURSOR + 1];
    struct GLFWcursor *cursor = &cursors[shape - GLFW_ARROW_CURSOR];
    cursor->shape = shape;
    return cursor;
}

void glfwSetCursor(GLFWwindow *window, GLFWcursor *cursor)
{
    user.cursor = cursor != NULL ? cursor->shape : 0;
}

const char *glfwGetClipboardString(GLFWwindow *window)
{
    return user.clipboard;
}

// The labels of keys on a French keyboard, listed with the American labels.
const char *glfwGetKeyName(int key, int scancode)
{
    static const char *const labels[][2] = {{"A", "q"}, {"Q", "a"}, {"W", "z"},
                                            {"Z", "w"}, {"M", ","}, {"2", "\xc3\xa9"}};
    for (size_t i = 0; i < sizeof labels / sizeof *labels; i++)
        if (labels[i][0][0] == key)
            return labels[i][1];
    return NULL;
}
// NOLINTEND(misc-unused-parameters)
