// unpack.h - files that contain more than a shader's text: JSON as Shadertoy and GLSL Sandbox
// export it, with the text of each pass, and ISF, whose first comment is JSON that describes the
// inputs.
#ifndef DIALECTS_UNPACK_H
#define DIALECTS_UNPACK_H

#include <stdbool.h>

#include "shader/source.h"

// The member unpack of struct dialects: part receives the common text, or the declarations of an
// ISF file's inputs as annotated uniforms, either of which may be empty, and the text of the
// picture. Any text that begins like JSON, as no shader does, is taken for an export.
bool unpack(struct shader_source *source, const char *text, char *part[2], bool *done);

#endif
