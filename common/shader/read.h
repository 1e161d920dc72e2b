// read.h - reads a shader file for the driver.
#ifndef SHADER_READ_H
#define SHADER_READ_H

#include <stdbool.h>

#include "shader/source.h"
#include "shader/view.h"

// Read a shader, determine its dialect and, if it is not the course's, translate it for the driver.
//   path, root, request  as for shader_expand
// Text that the preprocessor skips is ignored. A file in Shadertoy's dialect mentions mainImage and
// defines no main. Any other file with a #version is a whole shader, with its own main, and so is a
// file that defines main, includes nothing and does not mention gl_Position. All others, and the
// output of --print-shader for a course file, are in the course's dialect.
// Returns false after reporting the error with file and line. The errors are: anything that
// shader_expand refuses; nothing but comments; an array whose literal size exceeds 65536; a macro
// that expands to more than four million tokens; a #version above an include of main.glsl; and what
// the folder dialects/ refuses: a file of another format, a mainImage whose first parameter is not
// an output, gl_FragColor in a file that defines mainImage, and anything that it cannot translate.
// Free with shader_free.
bool shader_read_asked(struct shader_source *source, const char *path, const char *root,
                       const struct shader_request *request);

// Do the same as shader_read_asked, without a request.
bool shader_read(struct shader_source *source, const char *path, const char *root);

// True if the view can be shown. Returns false after reporting the reason: only shaders in the
// course's dialect record their rays, so any other shader has no view except the picture.
bool shader_has_view(const struct shader_source *source, enum shader_view view);

// The lines that precede the text for the driver: #version and the lines of view.h, or what
// translates another dialect. Returns memory that the caller frees.
char *shader_prelude(const struct shader_source *source, enum shader_view view);

#endif
