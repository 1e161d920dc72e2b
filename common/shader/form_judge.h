// form_judge.h - texts that no driver answers well, or that none refuses: for form.c alone.
#ifndef FORM_JUDGE_H
#define FORM_JUDGE_H

#include "shader/shader.h"

// Returns false, reported: a text of nothing but comments, or an array of more than 65536 elements,
// where the number stands in it, at which some drivers run for minutes. What hides behind constants
// and macros ends at the memory that guard_begin leaves to a driver.
bool form_check_sense(const struct shader_source *source);

// Judge how mainImage is declared, in Shadertoy's form: drivers may link a call to nothing. Returns
// false, reported, when no declaration has the two parameters of Shadertoy's; one that a macro or
// an #if may change is taken.
bool form_check_image(const struct shader_source *source);

// Say that mainImage has other parameters; always false.
bool form_refuse_image(const struct shader_source *source, const struct glsl_token *image);

#endif
