// parameter.h - the annotated uniforms of a shader. Each is declared in the shader that uses it.
//
//   uniform float sunElevation; // 40 in [-90, 90] step 1, degrees: height of the sun
//   uniform int   maxSteps;     // 128 in [1, 512]: steps after which a ray is abandoned
//   uniform float normalStep;   // 0.001 in [1e-6, 0.1] step *2, scene units: ...
//   uniform bool  biased;       // true: show 0.5 N + 0.5
//   uniform vec3  lightColour;  // 1.0, 0.9, 0.5 in [0, 1], linear RGB: colour of the light
//
// A comment that begins with a value declares a parameter. The comment consists of one or several
// values, then "in [min, max]" (required for numbers, not allowed for a bool), optionally "step s"
// or "step *s" (each key press adds s, or multiplies by s), optionally ", unit", and ": meaning".
// Any other comment declares nothing.
//
// A comment begins with a value if its first word is a decimal number, true or false, and is
// followed by a blank, a comma, a colon or the end of the line: "2 times the radius" does, and
// is refused; "2D position" does not. A single value applies to every component of a vector.
// Without "step", an int changes by 1, and a float by a hundredth of its range. The declaration
// must be alone on its line. In the course's dialect, the preprocessor is not run: a uniform
// between #if 0 and #endif counts.
//
// A vec2 or a vec3 can be a handle, a point that can be dragged in the picture:
//
//   uniform vec2 aim;  // (0.6, 0.1) handle scene units: where the ray points
//   uniform vec3 lamp; // 1, 2, 0 in [-5, 5] step 0.1, handle xz scene units: the lamp
//
// The values may be in parentheses. Without a range, a handle has the range [-10, 10]. A vec2 lies
// in the plane z = 0 or, after "xz", in the plane y = 0. A vec3 moves parallel to the screen or,
// after "xy" or "xz", keeps the coordinate that is not named. In a shader with its own main, which
// has no rays, a vec2 is a place on the screen, in halves of its height from the middle.
//
// If one unit is "hour of the day" and another "hours per second", the panel shows the hour of the
// day. Whoever changes the first of these in a window sees the picture of that hour, because the
// time begins again.
//
// A texture is declared in the same way:
//
//   uniform sampler2D granite; // "granite.png" sRGB repeat: polished stone, seen from above
//   uniform sampler3D noise;   // "noise.png" linear repeat 64: value noise, 64 slices one below
//                              // the other
//   uniform usampler2D reef;   // "reef.png": parts and lists
//
// The comment begins with the name of a file in quotes, which is looked for next to the file that
// declares the sampler, then in shaders/textures/, but never outside the project and the shader's
// own folder. Then come: sRGB for a colour, which is decoded when it is read, or linear for a
// number, which is not; repeat or clamp, for coordinates outside [0, 1]; for a volume, its number
// of slices; and a meaning. A usampler2D is a table of whole numbers of 32 bits, which is read with
// texelFetch: each of its texels is four pixels of the picture, and red is the lowest byte of each.
// After the name of its file, only a meaning follows.
//
// In the course's dialect, every sampler needs such a comment, unless the preprocessor certainly
// skips the sampler. In the other dialects, the samplers are those of the source that have a
// picture.
#ifndef PARAMETER_H
#define PARAMETER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "shader/source.h"

#define SAMPLER_SLICES 2048 // maximum number of slices of a volume

struct sampler {
    char name[64];
    int file;          // index of the picture among the files of the source; -1 for black
    int line;          // line of the text that declares the sampler, from 0
    int channel;       // 0 to 3 for Shadertoy's iChannelN and the like; -1 for any other sampler
    bool srgb, repeat; // if false: linear, clamp
    int slices;        // number of slices of a volume; 0 for a picture
    bool cube;         // a cube map
    bool words;        // a table of whole numbers: a usampler2D
    // The number of the pass whose last picture it reads, from 1; 0 if it reads a file. A course
    // shader has one pass, what it keeps itself.
    int pass;
    char filter; // of this picture, as in struct shader_pass; 0 for linear
    char meaning[200];
};

struct samplers {
    struct sampler *item; // owned
    int count;
};

enum parameter_type { PARAMETER_FLOAT, PARAMETER_INT, PARAMETER_BOOL };

// The plane in which a handle is dragged; HANDLE_SCREEN is parallel to the screen.
enum parameter_handle { HANDLE_NONE, HANDLE_SCREEN, HANDLE_XY, HANDLE_XZ };

struct parameter {
    char name[64];
    enum parameter_type type;
    int components;          // 1 to 4: float, vec2, vec3, vec4; int and bool have 1
    double value[4];         // the current value; a bool is 0 or 1
    double initial[4];       // the value in the shader's comment
    double minimum, maximum; // range of each component; 0 and 1 for a bool
    double step; // change per key press: a factor if multiplies is set, otherwise an increment
    bool multiplies;
    enum parameter_handle handle;
    char unit[48]; // "" if there is none
    char meaning[200];
};

struct parameters {
    struct parameter *item; // owned
    int count;
    struct samplers samplers; // the textures of the shader
};

// Read the parameters and the samplers of a source, in the order of the text. In dialects other
// than the course's, a malformed annotation declares nothing, and the samplers are those with a
// picture of the request, or one that the text names.
// Returns false after reporting the error with file and line. Errors of a comment that begins with
// a value are: no range, a value outside the range, a wrong number of values, an unknown type, no
// meaning. Errors of a sampler are: no comment as above, a malformed comment, a type other than
// sampler2D and sampler3D, a declaration in a structure or a macro, a missing file. Declaring a
// name twice is an error in both cases. Free with parameters_free.
bool parameters_read(struct parameters *parameters, struct shader_source *source);

// True if the declaration of a uniform has a well-formed comment that makes it a parameter.
//   name  the token of the uniform's name in source->code.statement
bool parameter_declared(const struct shader_source *source, const struct glsl_token *name);

void parameters_free(struct parameters *parameters);

// The parameter with a name, or NULL if there is none.
struct parameter *parameters_find(const struct parameters *parameters, const char *name);

// Carry out an assignment, NAME=VALUE. A vector takes comma-separated values; a bool takes true,
// false, 1 or 0. Returns false after reporting the error: the name is unknown (the message lists
// the known names), a value is not a finite number, the number of values is wrong, or a value is
// out of range (the message gives the range).
bool parameters_assign(const struct parameters *parameters, const char *assignment);

// Keep values across a reload: copy each old value to the new parameter of the same name, type and
// number of components, clamped to the new range. A component whose value has changed in the file
// takes the new value, because its author wants to see it.
void parameters_keep(const struct parameters *new_ones, const struct parameters *old_ones);

// Change every component by a number of steps, one for each key press, stopping at the ends of the
// range; negative numbers go down. A bool toggles.
void parameter_change(struct parameter *parameter, int presses);

// The position of a component in its range, from 0 to 1; on a logarithmic scale if the step
// multiplies.
//   part  index of the component
double parameter_fraction(const struct parameter *parameter, int part);

// The inverse of parameter_fraction: set a component from a position, which is clamped to [0, 1].
// The value is rounded to a multiple of the largest power of ten that is at most a thousandth of
// the range, or to three significant digits if the step multiplies; an int is rounded to a whole
// number, and a bool to 0 or 1.
void parameter_put(struct parameter *parameter, int part, double fraction);

// True for a parameter with three components whose unit is "linear RGB".
bool parameter_is_colour(const struct parameter *parameter);

// True for the hour at which the picture's time begins: a parameter whose unit is "hour of the
// day".
bool parameter_is_hour(const struct parameter *parameter);

// Reset a parameter to the value in the shader's comment.
void parameter_reset(struct parameter *parameter);

// The value as it would be typed after "NAME=".
void parameter_value_text(const struct parameter *parameter, char *text, size_t size);

// The range as --list shows it: "[0, 4]", or "true or false".
void parameter_range_text(const struct parameter *parameter, char *text, size_t size);

// Print the table of --list, with name, value, range, unit and meaning.
void parameters_print(const struct parameters *parameters, FILE *file);

// The file on the command line for a sampler of another tool's dialect: that of --texture
// NAME=FILE, or else that of its channel; NULL if neither is given.
const char *sampler_given(const struct shader_source *source, const struct shader_sampler *sampler);

// True if such a sampler has a picture, given or named by the text.
bool sampler_has_picture(const struct shader_source *source, const struct shader_sampler *sampler);

// True if each picture of the source's request has a sampler that reads it. Returns false after
// reporting the error: no sampler has the NAME of a NAME=FILE (the message lists the names of all
// samplers), the shader does not read a channel, or --channel is used in the course's dialect.
bool samplers_fit(const struct samplers *samplers, const struct shader_source *source);

// Report a problem with a sampler's picture. Always returns false.
bool sampler_refuse(const struct shader_source *source, const struct sampler *sampler,
                    const char *format, ...) __attribute__((format(printf, 3, 4)));

// True if a sampler reads what an earlier frame has kept.
bool samplers_keep(const struct samplers *samplers);

// Print the table of --list, with name, file, colour, edge, slices and meaning. Prints nothing if
// there are no samplers.
void samplers_print(const struct samplers *samplers, const struct shader_source *source,
                    FILE *file);

#endif
