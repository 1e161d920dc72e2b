// parameter.h - for the tests of annotated uniforms: reads uniforms from texts instead of files,
// and checks values and reports.
#ifndef TESTS_PARAMETER_H
#define TESTS_PARAMETER_H

#include "shader/parameter.h"

// A source with this text, of at most 64 lines, in the file my.frag. The source is valid until the
// next call.
struct shader_source parameter_source(const char *text, enum shader_dialect dialect);

// The parameters of a text in the course's dialect. Fails the test if anything is reported. Free
// the result with parameters_free.
struct parameters parameter_text(const char *text);

// Fails the test unless the report is one line with both phrases.
void parameter_said(const char *said, const char *where, const char *why);

// Fails the test unless a number equals the expected number up to rounding.
void parameter_number(double value, double expected);

#endif
