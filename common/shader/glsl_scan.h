// glsl_scan.h - where the tokens of a text begin and end. For glsl.c alone.
#ifndef GLSL_SCAN_H
#define GLSL_SCAN_H

#include "shader/glsl.h"

// Find the tokens and the names of a text; what counts is not told yet.
//   code  its text is there, and open is -1
// Returns false without memory, not reported.
bool glsl_scan(struct glsl *code);

#endif
