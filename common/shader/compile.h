// compile.h - from a shader's text to a linked program, each error in the author's own file and
// line.
#ifndef SHADER_COMPILE_H
#define SHADER_COMPILE_H

#include "context/gl.h"
#include "shader/form.h"
#include "shader/source.h"

// The text that is compiled: what form.h puts before the expanded text, and what it makes of this.
// Returns memory that the caller frees.
char *shader_text(const struct shader_source *source, enum shader_view view);

// Compile and link.
//   vertex   shaders/screen.vert
// Returns the program, owned by the caller, or 0 with every error reported by file and line, the
// source line beneath.
GLuint shader_link(const struct gl *gl, const struct shader_source *vertex,
                   const struct shader_source *fragment, enum shader_view view);

// The steps to a program.
enum shader_step { SHADER_COMPILE_VERTEX, SHADER_COMPILE_FRAGMENT, SHADER_LINK };

// Compile and link two texts as they are.
//   step  receives the last step that was begun
//   log   receives what the driver wrote of one that failed, which the caller frees; or NULL
// Returns the program, owned by the caller, or 0, not reported.
GLuint shader_link_texts(const struct gl *gl, const char *vertex, const char *fragment,
                         enum shader_step *step, char **log);

// Rewrite a driver's log in the author's own files and lines, for the text that shader_text made
// for this source and view. Understands Mesa "0:12(3): ", NVIDIA "0(12) : " and "ERROR: 0:12: ". A
// line that names a function which links to nothing gets the file and line of the call.
// Each line becomes "FILE:LINE: error: message" with the source line beneath, shown once where
// several stand together and cut after 160 letters. Warnings are left out of a log that holds
// errors; a line that belongs to no line of the source is kept as it is; of more than 20 lines the
// rest is counted. Returns memory that the caller frees.
char *shader_explain(const struct shader_source *source, enum shader_view view, const char *log);

#endif
