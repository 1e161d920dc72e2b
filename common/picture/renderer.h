// renderer.h - one full-screen triangle, one shader, a float target: how a picture is made.
#ifndef RENDERER_H
#define RENDERER_H

#include <stdbool.h>

#include "picture/image.h"
#include "picture/pass.h"
#include "picture/probe.h"

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

// Choose what is shown, in both pictures of a pair; compiles the view when it is new. Returns
// false, reported, and keeps the old view when a shader has no such view.
bool renderer_set_view(struct renderer *renderer, enum shader_view view);

// Draw rows [bottom, bottom + rows) of the picture into the float target, tile by tile, samples x
// samples jittered passes each, averaged. Row 0 is the bottom row.
// Returns false, reported: no memory for the target, no float target.
bool renderer_draw(struct renderer *renderer, const struct renderer_inputs *inputs, int bottom,
                   int rows);

// Draw rows [from, from + rows) of the picture into a target of its own, which keeps the other rows
// as long as the picture's size stays. The top rows come first: with them the target is cleared.
// Rows drawn in parts are those of renderer_draw, to the bit.
// Returns false, reported.
bool renderer_sharpen(struct renderer *renderer, const struct renderer_inputs *inputs, int from,
                      int rows);

// Copy what renderer_draw drew into the framebuffer of the window: pixel by pixel where the sizes
// are the same, else through a filter.
//   width, height  of the framebuffer, pixels
// Returns false, reported: the driver does not take the filter.
bool renderer_present(struct renderer *renderer, enum enlarge_filter filter, int width, int height);

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
void renderer_read(const struct renderer *renderer, const struct target *target, float *values);

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

// March the ray of pixel (x, y), 0,0 bottom left, from where inputs->eye says, and bring back every
// step, where it is in the picture, and the colour that the picture has there: in the view that is
// shown, but for slice and plot, in which the pixel is nowhere. Of a file with a main of its own
// the colour alone. Returns false, reported: the driver failed.
bool renderer_probe(struct renderer *renderer, const struct renderer_inputs *inputs, int x, int y,
                    struct probe *probe);

#endif
