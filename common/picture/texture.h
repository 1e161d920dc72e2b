// texture.h - loads the PNG files that a shader's samplers read into OpenGL textures.
#ifndef TEXTURE_H
#define TEXTURE_H

#include <stdbool.h>

#include "context/gl.h"
#include "picture/image.h"
#include "picture/target.h"
#include "shader/parameter.h"

#define TEXTURE_UNIFORMS 3  // per texture: its sampler, and its size for Shadertoy and glslViewer
#define TEXTURE_LEVELS   15 // mip levels of a picture with a side of IMAGE_SIDE_LIMIT
#define TEXTURE_PIXELS   ((size_t)1 << 24) // maximum pixels of a picture: 4096 x 4096

// A picture or a volume with its mip levels: level 0 has the full size, and each further level has
// half of every side, rounded down but at least 1. Each channel of a texel is the mean, in linear
// light, of the texels of level 0 that this texel covers, as with a box filter.
struct texture_image {
    int count;                            // number of levels
    int size[TEXTURE_LEVELS][3];          // width, height, slices
    unsigned char *level[TEXTURE_LEVELS]; // RGBA, or whole numbers of 32 bits, four for each texel,
                                          // in the machine's order; the first row is the bottom
                                          // one; owned
};

// Read a picture and compute its levels. A table of whole numbers has one level.
//   sampler  how the shader reads the picture. The slices of a volume are one below another in the
//            file; the first is at the top, and each is upright
//   why      receives one phrase on failure: that of image_read_bytes, that the slices do not
//            divide the height or four the width of a table, or that memory is short
// Returns false without reporting an error on failure. Free with texture_image_free.
bool texture_image_read(struct texture_image *image, const struct sampler *sampler,
                        const char *path, char why[IMAGE_WHY]);
void texture_image_free(struct texture_image *image);

struct texture {
    char name[64]; // the sampler's name
    int channel;   // as in struct sampler
    GLenum target;
    GLuint texture;
    bool borrowed; // the texture belongs to a target
    int size[2];   // pixels
};

struct textures {
    struct texture *item; // owned
    int count;
};

// Read the pictures of all samplers, in the samplers' order. Textures are filtered linearly, within
// a level and between levels.
//   source  the shader that declares the samplers
// Returns false after reporting the error with file and line if texture_image_read fails, or if a
// picture exceeds the driver's limits for sides, memory or texture units. Free with textures_free
// in the same context.
bool textures_load(struct textures *textures, const struct gl *gl, const struct samplers *samplers,
                   const struct shader_source *source);
void textures_free(struct textures *textures, const struct gl *gl);

// Let a sampler read what was drawn into a target.
void texture_borrow(struct texture *texture, const struct target *target);

// Look up the uniforms of a linked program that belong to its textures.
//   location  receives TEXTURE_UNIFORMS locations for each texture
void textures_locate(const struct textures *textures, const struct gl *gl, GLuint program,
                     GLint *location);

// Bind the textures for the program in use to texture units 1, 2 and so on. Unit 0 stays active and
// empty, so a sampler that nothing sets reads black, never the picture being drawn.
//   location  from textures_locate
void textures_bind(const struct textures *textures, const struct gl *gl, const GLint *location);

#endif
