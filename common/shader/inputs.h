// inputs.h - the inputs of a shader, under the names that each tool gives them: one table. A file
// may declare an input as float, int, vec2, vec3 or vec4, and it is set by that type.
#ifndef SHADER_INPUTS_H
#define SHADER_INPUTS_H

#include <stdbool.h>

#include "context/gl.h"
#include "shader/glsl.h"

// The meaning of an input, with the four numbers of its value.
enum input_meaning {
    INPUT_SIZE,          // of the picture, pixels (width, height, 1, 0)
    INPUT_TIME,          // seconds
    INPUT_STEP,          // seconds since the last picture
    INPUT_RATE,          // pictures per second
    INPUT_FRAME,         // index of the picture
    INPUT_DATE,          // (year, month from 0, day, seconds of the day)
    INPUT_MOUSE,         // with Shadertoy's signs, pixels
    INPUT_POINTER,       // pixels from the bottom left
    INPUT_POINTER_SHARE, // as a fraction of the picture's size
    INPUT_EYE,           // the camera: position
    INPUT_RIGHT,
    INPUT_UP,
    INPUT_FORWARD,
    INPUT_FOCAL,                  // focal length
    INPUT_ORTHO,                  // 0 perspective, 1 orthographic
    INPUT_ASPECT,                 // width divided by height
    INPUT_ZERO,                   // always 0
    INPUT_VALUES,                 // the number of those above
    INPUT_CHANNEL = INPUT_VALUES, // a picture of --channel
    INPUT_CHANNEL_SIZE,           // its size; for iChannelResolution, all four
    INPUT_DRAW,                   // differs from draw to draw: set by pass.c
    INPUT_POSITION,               // the pixel's position, from the vertex shader
    INPUT_SILENT,                 // sound, or the last picture: black and 0 here
    INPUT_REFUSED                 // not offered, and no picture is right without it
};

struct input {
    const char *name, *type; // type: if the file declares none
    enum input_meaning meaning;
    int channel;      // of INPUT_CHANNEL and INPUT_CHANNEL_SIZE
    const char *text; // the value of an INPUT_POSITION in the vertex shader, a vec2; why
                      // INPUT_SILENT and INPUT_REFUSED are not offered
};

// An input that a source reads.
struct shader_input {
    const struct input *input;
    int components; // 1 to 4
    bool integer;   // an int
    bool declared;  // by the source itself
};

struct shader_source;

// The input of a name, or NULL; the input of an index from 0, NULL after the last.
const struct input *inputs_find(const char *name);
const struct input *inputs_row(int index);

// True for the inputs of the course; for those of Shadertoy.
bool inputs_is_course(const struct input *input);
bool inputs_is_shadertoy(const struct input *input);

// True for any name that Shadertoy declares.
bool inputs_is_toys(const char *name);

// The input whose name is most similar, for messages; never NULL.
const struct input *inputs_nearest(const char *name);

// The channel that is read as a cube map, or NULL.
const struct glsl_token *inputs_cube_map(const struct glsl *code);

// Read the components of a type; true for float, int and vec2 to vec4.
bool inputs_type(const char *type, struct shader_input *into);

// An input in its own type, not declared.
struct shader_input inputs_default(const struct input *input);

// True for an input that Shadertoy has in exactly the type that the source declares.
bool inputs_is_own(const struct shader_input *in);

// Add an input to those that a source reads.
void inputs_add(struct shader_source *source, struct shader_input input);

// True if a linked program of a source reads an input with a meaning from first to last. The linker
// keeps only what is used.
bool inputs_reads(const struct gl *gl, GLuint program, const struct shader_source *source,
                  enum input_meaning first, enum input_meaning last);

// True if an input has a value here: a channel needs a picture.
bool inputs_offers(const struct shader_source *source, const struct input *input);

// Report why an input is not offered; always false.
//   line  of the source's text, from 0
bool inputs_refuse(const struct shader_source *source, const struct input *input, int line);

// The lines before and behind the vertex shader that compute the positions which the source reads;
// the caller frees both.
void inputs_vertex(const struct shader_source *source, char **before, char **behind);

// Set the inputs of the program in use.
//   location  of each input of the source
//   value     four numbers for each meaning below INPUT_VALUES
void inputs_set(const struct gl *gl, const struct shader_source *source, const GLint *location,
                float value[INPUT_VALUES][4]);

#endif
