// passes.h - a shader as Shadertoy exports it: JSON that contains the text of each pass.
#ifndef DIALECTS_PASSES_H
#define DIALECTS_PASSES_H

#include <stdbool.h>

#include "shader/source.h"

// The member unpack of struct dialects: part receives the common text, which may be empty, and that
// of the image pass. Any text that begins like JSON, as no shader does, is taken for an export.
bool passes_unpack(struct shader_source *source, const char *text, char *part[2], bool *done);

#endif
