// form_limits.h - texts that no driver answers well, or that none refuses: for form.c alone.
#ifndef FORM_LIMITS_H
#define FORM_LIMITS_H

#include "shader/shader.h"

// Refuse what makes drivers run for minutes or out of memory, in any form: arrays of more than
// 65536 elements, also where constants and macros say how many, and those of structures of arrays;
// macros that grow by more than a million words. A number that cannot be told for sure is left
// alone. Returns false, reported with file and line: one of these, or a text of nothing but
// comments.
bool form_check_limits(const struct shader_source *source);

// Judge how mainImage is declared, in Shadertoy's form: drivers may link a call to nothing. Returns
// false, reported, when no declaration has the two parameters of Shadertoy's; one that a macro or
// an #if may change is taken.
bool form_check_image(const struct shader_source *source);

// Say that mainImage has other parameters; always false.
bool form_refuse_image(const struct shader_source *source, const struct glsl_token *image);

#endif
