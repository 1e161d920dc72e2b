// sampler.h - the textures of a shader: annotated samplers, declared as parameters are.
//
//   uniform sampler2D granite; // "granite.png" sRGB repeat: polished stone, seen from above
//   uniform sampler3D noise;   // "noise.png" linear repeat 64: value noise, 64 slices one below
//                              // the other
//
// The comment begins with the file's name in quotes. It is looked for beside the file that declares
// the sampler, then in shaders/textures/, in the project or in the shader's own folder alone. Then
// come sRGB, a colour that is decoded when it is read, or linear, a number that is not; repeat or
// clamp, for what lies outside of [0, 1]; for a volume its number of slices; and a meaning.
//
// In the course's form each sampler needs such a comment, whatever the driver makes of it; only
// what the preprocessor surely leaves out needs none. In the other forms the samplers are those of
// --channel.
#ifndef SHADER_SAMPLER_H
#define SHADER_SAMPLER_H

#include <stdbool.h>
#include <stdio.h>

#include "shader/source.h"

#define SAMPLER_SLICES 2048 // at most

struct sampler {
    char name[64];
    int file;          // the picture, among the files of the source
    int line;          // of the source's text that declares it, from 0; -1: --channel does
    bool srgb, repeat; // else linear, clamp
    int slices;        // of a volume; 0 for a picture
    char meaning[200];
};

struct samplers {
    struct sampler *item; // owned
    int count;
};

// Find the samplers of an expanded source, in the order of the text, and their files, which are
// added to the source's.
// Returns false, reported with file and line: a sampler without such a comment, a malformed one, a
// kind of sampler that is neither sampler2D nor sampler3D, one in a structure or a macro, a name
// declared twice, a file that is not there. Free with samplers_free.
bool samplers_read(struct samplers *samplers, struct shader_source *source);

void samplers_free(struct samplers *samplers);

// True when each picture that the source's request names has a sampler to be read by. Reported: a
// NAME of NAME=FILE that none of these has, with the names there are; a channel that the shader
// does not mention, or where it is of the course's form.
bool samplers_fit(const struct samplers *samplers, const struct shader_source *source);

// Report what is wrong with a sampler's picture; always false.
bool sampler_refuse(const struct shader_source *source, const struct sampler *sampler,
                    const char *format, ...) __attribute__((format(printf, 3, 4)));

// The table of --list: name, file, how it is read, meaning. Nothing where there are none.
void samplers_print(const struct samplers *samplers, const struct shader_source *source,
                    FILE *file);

#endif
