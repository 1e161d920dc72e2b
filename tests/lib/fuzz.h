// fuzz.h - what must be true for any input, whatever its bytes. libFuzzer generates inputs
// (tests/tools/fuzz.c), and tests/unit/corpus.c reads them from a folder.
//
// Each function prints the reason and ends the program if a promise of the tested header is broken.
// One promise is that every refusal reports exactly one line, short and harmless to a terminal, and
// every success none. The functions need a scratch folder (scratch_make).
#ifndef TESTS_FUZZ_H
#define TESTS_FUZZ_H

#include <stddef.h>
#include <stdint.h>

// A shader and the files that it includes, read by shader_read and processed as far as possible
// without OpenGL: the text for each view, the values of the parameters, the export to Shadertoy,
// and the explanation of a driver's log.
//   bytes  files one after the other; the first is the shader, own/main.frag, and a line "=== NAME"
//          begins each other file. The names are own/part.glsl, own/deep/part.glsl, outside.glsl,
//          root/shaders/library.glsl, root/shaders/more.glsl, own/a.png, which nothing reads, and
//          log, the text of a driver's log. A line with another name is ordinary text
void fuzz_include(const uint8_t *bytes, size_t size);

// Annotated uniforms and an assignment.
//   bytes  the first line is NAME=VALUE, and the rest is a shader in the course's dialect
void fuzz_parameter(const uint8_t *bytes, size_t size);

// A command line.
//   bytes  one argument per line
void fuzz_options(const uint8_t *bytes, size_t size);

// A picture for a sampler.
//   bytes  the bits of the first byte say how the picture is read: 1 sRGB, 2 repeat, 4 a volume of
//          byte / 8 + 1 slices. The rest is a PNG, whose checksums are corrected
void fuzz_picture(const uint8_t *bytes, size_t size);

// The four functions by name.
struct fuzz_target {
    const char *name; // also the name of the target's folder in tests/corpus
    void (*run)(const uint8_t *bytes, size_t size);
};

#define FUZZ_TARGETS 4
extern const struct fuzz_target fuzz_targets[FUZZ_TARGETS];

#endif
