// form_inputs.h - what shaders that were written for other programs read and write: their inputs,
// outputs and uniforms. For form.c and export.c alone.
#ifndef FORM_INPUTS_H
#define FORM_INPUTS_H

#include <stdbool.h>
#include <stddef.h>

#include "shader/source.h"

// Judge what a whole file, or one in Shadertoy's form, declares outside of functions. The source's
// text is changed where that makes it run and changes no line, and its code stays: a location of an
// input is blanked, and of an only output; "flat in int" of CustomToggle or CustomInt becomes a
// uniform, which is 0 as they are.
// Returns false, reported with file and line: an input that is not one of the report's, or of
// another type; a uniform with the name of a Shadertoy input and another type; a texture that is
// read; of a whole file an output that is no colour, or several of which none is at location 0.
bool form_check_inputs(struct shader_source *source);

// Judge what a driver has linked. Warns, in one line, of each uniform or block that is read and
// that nothing sets: it is 0. Returns false, reported: a whole file that gives an output no value,
// or has none.
bool form_check_linked(const struct shader_source *source);

// True when a uniform of this name gets a value: Shadertoy's inputs, and of its channels those that
// the source's request names.
bool form_offers(const struct shader_source *source, const char *name);

// Say that something of Shadertoy's is not offered, or not without --channel; always false.
//   token  where the code mentions it
bool form_refuse_name(const struct shader_source *source, const struct glsl_token *token);

// The output of a whole file that is the picture: the one at location 0, or the first; NULL for
// none.
const struct glsl_token *form_output(const struct glsl *code);

// The first word in the brackets of mainImage, out or inout mostly; NULL where no bracket stands.
//   image  the word in the row of everything
const struct glsl_token *form_colour(const struct glsl_token *image);

// True when the code declares a uniform of this name itself, perhaps in a macro.
bool form_declares(const struct glsl *code, const char *name);

// Shadertoy's inputs, by number from 0 on: a declaration such as "vec3 iResolution"; NULL after the
// last one. name receives the name alone.
const char *form_toy_input(size_t number, const char **name);

// Overwrite a part of a source's text with blanks; line ends stay.
void form_blank(struct shader_source *source, int begin, int end);

#endif
