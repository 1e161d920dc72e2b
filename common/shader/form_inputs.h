// form_inputs.h - what shaders that were written for other programs read and write: their inputs,
// outputs and uniforms. For form.c and export.c alone.
#ifndef FORM_INPUTS_H
#define FORM_INPUTS_H

#include <stdbool.h>
#include <stddef.h>

#include "shader/shader.h"

// Judge what a whole file, or one in Shadertoy's form, declares outside of functions.
//   source  its text is changed where that makes it run and changes no line: a location of an input
//           is blanked, and of an only output; "flat in int" of CustomToggle or CustomInt becomes a
//           uniform, which is 0 as they are
//   code    its text without comments and without what the preprocessor leaves out
// Returns false, reported with file and line: an input that is not one of the report's, or of
// another type; a uniform with the name of a Shadertoy input and another type; a texture that is
// read; of a whole file an output that is no colour, or several of which none is at location 0.
bool form_check_inputs(struct shader_source *source, const char *code);

// Judge what a driver has linked. Warns, in one line, of each uniform that is read and that nothing
// sets: it is 0. Returns false, reported: a whole file that gives an output no value, or has none.
bool form_check_linked(const struct shader_source *source, const char *code);

// Where a place of the code comes from: the file and the line.
const struct shader_line *form_line_at(const struct shader_source *source, const char *code,
                                       const char *place);

// Say that something of Shadertoy's is not offered.
//   place  where the code mentions it
void form_refuse_name(const struct shader_source *source, const char *code, const char *place,
                      const char *name);

// True when the code declares a uniform of this name itself.
bool form_declares(const char *code, const char *name);

// Shadertoy's inputs, by number from 0 on: a declaration such as "vec3 iResolution"; NULL after the
// last one. name receives the name alone.
const char *form_toy_input(size_t number, const char **name);

#endif
