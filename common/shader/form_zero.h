// form_zero.h - variables that an author left without a value.
#ifndef FORM_ZERO_H
#define FORM_ZERO_H

// Copy a text and let every variable that is declared without a value begin at 0, as a browser has
// it: "float d, t = 1.0;" becomes "float d=float(0), t = 1.0;". Arrays and structures stay as they
// are, and so does what an #if divides. An output gets its 0 where main begins, before its
// branches; not one that is declared behind main or inside an #if, nor where a macro or another
// function has the name main too. The colour of mainImage, an out, becomes an inout, which begins
// with what is handed to it. What GLSL defines stays as it was: only what it leaves undefined
// becomes 0.
//   text  with comments
//   code  the same without comments, and without what the preprocessor leaves out
// Lines keep their numbers. Returns memory that the caller frees, or NULL without memory, not
// reported.
char *form_zero(const char *text, const char *code);

#endif
