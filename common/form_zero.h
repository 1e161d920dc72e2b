// form_zero.h - variables that an author left without a value.
#ifndef FORM_ZERO_H
#define FORM_ZERO_H

// Copy a text and let every variable that is declared without a value begin at 0, as a browser has
// it: "float d, t = 1.0;" becomes "float d=float(0), t = 1.0;". Arrays and structures stay as they
// are. An output gets its 0 where main begins, before its branches. The colour of mainImage, an
// out, becomes an inout, which begins with what is handed to it.
//   text  with comments
//   code  the same without comments, and without what the preprocessor leaves out
// Lines keep their numbers. Returns memory that the caller frees, or NULL without memory, not
// reported.
char *form_zero(const char *text, const char *code);

#endif
