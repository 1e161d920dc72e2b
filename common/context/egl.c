#include "context/context.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "memory.h"
#include "platform.h"

#define DEVICE_LIMIT 16

struct egl_state {
    EGLDisplay display;
    EGLContext context;
    EGLSurface surface; // EGL_NO_SURFACE if the driver needs none
    char platform[32];  // "surfaceless", "device 0", "default display"
};

// True if a list of words separated by spaces contains this word. NULL is an empty list.
static bool has_word(const char *list, const char *word)
{
    size_t length = strlen(word);
    for (const char *at = list; at != NULL && (at = strstr(at, word)) != NULL; at += length)
        if ((at == list || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0'))
            return true;
    return false;
}

static void release(struct egl_state *state)
{
    eglMakeCurrent(state->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (state->surface != EGL_NO_SURFACE)
        eglDestroySurface(state->display, state->surface);
    if (state->context != EGL_NO_CONTEXT)
        eglDestroyContext(state->display, state->context);
    eglTerminate(state->display);
    eglReleaseThread();
}

static const char *make_surface(struct egl_state *state, EGLConfig config)
{
    static const EGLint attributes[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
    state->surface = eglCreatePbufferSurface(state->display, config, attributes);
    return state->surface == EGL_NO_SURFACE ? "eglCreatePbufferSurface" : NULL;
}

// Create a 3.3 core context on an initialised display and make it current.
// Returns NULL, or the name of the step that failed.
static const char *make_current(struct egl_state *state)
{
    static const EGLint context_attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                                3,
                                                EGL_CONTEXT_MINOR_VERSION,
                                                3,
                                                EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                EGL_NONE};
    bool surfaceless =
        has_word(eglQueryString(state->display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context");
    const EGLint config_attributes[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE,
                                        surfaceless ? 0 : EGL_PBUFFER_BIT, EGL_NONE};
    EGLConfig config = NULL;
    EGLint count = 0;
    if (!eglBindAPI(EGL_OPENGL_API))
        return "eglBindAPI";
    if (!eglChooseConfig(state->display, config_attributes, &config, 1, &count) || count == 0)
        return "eglChooseConfig";
    const char *failed = surfaceless ? NULL : make_surface(state, config);
    if (failed != NULL)
        return failed;
    state->context = eglCreateContext(state->display, config, EGL_NO_CONTEXT, context_attributes);
    if (state->context == EGL_NO_CONTEXT)
        return "eglCreateContext for OpenGL 3.3 core";
    if (!eglMakeCurrent(state->display, state->surface, state->surface, state->context))
        return "eglMakeCurrent";
    return NULL;
}

static bool try_display(struct egl_state *state, char why[CONTEXT_WHY], EGLDisplay display,
                        const char *platform)
{
    *state = (struct egl_state){
        .display = display, .context = EGL_NO_CONTEXT, .surface = EGL_NO_SURFACE};
    snprintf(state->platform, sizeof state->platform, "%s", platform);
    const char *failed = display == EGL_NO_DISPLAY             ? "no such display"
                         : !eglInitialize(display, NULL, NULL) ? "eglInitialize"
                                                               : make_current(state);
    if (failed == NULL)
        return true;
    memory_append(why, CONTEXT_WHY, "%s%s: %s (0x%04X)", why[0] != '\0' ? ", " : "", platform,
                  failed, (unsigned)eglGetError());
    if (display != EGL_NO_DISPLAY)
        release(state);
    return false;
}

static bool try_devices(struct egl_state *state, char why[CONTEXT_WHY],
                        PFNEGLGETPLATFORMDISPLAYEXTPROC get_display)
{
    PFNEGLQUERYDEVICESEXTPROC query =
        (PFNEGLQUERYDEVICESEXTPROC)eglGetProcAddress("eglQueryDevicesEXT");
    EGLDeviceEXT devices[DEVICE_LIMIT];
    EGLint count = 0;
    if (query == NULL || !query(DEVICE_LIMIT, devices, &count))
        return false;
    for (EGLint i = 0; i < count; i++) {
        char platform[32];
        snprintf(platform, sizeof platform, "device %d", (int)i);
        if (try_display(state, why, get_display(EGL_PLATFORM_DEVICE_EXT, devices[i], NULL),
                        platform))
            return true;
    }
    return false;
}

// Try the platforms, beginning with those that need no display. Each failed step is added to why.
static bool try_platforms(struct egl_state *state, char why[CONTEXT_WHY])
{
    const char *extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    PFNEGLGETPLATFORMDISPLAYEXTPROC get_display =
        (PFNEGLGETPLATFORMDISPLAYEXTPROC)eglGetProcAddress("eglGetPlatformDisplayEXT");
    if (get_display != NULL && has_word(extensions, "EGL_MESA_platform_surfaceless") &&
        try_display(state, why,
                    get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL),
                    "surfaceless"))
        return true;
    if (get_display != NULL && has_word(extensions, "EGL_EXT_platform_device") &&
        try_devices(state, why, get_display))
        return true;
    return try_display(state, why, eglGetDisplay(EGL_DEFAULT_DISPLAY), "default display");
}

static void *open_offscreen(char why[CONTEXT_WHY])
{
    struct egl_state *state = memory_zeros(1, sizeof *state);
    // By default, Mesa prints messages about each platform that it cannot use.
    platform_set("EGL_LOG_LEVEL", "fatal", false);
    if (try_platforms(state, why))
        return state;
    free(state);
    return NULL;
}

static gl_function find(const char *name)
{
    return eglGetProcAddress(name);
}

static const char *platform_of(const void *state)
{
    const struct egl_state *own = state;
    return own->platform;
}

static void close_context(void *state)
{
    release(state);
    free(state);
}

const struct context_driver context_driver_egl = {.backend = CONTEXT_EGL,
                                                  .name = "egl",
                                                  .open_offscreen = open_offscreen,
                                                  .find = find,
                                                  .platform = platform_of,
                                                  .close = close_context};
