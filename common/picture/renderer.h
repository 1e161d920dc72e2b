// renderer.h - draws pictures with linked programs: one full-screen triangle, into a float target.
//
// renderer.c draws pictures, renderer_ray.c computes the march of one ray, and renderer_pass.c
// links programs and issues single draw calls.
#ifndef RENDERER_H
#define RENDERER_H

#include <stdbool.h>

#include "camera.h"
#include "picture/axis_labels.h"
#include "picture/image.h"
#include "picture/overlay.h"
#include "picture/sculpture.h"
#include "picture/slice.h"
#include "picture/target.h"
#include "picture/texture.h"
#include "shader/compile.h"
#include "shader/parameter.h"

#define RENDERER_FOCAL_LENGTH 1.0f // for shaders that do not declare focalLength
#define RENDERER_STEPS        64   // maximum steps a picture can read; see shaders/marched.glsl

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
    const struct renderer_eye *eye; // the selected ray's eye; NULL for the picture's
    const double *lens; // replaces the values of renderer_lens; NULL keeps the parameters' values
    const struct strokes *strokes; // the strokes on the chapter's volume; NULL if there are none
    float zoom;                    // magnification of the slice view; 1 or 0 for the whole march
    // The number of steps of the selected ray's march that are shown, with a fraction of the next
    // step; 0 for all.
    float shown;
};

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
    struct axis_labels labels;     // the numbers and words that its views write
    enum shader_view view;
    float focal_length;                   // for shaders that do not declare focalLength
    double orthographic;                  // the input OrthoView: 0 perspective, 1 orthographic
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

// ---- Open, load, close ----

// Create the triangle's vertex array and the targets, and read shaders/screen.vert.
//   gl, root  must outlive the renderer
// Returns false after reporting the error; then the renderer is closed. Close an open one with
// renderer_close in the same context.
bool renderer_open(struct renderer *renderer, const struct gl *gl, const char *root);
void renderer_close(struct renderer *renderer);

// Compile and link a shader, and read its textures. Parameters that it shares with the previous
// shader keep their values, as described for parameters_keep. If a shader of another tool replaces
// the previous shader, the view becomes the picture, the only one that it has.
//   source, parameters  those of the shader, which are taken over and left empty
// Returns false after reporting the error; then both still belong to the caller, and the renderer
// still draws the last good shader.
bool renderer_load(struct renderer *renderer, struct shader_source *source,
                   struct parameters *parameters);

// The same in two steps, for shaders of which either all or none must be loaded; the parameters
// have the values of the file. renderer_prepare changes only next, which is closed after an error.
// Then nothing may be drawn until renderer_take loads the shader, or renderer_drop frees it; next
// may be closed.
//   view  the view that is linked
bool renderer_prepare(const struct renderer *renderer, struct renderer *next, enum shader_view view,
                      struct shader_source *source, struct parameters *parameters);
void renderer_take(struct renderer *renderer, struct renderer *next);
void renderer_drop(struct renderer *next);

// Choose the view, in both pictures of a comparison, and link the view's program if it has not been
// linked yet. If a shader has no such view or the view does not link, reports the error, keeps the
// old view and returns false.
bool renderer_set_view(struct renderer *renderer, enum shader_view view);

// ---- Draw and read pictures ----

// Draw rows [bottom, bottom + rows) of the picture into the float target, tile by tile, as the mean
// of samples x samples jittered passes. Row 0 is the bottom row.
// Returns false after reporting the error, for example if the driver has no float target of this
// size.
bool renderer_draw(struct renderer *renderer, const struct renderer_inputs *inputs, int bottom,
                   int rows);

// A rectangle of a picture's pixels, the upper bounds excluded; row 0 is the bottom row.
struct renderer_piece {
    int left, right, bottom, top;
};

// Draw a piece of the picture into the target sharp, which keeps everything else while the
// picture's size stays the same. The piece at the top left must be drawn first, because drawing it
// clears the target. The pixels are bit-for-bit identical to those of renderer_draw, except that in
// the slice and the plot of a comparison a piece must have all columns, because both pictures share
// a frame. Returns false after reporting the error.
bool renderer_sharpen(struct renderer *renderer, const struct renderer_inputs *inputs,
                      const struct renderer_piece *piece);

// Copy the picture of renderer_draw into the window's framebuffer: pixel by pixel if the sizes are
// equal, otherwise interpolated linearly, so that a small picture shows no blocks.
//   width, height  size of the framebuffer, pixels
void renderer_present(const struct renderer *renderer, int width, int height);

// Copy rows [from, from + rows) of the picture of renderer_sharpen into the window's framebuffer,
// pixel by pixel.
void renderer_present_sharp(const struct renderer *renderer, int from, int rows);

// Draw a whole picture, with the overlay if there is one, and read it back: a value v becomes
// floor(255 clamp(v, 0, 1) + 0.5).
// The caller frees image. Returns false after reporting the error.
bool renderer_picture(struct renderer *renderer, const struct renderer_inputs *inputs,
                      struct image *image);

// Do the same with the picture of renderer_sharpen, without drawing it again.
bool renderer_sharp_picture(struct renderer *renderer, struct image *image);

// renderer_split returns the first column of the second picture, in pictures of this width in
// pixels, or the width if there is no second picture. renderer_at returns the renderer that draws
// column x; columns left of the picture count as the first, and those right of it as the last.
int renderer_split(const struct renderer *renderer, int width);
struct renderer *renderer_at(struct renderer *renderer, int width, int x);

// ---- The march of one ray ----

// Return the eye of a picture, from which its rays start. A selected ray keeps the eye with which
// it was selected, so that the ray does not move in space when the camera moves on.
struct renderer_eye renderer_eye_of(const struct renderer *renderer,
                                    const struct renderer_inputs *inputs);

// March the ray of pixel (x, y), 0,0 at the bottom left, from inputs->eye. Read back every step,
// with its position in the picture, and the pixel's colour in the current view or, if that is the
// slice or the plot, in the picture view. Outside the course's dialect, only the colour is known.
// Returns false after reporting the error if the driver fails.
bool renderer_probe(struct renderer *renderer, const struct renderer_inputs *inputs, int x, int y,
                    struct probe *probe);

// The march that a slice shows, or whose steps a picture reads.
struct march {
    int pixel[2];
    int steps; // number of steps in renderer->table
    float at;  // the step shown, from 0, with a fraction of the next one; -1 if there is none
    enum probe_end end;
    struct slice_frame frame;
    struct plot_frame plot;        // frame of a plot, below the slice
    float step[RENDERER_STEPS][2]; // t and distance of the first steps
};

// Return the inputs of the same picture, seen from the eye of the selected ray.
struct renderer_inputs renderer_from_eye(const struct renderer_inputs *inputs);

// March the ray of pixel (x, y). Its steps stay in renderer->table.
// Returns false after reporting the error.
bool renderer_march(struct renderer *renderer, const struct renderer_inputs *inputs, int x, int y,
                    struct probe *probe);

// March the selected ray, or the middle one if none is selected, and find the frame that shows it.
//   beside  a second renderer, whose distances must also fit into a plot; NULL if there is none
// Returns false after reporting the error.
bool renderer_march_selected(struct renderer *renderer, struct renderer *beside,
                             const struct renderer_inputs *inputs, struct march *march);

// Set the uniforms of shaders/slice.glsl and plot.glsl, or of shaders/marched.glsl. The slice reads
// the table from texture unit 0, which is a sampler's default.
void renderer_set_slice(const struct renderer *renderer, const struct march *march);
void renderer_set_steps(const struct renderer *renderer, const struct march *march);

// Find the positions of a march's steps in the picture: all are in the ray's pixel or, if the ray
// does not start at the camera, in the pixels whose rays pass through the steps.
//   probe  the probe of pixel (x, y), whose steps are still in renderer->table
// Returns false after reporting the error.
bool renderer_project_steps(struct renderer *renderer, const struct renderer_inputs *inputs, int x,
                            int y, struct probe *probe);

// ---- One draw ----

// Link a view, and the programs that its pictures need: the slice and plot views show a probe, and
// a program that calls coarseStart reads the coarse pass. Thus an error in any of them is found
// while the old shader is still loaded. Returns false after reporting the error.
bool renderer_link(struct renderer *renderer, enum shader_view view);

// Delete all programs.
void renderer_unlink(struct renderer *renderer);

// True if a linked view of a course shader uses a uniform: the linker keeps only the uniforms that
// are used. Always false in other dialects, where a uniform of this name belongs to the shader's
// author.
bool renderer_reads(const struct renderer *renderer, enum shader_view view,
                    enum renderer_uniform uniform);

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
};

// Draw the triangle into the current target, with the current viewport and scissor.
//   bottom  the row of the picture that is the target's bottom row
void renderer_pass(const struct renderer *renderer, const struct renderer_sample *sample,
                   int bottom);

// Draw a rectangle of texels into a table, which must be bound, with a single sample per texel.
void renderer_fill(const struct renderer *renderer, const struct target *table, int left,
                   int bottom, int width, int height);

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
