// translate.h - a shader in another tool's dialect, in the words of this context or of Shadertoy.
//
// Declarations outside of functions are checked and rewritten. An input becomes a uniform or, if it
// is a position, an input from the vertex shader; a uniform with a value that no slider changes
// becomes a variable; locations and interpolation go. gl_FragColor, texture2D, varying and other
// words of old versions get their present names. Precisions become highp, because WebGL links an
// input only in the precision of the vertex shader. gl_FragCoord becomes the pixel of the whole
// picture, because the renderer draws parts and samples. Lines keep their numbers.
#ifndef SHADER_TRANSLATE_H
#define SHADER_TRANSLATE_H

#include "shader/declared.h"
#include "shader/source.h"

enum translate_target { TRANSLATE_DRIVER, TRANSLATE_SHADERTOY };

// Translate a source and gather its inputs.
//   prelude  receives the lines before the text; for Shadertoy, the inputs that it lacks, or NULL
//            if the file's own mainImage can be called
//   body     receives the text; the caller frees both
// Returns false, reported with file and line: an unknown input; an input or a uniform of a type
// that cannot be set; a texture that is read and has no picture; an output that is no colour, or
// several and none at location 0; for Shadertoy, anything else that WebGL lacks.
bool translate(struct shader_source *source, enum translate_target target, char **prelude,
               char **body);

// Variables without a value begin as 0, as in browsers: "float d, t = 1.0;" becomes "float
// d=float(0), t = 1.0;". Arrays and structures get their zeros too, if their parts can be counted
// and are at most about a hundred. A declaration stays as it is if an #if divides it, or if its
// type, name or size is a macro. The outputs of a whole file get theirs at the beginning of main,
// unless the text mentions main more than once.
//   old  the output is harnessColour
void translate_zeros(const struct glsl *code, struct edits *edits, bool old);

// Integers beside floats get a point, because the desktop converts them and WebGL does not: "x < 0
// ? -1 : 1" becomes "x < 0. ? -1. : 1.". A number beside an int, in an index, or in the arguments
// of a function that takes an int stays as it is. The types are guessed from the names that the
// text declares, so this is only for a text that a driver has refused. Returns memory that the
// caller frees.
char *translate_floats(const char *text);

#endif
