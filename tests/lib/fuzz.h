// fuzz.h - what must hold for any bytes that a person hands in, for libFuzzer, which makes them up
// (tests/tools/fuzz.c), and for unit/corpus.c, which has a folder of them.
//
// Each function ends the program with the reason if a promise of the header in question is broken.
// One promise is that every refusal reports exactly one line, and every success none. They need a
// scratch folder (scratch_make).
#ifndef TESTS_FUZZ_H
#define TESTS_FUZZ_H

#include <stddef.h>
#include <stdint.h>

// A shader and the files that it includes, read by shader_read and processed as far as possible
// without OpenGL: its text for each view, its export, its parameters' values, a driver's log.
//   bytes  files one after the other; a line "=== NAME" begins each but own/main.frag, which is the
//          shader. Names: own/part.glsl, own/deep/part.glsl, outside.glsl,
//          root/shaders/library.glsl, root/shaders/more.glsl, own/a.png, which nothing reads, and
//          log, the driver's words; another name begins nothing
void fuzz_include(const uint8_t *bytes, size_t size);

// Annotated uniforms and an assignment.
//   bytes  the first line is NAME=VALUE, the rest a text in the course's dialect
void fuzz_parameter(const uint8_t *bytes, size_t size);

// A command line.
//   bytes  one argument a line
void fuzz_options(const uint8_t *bytes, size_t size);

// A picture for a sampler.
//   bytes  the first says how it is read: 1 sRGB, 2 repeat, 4 a volume, with as many slices as the
//          rest of the byte says; then a PNG, whose checksums are corrected
void fuzz_picture(const uint8_t *bytes, size_t size);

// All four by name.
struct fuzz_target {
    const char *name; // the name of its folder in tests/corpus
    void (*run)(const uint8_t *bytes, size_t size);
};

#define FUZZ_TARGETS 4
extern const struct fuzz_target fuzz_targets[FUZZ_TARGETS];

#endif
