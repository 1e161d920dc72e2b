// renderer_pass.h - one draw call: a linked program draws a full-screen triangle into a float
// target.
#ifndef RENDERER_PASS_H
#define RENDERER_PASS_H

#include <stdbool.h>

#include "camera.h"
#include "picture/axis_labels.h"
#include "picture/kept.h"
#include "picture/sculpture.h"
#include "picture/target.h"
#include "picture/texture.h"
#include "shader/compile.h"
#include "shader/parameter.h"

#define RENDERER_FOCAL_LENGTH 1.0f // for shaders that do not declare focalLength

// The parameters that describe a camera's lens: focalLength and orthographic.
enum { RENDERER_LENSES = 2 };
extern const char *const renderer_lens[RENDERER_LENSES];

// The camera from which rays start, and its lens.
struct renderer_eye {
    struct camera camera;
    double lens[RENDERER_LENSES]; // values of the parameters named in renderer_lens
};

// Everything that a picture depends on, apart from the shader and its parameters. Times come from
// here, never from a clock, so the same inputs give the same picture.
struct renderer_inputs {
    int width, height; // size of the whole picture, pixels
    struct camera camera;
    double begin;      // seconds: the time of frame 0
    double time;       // seconds
    double time_delta; // seconds since the last frame; 0 for the first
    int frame;         // index of the frame, from 0
    double rate;       // frames per second of a film; 0 if time_delta gives the rate
    float mouse[4];    // Shadertoy's iMouse; zeros for a picture in a file
    float date[4];     // Shadertoy's iDate: year, month from 0, day, seconds of the day
    int samples;       // samples along each side of a pixel
    float digits;      // minimum height of a figure's digits, pixels; 0 for no minimum
    // The selected ray's pixel, 0,0 at the bottom left; -1,-1 if no ray is selected, so that a
    // slice shows the ray in the middle.
    int pixel[2];
    int whole[2]; // size of the picture that has this pixel, if it is drawn smaller; otherwise 0, 0
    const struct renderer_eye *eye; // the selected ray's eye; NULL for the picture's
    const double *lens; // replaces the values of renderer_lens; NULL keeps the parameters' values
    const struct strokes *strokes; // the strokes on the chapter's volume; NULL if there are none
    float zoom;                    // magnification of the slice view; 1 or 0 for the whole march
    // The number of steps of the selected ray's march that are shown, with a fraction of the next
    // step; 0 for all.
    float shown;
};

// The uniforms of the harness itself, and those of the lens, whose values renderer_inputs.lens may
// replace. The uniforms of inputs, other parameters and textures are not in this list.
#define RENDERER_UNIFORMS(X)                                                                       \
    X(iSample)                                                                                     \
    X(iSamples)                                                                                    \
    X(iPixelOffset)                                                                                \
    X(iPixelJitter)                                                                                \
    X(iCoarse)                                                                                     \
    X(iSigns)                                                                                      \
    X(iProbe)                                                                                      \
    X(iMarchSteps)                                                                                 \
    X(iMarchHit)                                                                                   \
    X(iMarchStep)                                                                                  \
    X(iMarchPixel)                                                                                 \
    X(iMarched)                                                                                    \
    X(iMarchedSteps)                                                                               \
    X(iMarchedHit)                                                                                 \
    X(iSliceFrame)                                                                                 \
    X(iSliceTick)                                                                                  \
    X(iSliceLine)                                                                                  \
    X(iSliceTickScaled)                                                                            \
    X(iSliceDecimals)                                                                              \
    X(iPlotFrame)                                                                                  \
    X(iPlotTick)                                                                                   \
    X(iPlotTickScaled)                                                                             \
    X(iPlotDecimals)                                                                               \
    X(iPlotEnd)                                                                                    \
    X(iHandlePoints)                                                                               \
    X(iHandlePoint)                                                                                \
    X(iCameraTo) X(focalLength) X(orthographic) X(harnessPixelOffset) X(harnessResolution)
#define RENDERER_UNIFORM(name) UNIFORM_##name,
enum renderer_uniform { RENDERER_UNIFORMS(RENDERER_UNIFORM) RENDERER_UNIFORM_COUNT };
#undef RENDERER_UNIFORM

// Two pictures side by side: a divider separates the columns of the first from those of the second.
// Both have the same camera, time, view and samples. The second picture follows the parameters of
// the first, except those that it sets itself.
struct comparison {
    struct renderer *other; // draws the second picture; its comparison is NULL. Not owned
    double divider;         // fraction of the width that belongs to the first picture, 0 to 1
    const char *const *own; // NAME=VALUE: parameters that the second picture sets itself. Not owned
    int own_count;
    const char *label[2]; // the pictures' names; NULL if the parameters tell them apart. Not owned
    bool gripped;         // the divider can be dragged, and shows a grip
};

// Everything needed to draw one shader file. A renderer is opened once; a shader is loaded into it,
// and loaded again when the shader's file changes.
struct renderer {
    const struct gl *gl; // NULL while the renderer is closed
    const char *root;
    struct shader_source vertex;   // shaders/screen.vert
    struct shader_source fragment; // the last fragment shader that compiled
    struct parameters parameters;  // the parameters of this shader
    struct textures textures;      // the textures of its samplers
    struct sculpture sculpture;    // the volume in one of these textures, if the chapter has a tool
    struct kept kept;              // what its frames have kept, if it has a sampler that reads this
    struct renderer *pass;         // draw the passes of a file with several, in their order; owned
    int pass_count;
    enum shader_view view;
    struct axis_labels labels;            // the numbers and words that its views write
    double orthographic;                  // the input OrthoView: 0 perspective, 1 orthographic
    float focal_length;                   // for shaders that do not declare focalLength
    GLuint program[SHADER_PROGRAM_COUNT]; // one per view, linked when first needed
    // The locations of each program's uniforms: first those of enum renderer_uniform, then those of
    // the inputs, parameters and textures. Owned.
    GLint *location[SHADER_PROGRAM_COUNT];
    const GLint *used; // locations of the program in use
    GLuint vertex_array;
    struct target picture;
    struct target sharp;           // a window's picture that is drawn over several frames
    struct target table;           // a probe's table, one column per step; the slice view reads it
    struct target single;          // one pixel is drawn: a probe's colour or cameraStop's result
    struct target projected;       // the positions of a ray's steps in the picture
    struct target points;          // the positions of the handles in the picture
    struct target coarse;          // the result of the coarse pass, one texel per block
    struct comparison *comparison; // not owned; NULL for a single picture
    const struct overlay *overlay; // drawn over every picture for a file; not owned; may be NULL
};

// ---- Programs ----

// Link a view, and the programs that its pictures need: the slice and plot views show a probe, a
// program that calls coarseStart reads the coarse pass, and a shader may read its last frame. Thus
// an error in any of them is found while the old shader is still loaded. Returns false after
// reporting the error.
bool renderer_link(struct renderer *renderer, enum shader_view view);

// Delete all programs.
void renderer_unlink(struct renderer *renderer);

// True if a linked view of a course shader uses a uniform: the linker keeps only the uniforms that
// are used. Always false in other dialects, where a uniform of this name belongs to the shader's
// author.
bool renderer_reads(const struct renderer *renderer, enum shader_view view,
                    enum renderer_uniform uniform);

// ---- Draws ----

// Apply the strokes that the volume's texture does not contain yet. Returns false after reporting
// the error.
bool renderer_sculpt(struct renderer *renderer, const struct renderer_inputs *inputs);

// Use a linked view, and set everything that is the same for all tiles and samples of a picture,
// including the table of the coarse pass, which must have run.
void renderer_use(struct renderer *renderer, const struct renderer_inputs *inputs,
                  enum shader_view view);

// Set the whole target to 0. This is needed before the first draw of a picture, because a shader
// may discard its pixel, and blending multiplies the old value by 0, which keeps a NaN. Call this
// function without a scissor, because llvmpipe compiles programs to clear part of a target, which
// takes as long as compiling a small shader.
void renderer_clear(const struct gl *gl);

// One sample of each pixel in a draw call.
struct renderer_sample {
    int number, count; // the sample's index, from 0, and the number of samples
    float jitter[2];   // offset from the pixel's centre, pixels
    // The colours replace the target's bits: without blending, which multiplies the old value by 0,
    // a NaN in the target does no harm, and bit patterns that are stored as floats stay intact.
    bool exact;
};

// Draw the triangle into the current target, with the current viewport and scissor.
//   bottom  the row of the picture that is the target's bottom row
void renderer_pass(const struct renderer *renderer, const struct renderer_sample *sample,
                   int bottom);

// Draw a rectangle of texels into a table, which must be bound, with a single sample per texel.
void renderer_fill(const struct renderer *renderer, const struct target *table, int left,
                   int bottom, int width, int height);

// Draw a rectangle of the picture, tile by tile: each draw call covers so few pixels that none
// occupies a GPU for seconds.
//   low, high  opposite corners of the rectangle in the target, pixels, the upper one excluded
//   bottom     the row of the picture that is the target's bottom row
//   samples    along each side of a pixel: their mean is drawn. 0 for one sample, drawn exactly,
//              whose number is that of the frame
//   frame      index of the frame, if samples is 0
void renderer_tiles(const struct renderer *renderer, const int low[2], const int high[2],
                    int bottom, int samples, int frame);

// The coarse pass: before each picture, one march for each block of 8 x 8 pixels finds a distance
// up to which none of the block's rays meets anything. shaders/coarse.glsl describes the pass and
// proves this claim.

// True if a linked view reads the coarse pass, and the shader's parameter coarsePass is on.
bool renderer_wants_coarse(const struct renderer *renderer, enum shader_view view);

// If renderer_wants_coarse is true, run the pass for the blocks of a rectangle of pixels, and set
// all other blocks to 0. renderer->coarse has one texel for each block of the whole picture: the
// distance at which the block's rays start, and the number of evaluations that finding it took; the
// other two channels are unused.
//   view       the linked view that is drawn next
//   low, high  opposite corners of the rectangle, pixels, the upper one excluded
// Returns false after reporting the error.
bool renderer_run_coarse(struct renderer *renderer, const struct renderer_inputs *inputs,
                         enum shader_view view, const int low[2], const int high[2]);

#endif
