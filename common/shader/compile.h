// compile.h - turns a shader's text into a linked program, and reports each error with the author's
// file and line.
#ifndef SHADER_COMPILE_H
#define SHADER_COMPILE_H

#include "context/gl.h"
#include "shader/inputs.h"
#include "shader/program.h"
#include "shader/read.h"
#include "shader/source.h"

// The text to compile: the prelude, then the expanded text, translated if necessary.
// Returns memory that the caller frees.
char *shader_text(const struct shader_source *source, enum shader_view view);

// Compile and link a program.
//   vertex   the source of shaders/screen.vert
// Returns the program, owned by the caller, or 0 after reporting the errors, each with its file and
// line, and the source line below it.
GLuint shader_link(const struct gl *gl, const struct shader_source *vertex,
                   struct shader_source *fragment, enum shader_view view);

// Pass a program to the driver, which may compile it in threads of its own. The next shader_link of
// the same texts uses this program; until then, shader_ready tells whether shader_link would have
// to wait. Only a few programs can be in progress at a time; beyond that, the call does nothing.
void shader_begin(const struct gl *gl, const struct shader_source *vertex,
                  const struct shader_source *fragment, enum shader_view view);

// Rewrite a driver's log with the author's files and lines, for the text that shader_text returned
// for this source and view. A line of the log may begin as in Mesa, "0:12(3): ", as in NVIDIA's
// driver, "0(12) : ", or with "ERROR: 0:12: ". A message about a function that is called but never
// defined gets the file and line of the call. Each line becomes "FILE:LINE: error: message" with
// the source line below, which is shown only once for consecutive messages about it and is cut
// after 160 bytes. Repeated lines are dropped, and warnings too if the log has errors; a message
// that names no line of the source is left unchanged; after 20 messages, the rest are only counted.
// Returns memory that the caller frees.
char *shader_explain(const struct shader_source *source, enum shader_view view, const char *log);

#endif
