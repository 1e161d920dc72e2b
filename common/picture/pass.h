// pass.h - one draw of the triangle with one program: what a renderer holds, and what it tells the
// program.
#ifndef PASS_H
#define PASS_H

#include <stdbool.h>

#include "camera.h"
#include "context/context.h"
#include "picture/enlarge.h"
#include "picture/overlay.h"
#include "picture/signs.h"
#include "picture/target.h"
#include "picture/texture.h"
#include "shader/parameter.h"
#include "shader/compile.h"

#define RENDERER_FOCAL_LENGTH 1.0f // for shaders that declare no focalLength of their own

// The parameters that make a view of a camera, by name: focalLength and orthographic.
#define PASS_LENSES 2
extern const char *const pass_lens[PASS_LENSES];

// Where rays start, and through which view.
struct renderer_eye {
    struct camera camera;
    double lens[PASS_LENSES]; // values of pass_lens
};

// What a picture depends on, besides the shader and its parameters. Times come from here, never
// from the clock, so that the same inputs give the same picture.
struct renderer_inputs {
    int width, height;    // pixels of the whole picture
    struct camera camera; // whose rays start the picture
    double time;          // seconds
    double time_delta;    // seconds since the last frame; 0 for a file
    int frame;            // number of the frame; 0 for a file
    float mouse[4];       // Shadertoy's iMouse; zeros for a file
    float date[4];        // Shadertoy's iDate: year, month from 0, day, seconds of the day
    int samples;          // along each side of a pixel
    int pixel[2]; // whose ray is looked at, 0,0 bottom left; -1,-1: none; the slice: the middle
    const struct renderer_eye *eye; // where that ray starts; NULL: where the picture's rays do
    const double *lens; // these values in place of pass_lens' parameters; NULL: the parameters' own
    float zoom;         // of the slice view; 1: the whole march, as does 0
    float shown; // how many steps of that ray's march are shown, with a part of the way to the
                 // next one; 0: all
};

struct pair;

// Everything needed to draw one shader file. Opened once; a shader is loaded into it, and loaded
// again when its file changes.
struct renderer {
    const struct gl *gl;
    const char *root;
    struct shader_source vertex;   // shaders/screen.vert
    struct shader_source fragment; // the last one that compiled
    struct parameters parameters;  // of that one
    struct textures textures;      // of its samplers
    struct signs signs;            // what its views write
    enum shader_view view;
    float focal_length;                   // for shaders that declare no focalLength of their own
    double orthographic;                  // OrthoView of whole files: 0 perspective, 1 orthographic
    GLuint program[SHADER_PROGRAM_COUNT]; // by view, compiled when first asked for
    GLuint used;                          // the program of the draw under way
    GLuint vertex_array;
    struct target picture;
    struct target sharp;           // a window's picture that is drawn in several frames
    struct target table;           // of a probe, one column a step: the slice view reads it
    struct target single;          // of a probe: one pixel of the picture is drawn
    struct target places;          // where the steps of a ray are in the picture
    struct target coarse;          // of the coarse pass, one pixel a block
    struct enlarge enlarge;        // what shows a small picture in a large window
    struct pair *pair;             // the picture beside it: pair.h; not owned; NULL: none
    const struct overlay *overlay; // drawn over every written picture, not owned; NULL: none
};

// Link a view of a source, and with it the programs that run before each of its pictures, so that
// an error in one of them is found here, while the old shader is still there: the slice view shows
// what a probe finds, and a program that calls coarseStart reads the coarse pass.
//   program  by view; 0 where nothing is linked yet
// Returns false, reported.
bool pass_link(struct renderer *renderer, const struct shader_source *source, enum shader_view view,
               GLuint program[SHADER_PROGRAM_COUNT]);

// Is a uniform of the harness's own used by a linked view of the shader? The linker keeps only what
// is. False for a view that is not linked, and in other forms than the course's, where the name is
// the author's.
bool pass_reads(const struct renderer *renderer, enum shader_view view, const char *name);

// Use a linked view, and tell it everything that stays the same for all tiles and samples of a
// picture.
void pass_use(struct renderer *renderer, const struct renderer_inputs *inputs,
              enum shader_view view);

// The location of a uniform in the program in use; -1, which OpenGL ignores, where nothing reads
// it.
GLint pass_location(const struct renderer *renderer, const char *name);

// One sample of the pixels of a draw.
struct pass_sample {
    int number, count; // from 0; of how many
    float jitter[2];   // from the pixel's centre, pixels
};

// Make the whole target 0. Needed before the first draw of a picture: a shader may discard its
// pixel, and blending multiplies what was there by 0, which leaves what is no number. To be called
// without a scissor: to clear a part of a target llvmpipe compiles programs of its own, which takes
// as long as those of a small shader.
void pass_clear(const struct gl *gl);

// One draw of the triangle, into the target, viewport and scissor that are set.
//   sample  NULL: the only one, in the pixel's centre, whatever the picture's samples
//   bottom  the row of the picture with which the target begins
void pass_draw(const struct renderer *renderer, const struct pass_sample *sample, int bottom);

#endif
