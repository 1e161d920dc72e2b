// renderer.h - one full-screen triangle, one shader, a float target: how a picture is made.
#ifndef RENDERER_H
#define RENDERER_H

#include <stdbool.h>

#include "camera.h"
#include "context/context.h"
#include "picture/image.h"
#include "picture/overlay.h"
#include "picture/probe.h"
#include "picture/texture.h"
#include "shader/parameter.h"
#include "shader/compile.h"

#define RENDERER_FOCAL_LENGTH 1.0f // for shaders that declare no focalLength of their own

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
    float zoom;   // of the slice view; 1: the whole march, as does 0
};

// A float texture to draw into.
struct renderer_target {
    GLuint framebuffer, texture;
    int width, height; // pixels
};

// Everything needed to draw one shader file. Opened once; a shader is loaded into it, and loaded
// again when its file changes.
struct renderer {
    const struct gl *gl;
    const char *root;
    struct shader_source vertex;   // shaders/screen.vert
    struct shader_source fragment; // the last one that compiled
    struct parameters parameters;  // of that one
    struct textures textures;      // of its samplers
    enum shader_view view;
    float focal_length;                   // for shaders that declare no focalLength of their own
    double orthographic;                  // OrthoView of whole files: 0 perspective, 1 orthographic
    GLuint program[SHADER_PROGRAM_COUNT]; // by view, compiled when first asked for
    GLuint used;                          // the program of the draw under way
    GLuint vertex_array;
    struct renderer_target picture;
    struct renderer_target sharp;  // a window's picture that is drawn in several frames
    struct renderer_target table;  // of a probe, one column a step: the slice view reads it
    struct renderer_target single; // of a probe: one pixel of the picture is drawn
    const struct overlay *overlay; // drawn over every written picture, not owned; NULL: none
};

// Make the triangle's vertex array and read shaders/screen.vert.
//   gl, root  must outlive the renderer
// Returns false, reported. Close with renderer_close in the same context.
bool renderer_open(struct renderer *renderer, const struct gl *gl, const char *root);
void renderer_close(struct renderer *renderer);

// Compile and link a shader, and read its textures. Parameters that it shares with the shader
// before keep their values, as parameters_keep says.
//   source, parameters  of the shader; taken over and left empty
// Returns false, reported; then both stay the caller's, and the renderer still draws the last good
// shader.
bool renderer_load(struct renderer *renderer, struct shader_source *source,
                   struct parameters *parameters);

// Choose what is shown; compiles the view when it is new. Returns false, reported, and keeps the
// old view when the shader has no such view.
bool renderer_set_view(struct renderer *renderer, enum shader_view view);

// Draw rows [bottom, bottom + rows) of the picture into the float target, tile by tile, samples x
// samples jittered passes each, averaged. Row 0 is the bottom row.
// Returns false, reported: no memory for the target, no float target.
bool renderer_draw(struct renderer *renderer, const struct renderer_inputs *inputs, int bottom,
                   int rows);

// Draw rows [from, from + rows) of the picture into a target of its own, which keeps the other rows
// as long as the picture's size stays. Rows drawn in parts are those of renderer_draw, to the bit.
// Returns false, reported.
bool renderer_sharpen(struct renderer *renderer, const struct renderer_inputs *inputs, int from,
                      int rows);

// Copy what renderer_draw drew into the framebuffer of the window, scaled to its size.
void renderer_present(struct renderer *renderer, int framebuffer_width, int framebuffer_height);

// Copy rows [from, from + rows) of what renderer_sharpen drew, pixel by pixel.
void renderer_present_sharp(struct renderer *renderer, int from, int rows);

// Draw a whole picture, with the overlay where there is one, and read it back: value v becomes
// floor(255 clamp(v, 0, 1) + 0.5).
// The caller frees image. Returns false, reported.
bool renderer_picture(struct renderer *renderer, const struct renderer_inputs *inputs,
                      struct image *image);

// Read a target: 4 floats a pixel, bottom row first.
//   target   the renderer's picture, as the last renderer_draw left it, or sharp or table
//   values   room for 4 * target->width * target->height floats, the caller's
void renderer_read(const struct renderer *renderer, const struct renderer_target *target,
                   float *values);

// What renderer_sharpen drew, as renderer_picture makes an image. Returns false, reported; the
// caller frees the image.
bool renderer_sharp_picture(struct renderer *renderer, struct image *image);

// The pixel below a place in a window, also where a high-density display has several pixels to one
// of the window's units.
//   place   from the window's top left, y down, in the window's units
//   window  width and height in these units, at least 1
//   pixel   takes the place in the picture, 0,0 bottom left
void renderer_pixel_at(const struct renderer_inputs *inputs, const double place[2],
                       const int window[2], int pixel[2]);

// March the ray of pixel (x, y), 0,0 bottom left, and bring back every step, and the colour that
// the picture has there: in the view that is shown, but for the slice, in which the pixel is
// nowhere. Of a file with a main of its own the colour alone. Returns false, reported: the driver
// failed.
bool renderer_probe(struct renderer *renderer, const struct renderer_inputs *inputs, int x, int y,
                    struct probe *probe);

#endif
