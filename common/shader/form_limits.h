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

#endif
