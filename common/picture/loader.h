// loader.h - the one path from a shader's file to what a renderer draws: at the start, after each
// save, and for both pictures of a comparison.
#ifndef LOADER_H
#define LOADER_H

#include <stdbool.h>

#include "picture/renderer.h"

// The shader of one picture. Set path, root and request; a loader of zeros is closed.
struct loader {
    const char *path;              // the shader's file; not owned
    const char *root;              // the project's folder; not owned
    struct shader_request request; // for each reading
    struct shader_source source;   // what was read, until the renderer takes it over
    struct parameters parameters;
    struct renderer renderer;
};

// Read the file and its parameters. What an earlier reading left is freed; the renderer is not
// touched.
// Returns false, reported.
bool loader_read(struct loader *loader);

// Let the driver begin to compile what was read; the renderer must be open. shader_ready tells when
// loader_compile no longer has to wait.
void loader_begin(const struct loader *loader);

// Compile what was read; the renderer must be open.
// Returns false, reported; then the renderer still draws the last good shader.
bool loader_compile(struct loader *loader);

// As loader_compile, but if the renderer already has this very shader, it is only given the
// parameters that were read, and its view is linked.
bool loader_update(struct loader *loader);

// Close the renderer too, in the context in which it was opened.
void loader_close(struct loader *loader);

#endif
