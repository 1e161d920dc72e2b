// loader.h - loads a shader from its file into a renderer: at the start, after each save, and for
// both pictures of a comparison.
#ifndef LOADER_H
#define LOADER_H

#include <stdbool.h>

#include "picture/renderer.h"

// Files that replace those of the command line while the program runs.
struct loader_other {
    char path[4096];
    char picture[4][4200]; // for a channel, a file; NAME=FILE for the first sampler otherwise
    const char *textures[1], *channels[4];
};

// The shader of one picture. The caller sets path, root and request. A zero-initialised loader is
// closed.
struct loader {
    const char *path;              // the shader's file; not owned
    const char *root;              // the project's folder; not owned
    struct shader_request request; // used each time the file is read
    struct shader_source source;   // the shader that was read, until the renderer takes it over
    struct parameters parameters;
    struct renderer renderer;
    struct renderer next; // a shader that loader_link has linked; closed if there is none
    struct loader_other other;
};

// Read the file and its parameters, and free the results of an earlier call. The renderer does not
// change.
// Returns false after reporting the error.
bool loader_read(struct loader *loader);

// Read another shader from now on, without the pictures of the command line. Returns false after
// reporting the error if the path is too long.
bool loader_open(struct loader *loader, const char *path);

// Read another picture for the shader's first sampler or, in other dialects, for the first channel
// that has none, or else the first. Returns false after reporting the error if the shader reads no
// picture, or the path is too long.
bool loader_give(struct loader *loader, const char *path);

// Have the driver start compiling the shader that was read; the renderer must be open. shader_ready
// tells when loader_compile no longer has to wait.
void loader_begin(const struct loader *loader);

// Compile the shader that was read, and load it into the renderer, which must be open.
// Returns false after reporting the error; then the renderer still draws the last good shader.
bool loader_compile(struct loader *loader);

// Do the same in two steps, for shaders of which either all or none must be loaded; the parameters
// then have the values that were read. loader_link links a view, and changes nothing that is drawn.
// Returns false after reporting the error. Then nothing may be drawn until loader_take loads the
// shader. If the renderer already has exactly this shader, only the parameters change.
bool loader_link(struct loader *loader, enum shader_view view);
void loader_take(struct loader *loader);

// Free everything, and close the renderer. The context must be that in which the renderer was
// opened.
void loader_close(struct loader *loader);

#endif
