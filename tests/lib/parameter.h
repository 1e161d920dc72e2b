// parameter.h - for the tests of annotated uniforms: texts that are no files, and what is
// said of them.
#ifndef TESTS_PARAMETER_H
#define TESTS_PARAMETER_H

#include "shader/parameter.h"

// A text as the file my.frag, at most 64 lines; valid until the next call.
struct shader_source parameter_source(const char *text, enum shader_dialect dialect);

// The parameters of a text of the course's form; fails the test where something is said of it. Free
// with parameters_free.
struct parameters parameter_text(const char *text);

// Fails the test unless what was said is one line with both phrases.
void parameter_said(const char *said, const char *where, const char *why);

// Fails the test unless a number is the expected one, but for rounding.
void parameter_number(double value, double expected);

#endif
