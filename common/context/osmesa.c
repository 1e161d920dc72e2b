#include "context/driver.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// GL/osmesa.h includes GL/gl.h, which clashes with GL/glcorearb.h; and the library is opened with
// dlopen, so that a program still starts where it is missing. So what we need of it stands here.
#define OSMESA_FORMAT                0x22
#define OSMESA_DEPTH_BITS            0x30
#define OSMESA_PROFILE               0x33
#define OSMESA_CORE_PROFILE          0x34
#define OSMESA_CONTEXT_MAJOR_VERSION 0x36
#define OSMESA_CONTEXT_MINOR_VERSION 0x37

typedef struct osmesa_context *osmesa_handle;

#define BUFFER_SIDE 16 // pixels; what is drawn goes into targets of our own

// The library. It stays open until the program ends: Mesa's threads would lose their code.
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
    unsigned char buffer[BUFFER_SIDE * BUFFER_SIDE * 4]; // Mesa keeps a pointer to it
};

static bool open_library(char *why, size_t why_size)
{
    static const char *const names[] = {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"};
    for (size_t i = 0; osmesa.library == NULL && i < sizeof names / sizeof *names; i++)
        osmesa.library = dlopen(names[i], RTLD_NOW | RTLD_LOCAL);
    if (osmesa.library == NULL) {
        const char *reason = dlerror();
        snprintf(why, why_size, "libOSMesa cannot be loaded: %s", reason != NULL ? reason : "?");
    }
    return osmesa.library != NULL;
}

// Look one function up. ISO C has no conversion from void * to a function's pointer; POSIX promises
// that both look alike, hence the copy.
static bool look_up(const char *name, void *function, char *why, size_t why_size)
{
    void *symbol = dlsym(osmesa.library, name);
    memcpy(function, &symbol, sizeof symbol);
    if (symbol == NULL)
        snprintf(why, why_size, "%s is missing in libOSMesa: it is too old", name);
    return symbol != NULL;
}

static bool load(char *why, size_t why_size)
{
    return open_library(why, why_size) &&
           look_up("OSMesaCreateContextAttribs", &osmesa.create, why, why_size) &&
           look_up("OSMesaMakeCurrent", &osmesa.make_current, why, why_size) &&
           look_up("OSMesaDestroyContext", &osmesa.destroy, why, why_size) &&
           look_up("OSMesaGetProcAddress", &osmesa.find, why, why_size);
}

static void close_context(void *state)
{
    struct osmesa_state *own = state;
    osmesa.make_current(NULL, NULL, 0, 0, 0);
    osmesa.destroy(own->handle);
    free(own);
}

static void *open_offscreen(char *why, size_t why_size)
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
    if (!load(why, why_size))
        return NULL;
    struct osmesa_state *state = calloc(1, sizeof *state);
    if (state == NULL) {
        snprintf(why, why_size, "not enough memory");
        return NULL;
    }
    state->handle = osmesa.create(attributes, NULL);
    if (state->handle == NULL) {
        snprintf(why, why_size, "OSMesaCreateContextAttribs refuses OpenGL 3.3 core");
        free(state);
        return NULL;
    }
    if (!osmesa.make_current(state->handle, state->buffer, GL_UNSIGNED_BYTE, BUFFER_SIDE,
                             BUFFER_SIDE)) {
        snprintf(why, why_size, "OSMesaMakeCurrent failed");
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
