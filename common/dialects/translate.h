// translate.h - translates a shader in another tool's dialect for this OpenGL context or for
// Shadertoy.
//
// Declarations outside functions are checked and rewritten. An input becomes a uniform or, if it is
// a position, an input from the vertex shader; a uniform with a value that is not a parameter
// becomes a variable; location and interpolation qualifiers are removed. gl_FragColor, texture2D,
// varying and other words of old versions get their current names. Precisions become highp, because
// WebGL links an input only if its precision is that of the vertex shader. gl_FragCoord becomes the
// position in the whole picture, because the renderer draws a picture in parts and shifts its
// samples. Lines keep their numbers.
#ifndef DIALECTS_TRANSLATE_H
#define DIALECTS_TRANSLATE_H

#include <stdio.h>

#include "dialects/declared.h"
#include "shader/source.h"

enum translate_target { TRANSLATE_DRIVER, TRANSLATE_SHADERTOY };

// Translate a source and gather its inputs.
//   prelude  receives the lines before the text; for Shadertoy, declarations of the inputs that
//            Shadertoy lacks, or NULL if it can call the file's own mainImage
//   body     receives the text
// The caller frees prelude and body. Returns false after reporting the error with file and line.
// Errors are: an unknown input; an input or a uniform of a type that cannot be set; a texture that
// is read but has no picture; an output that is not a colour, or several outputs of which none is
// at location 0; and, for Shadertoy, anything else that WebGL lacks.
bool translate(struct shader_source *source, enum translate_target target, char **prelude,
               char **body);

// Initialise variables that have no value to 0, as browsers do: "float d, t = 1.0;" becomes "float
// d=float(0), t = 1.0;". Arrays and structures are initialised too, if their parts can be counted
// and are not too many. So are out parameters, and a function that returns a value on some paths
// returns 0 on the others. A declaration is left unchanged if a directive divides it, or if its
// type, name or size is a macro.
//   begin  receives the statements that set the outputs of a whole shader to 0, for the beginning
//          of main
void translate_zeros(const struct glsl *code, struct edits *edits, FILE *begin);

// Add a decimal point to integers in expressions with floats, because desktop GLSL converts them
// and WebGL does not: "x < 0 ? -1 : 1" becomes "x < 0. ? -1. : 1.". A number in an expression with
// an int, in an index, or in the arguments of a function that takes an int is left unchanged. Types
// are guessed from the names that the text declares, so this function is used only for a text that
// a driver has refused. Returns memory that the caller frees.
char *translate_floats(const char *text);

#endif
