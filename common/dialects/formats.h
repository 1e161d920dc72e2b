// formats.h - files that are no picture's fragment shader in GLSL: how each is recognised, and what
// to do instead.
#ifndef DIALECTS_FORMATS_H
#define DIALECTS_FORMATS_H

#include "shader/source.h"

// Refuse a file of another format, in one line that names the format. Returns true, without a
// report, for any other file.
//   text  NULL if the file contains no text
bool formats_check(const char *file, const char *text);

// Refuse a file that sets gl_Position. Always returns false.
bool formats_refuse_vertex(const struct shader_source *source);

#endif
