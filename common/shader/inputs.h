// inputs.h - the inputs of a shader, and those that the course has; dialects/tool_inputs.h has the
// names that other tools give them. A file may declare an input as float, int, vec2, vec3 or vec4,
// and the input is set with that type.
#ifndef SHADER_INPUTS_H
#define SHADER_INPUTS_H

#include <stdbool.h>

#include "context/gl.h"
#include "shader/glsl.h"

// The meaning of an input, with the four numbers of its value.
enum input_meaning {
    INPUT_SIZE,          // size of the picture in pixels: (width, height, 1, 0)
    INPUT_TIME,          // seconds
    INPUT_STEP,          // seconds since the previous picture
    INPUT_RATE,          // pictures per second
    INPUT_FRAME,         // index of the picture
    INPUT_DATE,          // (year, month from 0, day, seconds since midnight)
    INPUT_MOUSE,         // in pixels, with Shadertoy's conventions for the signs
    INPUT_POINTER,       // position of the pointer, in pixels from the bottom left
    INPUT_POINTER_SHARE, // position of the pointer, as a fraction of the picture's size
    INPUT_EYE,           // position of the camera; its axes follow
    INPUT_RIGHT,
    INPUT_UP,
    INPUT_FORWARD,
    INPUT_FOCAL,                  // focal length
    INPUT_ORTHO,                  // 0 perspective, 1 orthographic
    INPUT_ASPECT,                 // width divided by height
    INPUT_SOUND_RATE,             // samples of sound per second
    INPUT_ZERO,                   // always 0
    INPUT_VALUES,                 // the number of meanings above
    INPUT_CHANNEL = INPUT_VALUES, // the picture of a channel
    INPUT_CHANNEL_SIZE,           // the size of such a picture; for iChannelResolution, of all four
    INPUT_DRAW,                   // changes with each draw; set by renderer_pass.c
    INPUT_POSITION,               // the pixel's position, computed by the vertex shader
    INPUT_SILENT,                 // sound or the like, which is black or 0 here
    INPUT_LAST                    // the picture that the last frame showed
};

struct input {
    const char *name, *type; // type is used if the file declares none
    enum input_meaning meaning;
    int channel; // index for INPUT_CHANNEL and INPUT_CHANNEL_SIZE; -1 for all four
    // The value of an INPUT_POSITION in the vertex shader, a vec2, or the reason why an
    // INPUT_SILENT is not supported. For an INPUT_LAST, the filter of struct shader_read, and an r
    // if the picture repeats.
    const char *text;
};

// An input that a source reads.
struct shader_input {
    const struct input *input;
    int components; // 1 to 4
    bool integer;   // the input is an int
    bool declared;  // the source declares the input itself
};

struct shader_source;
struct shader_sampler;

// A row of a table of inputs that have a value.
#define INPUT_ROW(name, type, meaning)                                                             \
    {                                                                                              \
        name, type, INPUT_##meaning, 0, ""                                                         \
    }

// The course's input at an index, from 0, or NULL after the last. Shadertoy also has the first
// INPUTS_SHARED of them.
enum { INPUTS_SHARED = 6 };
const struct input *inputs_course(int index);

// True for an input of the course, and for one of the course that Shadertoy also has.
bool inputs_is_course(const struct input *input);
bool inputs_is_shared(const struct input *input);

// Set the number of components from a type, and whether the type is an int. Returns true for float,
// int and vec2 to vec4.
bool inputs_type(const char *type, struct shader_input *into);

// An input with its type from the table, not declared by the source.
struct shader_input inputs_default(const struct input *input);

// Add an input to those that a source reads, unless it is already among them.
void inputs_add(struct shader_source *source, struct shader_input input);

// Add a sampler to those that a source reads, unless it is already among them. Returns the channel
// that it has there.
int inputs_add_sampler(struct shader_source *source, struct shader_sampler sampler);

// True if a linked program of a source reads an input with a meaning from first to last. The linker
// keeps only the uniforms that are used.
bool inputs_reads(const struct gl *gl, GLuint program, const struct shader_source *source,
                  enum input_meaning first, enum input_meaning last);

// Write the lines before and after the vertex shader, which compute the positions that the source
// reads. The caller frees both texts.
void inputs_vertex(const struct shader_source *source, char **before, char **after);

// Set the inputs of the program in use.
//   location  the location of each input of the source
//   value     four numbers for each meaning below INPUT_VALUES
void inputs_set(const struct gl *gl, const struct shader_source *source, const GLint *location,
                float value[INPUT_VALUES][4]);

#endif
