// tool_inputs.h - the table of the names that other tools give to a shader's inputs, followed by
// what is not supported, and why.
#ifndef DIALECTS_TOOL_INPUTS_H
#define DIALECTS_TOOL_INPUTS_H

#include "shader/inputs.h"
#include "shader/source.h"

// The input with a name, or NULL if there is none, of the course or of another tool.
const struct input *tool_inputs_find(const char *name);

// The input at an index, from 0, or NULL after the last: first those of Shadertoy, then the others
// of the course, then those of other tools.
const struct input *tool_inputs_row(int index);

// True for an input of Shadertoy.
bool tool_inputs_is_shadertoy(const struct input *input);

// True for an input that Shadertoy has with exactly the type that the source declares.
bool tool_inputs_is_own(const struct shader_input *in);

// The type of the sampler for a channel: sampler2D, unless no picture is given and the file says
// that the channel is a cube map or a volume, or reads it at a vec3. NULL for the buffer of another
// pass.
const char *tool_inputs_sampler(const struct shader_source *source, const struct input *input);

// True for the buffer of another pass: every picture would be wrong without it.
bool tool_inputs_lacks(const struct shader_source *source, const struct input *input);

// True if a picture has the size that an INPUT_CHANNEL_SIZE tells.
bool tool_inputs_has_size(const struct shader_source *source, const struct input *input);

// Why a sampler that has no picture is black, for a warning. The caller frees the text.
char *tool_inputs_why_black(const struct shader_source *source,
                            const struct shader_sampler *sampler);

// Report why an input is not supported. Always returns false.
//   line  of the source's text, from 0
bool tool_inputs_refuse(const struct shader_source *source, const struct input *input, int line);

#endif
