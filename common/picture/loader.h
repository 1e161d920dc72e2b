// loader.h - loads a shader from its file into a renderer: at the start, after each save, and for
// both pictures of a comparison.
#ifndef LOADER_H
#define LOADER_H

#include <stdbool.h>

#include "picture/renderer.h"

// The shader of one picture. The caller sets path, root and request. A loader of zeros is closed.
struct loader {
    const char *path;              // the shader's file; not owned
    const char *root;              // the project's folder; not owned
    struct shader_request request; // used each time the file is read
    struct shader_source source;   // what was read, until the renderer takes it over
    struct parameters parameters;
    struct renderer renderer;
};

// Read the file and its parameters. What an earlier call left there is freed; the renderer does not
// change.
// Returns false after reporting the error.
bool loader_read(struct loader *loader);

// Let the driver begin to compile the shader that was read; the renderer must be open. shader_ready
// tells when loader_compile no longer has to wait.
void loader_begin(const struct loader *loader);

// Compile the shader that was read, and load it into the renderer, which must be open.
// Returns false after reporting the error; then the renderer still draws the last good shader.
bool loader_compile(struct loader *loader);

// As loader_compile, but if the renderer already has exactly this shader, it only receives the
// parameters that were read, and its view is linked.
bool loader_update(struct loader *loader);

// Free everything, and close the renderer in the context in which it was opened.
void loader_close(struct loader *loader);

#endif
