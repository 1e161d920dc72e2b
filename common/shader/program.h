// program.h - compiles and links two texts, at once or in the driver's threads. It knows nothing of
// files and dialects, so that a part of the harness with a shader of its own needs only this.
#ifndef SHADER_PROGRAM_H
#define SHADER_PROGRAM_H

#include <stdbool.h>

#include "context/gl.h"

// Pass two texts to the driver, which may compile them in threads of its own. The next
// shader_link_texts of the same texts uses this program. Only a few programs can be in progress at
// a time; beyond that, the call only frees the texts.
//   vertex, fragment  texts on the heap, of which the call becomes the owner
void shader_begin_texts(const struct gl *gl, char *vertex, char *fragment);

// True if no program that was begun is still being compiled. Always true without
// KHR_parallel_shader_compile.
bool shader_ready(const struct gl *gl);

// Delete the programs that were begun but not used by shader_link.
void shader_forget(const struct gl *gl);

// The steps that produce a linked program.
enum shader_step { SHADER_COMPILE_VERTEX, SHADER_COMPILE_FRAGMENT, SHADER_LINK };

// Compile and link two texts unchanged.
//   step  receives the step that failed, or SHADER_LINK
//   log   receives the driver's log of the step that failed, or NULL if there is none; the caller
//         frees the log
// Returns the program, owned by the caller, or 0 without reporting an error.
GLuint shader_link_texts(const struct gl *gl, const char *vertex, const char *fragment,
                         enum shader_step *step, char **log);

#endif
