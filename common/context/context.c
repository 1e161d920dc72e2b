#include "context/context.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "context/guard.h"
#include "memory.h"
#include "platform.h"
#include "report.h"

// The built-in drivers in the order in which CONTEXT_ANY tries them for rendering without a window.
// Those that need no display come first.
static const struct context_driver *const drivers[] = {
#ifdef HAVE_EGL
    &context_driver_egl,
#endif
#ifdef HAVE_OSMESA
    &context_driver_osmesa,
#endif
#ifdef HAVE_GLFW
    &context_driver_glfw,
#endif
    NULL};

static const char *const names[] = {
    [CONTEXT_GLFW] = "glfw", [CONTEXT_EGL] = "egl", [CONTEXT_OSMESA] = "osmesa"};

bool context_backend_from_name(const char *name, enum context_backend *backend)
{
    for (int i = CONTEXT_GLFW; i <= CONTEXT_OSMESA; i++)
        if (strcmp(name, names[i]) == 0) {
            *backend = (enum context_backend)i;
            return true;
        }
    return false;
}

static void report_not_built_in(enum context_backend wanted)
{
    char *built;
    FILE *stream = memory_open(&built);
    for (int i = 0; drivers[i] != NULL; i++)
        fprintf(stream, "%s%s", i > 0 ? ", " : "", drivers[i]->name);
    memory_close(stream);
    report("%s: not built in, because make did not find its library; built in: %s: run make setup, "
           "then make",
           wanted == CONTEXT_ANY ? "OpenGL backend" : names[wanted],
           built[0] != '\0' ? built : "none");
    free(built);
}

bool gl_load(struct gl *gl, gl_function (*find)(const char *name))
{
    const char *missing = NULL;
// NOLINTBEGIN(bugprone-macro-parentheses)
#define GL_LOAD(type, name, arguments)                                                             \
    gl->name = (type(*) arguments)find("gl" #name);                                                \
    if (gl->name == NULL && missing == NULL)                                                       \
        missing = "gl" #name;
    GL_FUNCTIONS(GL_LOAD)
// NOLINTEND(bugprone-macro-parentheses)
#undef GL_LOAD
    return missing == NULL || report("OpenGL: %s: the driver lacks this function: update the "
                                     "driver or try another --backend%s",
                                     missing, memory_limit());
}

// The version is checked before the table of functions is loaded, so that the message about an old
// driver names its version, not the first function that it lacks.
static bool version_suffices(const struct context_driver *driver, char why[CONTEXT_WHY])
{
    const GLubyte *(*get)(GLenum) = (const GLubyte *(*)(GLenum))driver->find("glGetString");
    const char *version = get != NULL ? (const char *)get(GL_VERSION) : NULL;
    int major = 0, minor = 0;
    if (version != NULL && sscanf(version, GL_VERSION_READ, &major, &minor) == 2 &&
        (major > GL_NEEDED_MAJOR || (major == GL_NEEDED_MAJOR && minor >= GL_NEEDED_MINOR)))
        return true;
    snprintf(why, CONTEXT_WHY, "the driver offers OpenGL %s", version != NULL ? version : "?");
    return false;
}

// Take over the context that a driver has made current if its version suffices; otherwise close the
// context.
static bool take(struct context *context, const struct context_driver *driver, void *state,
                 char why[CONTEXT_WHY])
{
    *context = (struct context){.driver = driver, .state = state};
    if (version_suffices(driver, why))
        return true;
    context_close(context);
    return false;
}

static bool load(struct context *context)
{
    if (gl_load(&context->gl, context->driver->find))
        return true;
    context_close(context);
    return false;
}

// Report a crash while the driver is opened: if GALLIUM_DRIVER names a driver that Mesa does not
// have, Mesa may crash before it prints a message.
static void guard_driver(const char *backend)
{
    const char *name = getenv("GALLIUM_DRIVER");
    guard_process();
    guard_begin("%s: the graphics driver crashed when it was opened: %s%.200s", backend,
                name != NULL ? "unset GALLIUM_DRIVER, which is " : "try another --backend",
                name != NULL ? name : "");
}

bool context_open_offscreen(struct context *context, enum context_backend wanted)
{
    char reasons[4 * CONTEXT_WHY] = "";
    *context = (struct context){0};
    for (int i = 0; drivers[i] != NULL; i++) {
        const struct context_driver *driver = drivers[i];
        if (wanted != CONTEXT_ANY && wanted != driver->backend)
            continue;
        char why[CONTEXT_WHY] = "";
        guard_driver(driver->name);
        void *state = driver->open_offscreen(why);
        bool taken = state != NULL && take(context, driver, state, why);
        guard_end();
        if (taken)
            return load(context);
        memory_append(reasons, sizeof reasons, "%s%s: %s", reasons[0] != '\0' ? "; " : "",
                      driver->name, why);
    }
    if (reasons[0] == '\0')
        report_not_built_in(wanted);
    else
        report(
            "OpenGL %d.%d: no context: %s: update the graphics driver or %s%s", GL_NEEDED_MAJOR,
            GL_NEEDED_MINOR, reasons,
            wanted == CONTEXT_ANY
                ? "install Mesa (make setup), which draws in software with LIBGL_ALWAYS_SOFTWARE=1"
                : "try another --backend",
            memory_limit());
    return false;
}

bool context_open_window(struct context *context, enum context_backend wanted, const char *title,
                         int width, int height)
{
    *context = (struct context){0};
    if (wanted != CONTEXT_ANY && wanted != CONTEXT_GLFW)
        return report(
            "%s: cannot show a window: choose --backend glfw, or a file with --output FILE.png",
            names[wanted]);
    const struct context_driver *const *driver = drivers;
    while (*driver != NULL && (*driver)->open_window == NULL)
        driver++;
    if (*driver == NULL) {
        report_not_built_in(CONTEXT_GLFW);
        return false;
    }
    char why[CONTEXT_WHY] = "";
    platform_outlive_reader(); // a window shows more than it prints
    guard_driver((*driver)->name);
    void *state = (*driver)->open_window(title, width, height, why);
    bool taken = state != NULL && take(context, *driver, state, why);
    guard_end();
    if (taken) {
        context->window = state;
        return load(context);
    }
    return report("window with OpenGL %d.%d: cannot be opened: %s: try another display, Mesa's "
                  "software driver "
                  "(LIBGL_ALWAYS_SOFTWARE=1), or a file (--output FILE.png)%s",
                  GL_NEEDED_MAJOR, GL_NEEDED_MINOR, why, memory_limit());
}

void context_close(struct context *context)
{
    if (context->driver != NULL)
        context->driver->close(context->state);
    *context = (struct context){0};
}

void context_describe(const struct context *context, char *text, size_t size)
{
    const struct context_driver *driver = context->driver;
    const char *platform = driver->platform != NULL ? driver->platform(context->state) : NULL;
    const char *version = (const char *)context->gl.GetString(GL_VERSION);
    const char *renderer = (const char *)context->gl.GetString(GL_RENDERER);
    snprintf(text, size, "%s%s%s%s, OpenGL %s, %s", driver->name, platform != NULL ? " (" : "",
             platform != NULL ? platform : "", platform != NULL ? ")" : "",
             version != NULL ? version : "?", renderer != NULL ? renderer : "?");
}
