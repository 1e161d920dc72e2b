// dialect.h - the dialect of a shader file, and explanations of its errors in the author's terms.
#ifndef SHADER_DIALECT_H
#define SHADER_DIALECT_H

#include <stdbool.h>

#include "shader/source.h"
#include "shader/view.h"

// Read a shader, determine its dialect and translate it for the driver.
//   path, root, request  as for shader_expand
// Text that the preprocessor skips is ignored. A file in Shadertoy's dialect mentions mainImage and
// defines no main. Any other file with a #version is a whole shader, with its own main, and so is a
// file that defines main, includes nothing and does not mention gl_Position. All others, and the
// output of --print-shader for a course file, are in the course's dialect.
// Returns false after reporting the error with file and line. The errors are: anything that
// shader_expand or translate refuses; a file of another kind; nothing but comments; an array whose
// literal size exceeds 65536; a macro of more than 4 million tokens; a #version above an include of
// main.glsl; a mainImage whose first parameter is not an output; and gl_FragColor in a file that
// defines mainImage. Free with shader_free.
bool shader_read_asked(struct shader_source *source, const char *path, const char *root,
                       const struct shader_request *request);

// Do the same as shader_read_asked, without a request.
bool shader_read(struct shader_source *source, const char *path, const char *root);

// True if the view can be shown. Returns false after reporting the reason: only shaders in the
// course's dialect record their rays, so any other shader has no view except the picture.
bool shader_has_view(const struct shader_source *source, enum shader_view view);

// The lines that precede the text for the driver: #version and the lines of view.h, or the prelude
// of translate.
// Returns memory that the caller frees.
char *dialect_prelude(const struct shader_source *source, enum shader_view view);

// Report in the author's terms why a shader cannot run, if the driver's log does not help: for
// example, the shader needs something that is not supported, has no main, or is not a fragment
// shader.
//   log      the driver's log
//   linking  the shader has compiled but did not link
// Returns false without reporting an error if no such cause is found.
bool dialect_refuses(const struct shader_source *source, const char *log, bool linking);

// Check a shader that a driver has linked. For each uniform or block that is read but never set,
// print a warning of one line; the first warning is kept in the source. Returns false after
// reporting the error if a whole shader has no output, or gives it no value.
bool dialect_accepts(struct shader_source *source);

#endif
