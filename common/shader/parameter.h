// parameter.h - the annotated uniforms of a shader: declared once, in the shader that uses them.
//
//   uniform float sunElevation; // 40 in [-90, 90] step 1, degrees: height of the sun
//   uniform int   maxSteps;     // 128 in [1, 512]: steps before a ray is given up
//   uniform float normalStep;   // 0.001 in [1e-6, 0.1] step *2, scene units: ...
//   uniform bool  biased;       // true: show 0.5 N + 0.5
//   uniform vec3  lightColour;  // 1.0, 0.9, 0.5 in [0, 1], linear RGB: colour of the light
//
// A comment that begins with a value declares a parameter: value(s), then "in [min, max]" (numbers
// need it, bool has none), then optionally "step s" or "step *s" (each key press multiplies), then
// optionally ", unit", then ": meaning". Any other comment declares nothing.
//
// A comment begins with a value when its first word is a decimal number, true or false, and is
// followed by a blank, a comma, a colon or the end of the line: "2 times the radius" does and is
// refused, "2D position" does not. One value alone stands for every component of a vector. Without
// "step" an int changes by 1, a float by a hundredth of its range. The declaration stands alone on
// its line. The preprocessor is not run: a uniform between #if 0 and #endif counts.
#ifndef PARAMETER_H
#define PARAMETER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "shader/sampler.h"
#include "shader/source.h"

enum parameter_type { PARAMETER_FLOAT, PARAMETER_INT, PARAMETER_BOOL };

struct parameter {
    char name[64];
    enum parameter_type type;
    int components;          // 1 to 4: float, vec2, vec3, vec4; int and bool have 1
    double value[4];         // what the shader gets now; a bool is 0 or 1
    double initial[4];       // what the shader's comment says
    double minimum, maximum; // of each component; 0 and 1 for a bool
    double step;             // of one key press: added, or multiplied when multiplies
    bool multiplies;
    char unit[48]; // "" when there is none
    char meaning[200];
};

struct parameters {
    struct parameter *item; // owned
    int count;
    struct samplers samplers; // the textures of the shader
};

// Find the parameters of an expanded source, in the order of the text. Sources of the course's form
// have parameters; others have none. Other comments are blanked before looking.
// Its samplers are read too, by samplers_read.
// Returns false, reported with file and line, for a comment that begins with a value and is
// malformed: no range, value outside it, wrong number of values, unknown type, no meaning, a name
// declared twice. Free with parameters_free.
bool parameters_read(struct parameters *parameters, struct shader_source *source);

void parameters_free(struct parameters *parameters);

// The parameter of a name, or NULL.
struct parameter *parameters_find(const struct parameters *parameters, const char *name);

// Carry out NAME=VALUE. A vector takes comma-separated values, a bool true, false, 1 or 0.
// Returns false, reported: unknown name (with the names there are), not a number, NaN, wrong count,
// out of range (with the range).
bool parameters_assign(const struct parameters *parameters, const char *assignment);

// Copy the values of old into those of new that have the same name, type and number of components,
// clamped to the new range: what a reload keeps. A component whose value the file has changed takes
// that one: who edits a number wants to see it.
void parameters_keep(const struct parameters *new_ones, const struct parameters *old_ones);

// Change every component by a number of key presses, stopping at the range; a bool toggles.
void parameter_change(struct parameter *parameter, int presses);

// Where a component lies between its ends, 0 to 1: by its size, or by its logarithm where the step
// multiplies.
//   part  0 to components - 1
double parameter_place(const struct parameter *parameter, int part);

// The other way: give a component the value at a place, which is clamped to [0, 1], rounded to what
// a hand can tell apart: a thousandth of the range, or three figures where the step multiplies; an
// int to a whole number, a bool to one of its two.
void parameter_put(struct parameter *parameter, int part, double place);

// True for three numbers whose unit is "linear RGB".
bool parameter_is_colour(const struct parameter *parameter);

// Back to the value in the shader's comment.
void parameter_reset(struct parameter *parameter);

// The value as it would be typed after "NAME=".
void parameter_value_text(const struct parameter *parameter, char *text, size_t size);

// The range as --list shows it: "[0, 4]", or "true or false".
void parameter_range_text(const struct parameter *parameter, char *text, size_t size);

// The table of --list: name, value, range, unit, meaning.
void parameters_print(const struct parameters *parameters, FILE *file);

#endif
