// renderer.h - draws pictures with linked programs.
#ifndef RENDERER_H
#define RENDERER_H

#include "picture/image.h"
#include "picture/overlay.h"
#include "picture/probe.h"
#include "picture/renderer_pass.h"

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

// March the ray of pixel (x, y), 0,0 at the bottom left, from inputs->eye. Read back every step,
// with its position in the picture, and the pixel's colour in the current view or, if that is the
// slice or the plot, in the picture view. Outside the course's dialect, only the colour is known.
// Returns false after reporting the error if the driver fails.
bool renderer_probe(struct renderer *renderer, const struct renderer_inputs *inputs, int x, int y,
                    struct probe *probe);

#endif
