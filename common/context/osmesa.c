#include "context/context.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"

// The library is opened with dlopen, so that a program starts even if the library is missing. These
// constants are copied from GL/osmesa.h, which would include GL/gl.h.
#define OSMESA_FORMAT                0x22
#define OSMESA_DEPTH_BITS            0x30
#define OSMESA_PROFILE               0x33
#define OSMESA_CORE_PROFILE          0x34
#define OSMESA_CONTEXT_MAJOR_VERSION 0x36
#define OSMESA_CONTEXT_MINOR_VERSION 0x37

typedef struct osmesa_context *osmesa_handle;

#define BUFFER_SIDE 16 // pixels; pictures are drawn into off-screen targets

// The library. It stays open until the program ends, because Mesa's threads run its code.
static struct {
    void *library;
    osmesa_handle (*create)(const int *attributes, osmesa_handle shared);
    GLboolean (*make_current)(osmesa_handle, void *buffer, GLenum type, GLsizei width,
                              GLsizei height);
    void (*destroy)(osmesa_handle);
    gl_function (*find)(const char *name);
} osmesa;

struct osmesa_state {
    osmesa_handle handle;
    unsigned char buffer[BUFFER_SIDE * BUFFER_SIDE * 4]; // Mesa keeps a pointer to this buffer
};

static bool open_library(char why[CONTEXT_WHY])
{
    static const char *const names[] = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
    for (size_t i = 0; osmesa.library == NULL && i < sizeof names / sizeof *names; i++)
        osmesa.library = dlopen(names[i], RTLD_NOW | RTLD_LOCAL);
    if (osmesa.library == NULL) {
        const char *reason = dlerror();
        snprintf(why, CONTEXT_WHY, "libOSMesa cannot be loaded: %s", reason != NULL ? reason : "?");
    }
    return osmesa.library != NULL;
}

// Look up a function. ISO C has no conversion from void * to a function pointer, but POSIX
// guarantees that both have the same representation, so the bytes are copied.
static bool look_up(const char *name, void *function, char why[CONTEXT_WHY])
{
    void *symbol = dlsym(osmesa.library, name);
    memcpy(function, &symbol, sizeof symbol);
    if (symbol == NULL)
        snprintf(why, CONTEXT_WHY, "libOSMesa is too old: it lacks %s", name);
    return symbol != NULL;
}

static bool load(char why[CONTEXT_WHY])
{
    return open_library(why) && look_up("OSMesaCreateContextAttribs", &osmesa.create, why) &&
           look_up("OSMesaMakeCurrent", &osmesa.make_current, why) &&
           look_up("OSMesaDestroyContext", &osmesa.destroy, why) &&
           look_up("OSMesaGetProcAddress", &osmesa.find, why);
}

static void close_context(void *state)
{
    struct osmesa_state *own = state;
    osmesa.make_current(NULL, NULL, 0, 0, 0);
    osmesa.destroy(own->handle);
    free(own);
}

static void *open_offscreen(char why[CONTEXT_WHY])
{
    static const int attributes[] = {OSMESA_FORMAT,
                                     GL_RGBA,
                                     OSMESA_DEPTH_BITS,
                                     0,
                                     OSMESA_PROFILE,
                                     OSMESA_CORE_PROFILE,
                                     OSMESA_CONTEXT_MAJOR_VERSION,
                                     3,
                                     OSMESA_CONTEXT_MINOR_VERSION,
                                     3,
                                     0};
    if (!load(why))
        return NULL;
    struct osmesa_state *state = memory_zeros(1, sizeof *state);
    state->handle = osmesa.create(attributes, NULL);
    if (state->handle == NULL) {
        snprintf(why, CONTEXT_WHY, "OSMesaCreateContextAttribs cannot create OpenGL 3.3 core");
        free(state);
        return NULL;
    }
    if (!osmesa.make_current(state->handle, state->buffer, GL_UNSIGNED_BYTE, BUFFER_SIDE,
                             BUFFER_SIDE)) {
        snprintf(why, CONTEXT_WHY, "OSMesaMakeCurrent failed");
        close_context(state);
        return NULL;
    }
    return state;
}

static gl_function find(const char *name)
{
    return osmesa.find(name);
}

const struct context_driver context_driver_osmesa = {.backend = CONTEXT_OSMESA,
                                                     .name = "osmesa",
                                                     .open_offscreen = open_offscreen,
                                                     .find = find,
                                                     .close = close_context};
