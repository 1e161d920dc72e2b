// texture.h - the pictures that a shader reads: from PNG files to textures of OpenGL.
#ifndef TEXTURE_H
#define TEXTURE_H

#include <stdbool.h>

#include "context/gl.h"
#include "picture/image.h"
#include "shader/sampler.h"

#define TEXTURE_LEVELS 15                // of a side of IMAGE_SIDE_LIMIT
#define TEXTURE_PIXELS ((size_t)1 << 24) // of a picture, at most: 4096 x 4096

// A picture or a volume with its levels: level 0 has its own size, each further one half of every
// side, rounded down and at least 1. A texel is the mean of what it covers, in linear light, each
// channel for itself: the box filter.
struct texture_image {
    int count;                            // of levels
    int size[TEXTURE_LEVELS][3];          // width, height, slices
    unsigned char *level[TEXTURE_LEVELS]; // RGBA; the first row is the bottom one; owned
};

// Read a picture and make its levels.
//   sampler  how it is read: its slices lie one below the other in the file, the first at the top,
//            each of them upright
//   why      receives one phrase when it cannot: what image_read_bytes refuses, slices that do not
//            fit, no memory
// Returns false then, not reported. Free with texture_image_free.
bool texture_image_read(struct texture_image *image, const struct sampler *sampler,
                        const char *path, char why[IMAGE_WHY]);
void texture_image_free(struct texture_image *image);

// A texture of OpenGL.
struct texture {
    char name[64]; // of its sampler
    GLenum target;
    GLuint texture;
    int size[2]; // pixels
};

struct textures {
    struct texture *item; // owned
    int count;
};

// Read the pictures of all samplers, in the order in which they stand there. They are read with
// linear filters, within a level and between two.
//   source  of the samplers
// Returns false, reported with file and line: texture_image_read says no, the driver has no room
// or too few units. Free with textures_free in the same context.
bool textures_load(struct textures *textures, const struct gl *gl, const struct samplers *samplers,
                   const struct shader_source *source);
void textures_free(struct textures *textures, const struct gl *gl);

// Give a program, which is in use, its textures: the units from 1 on; unit 0 stays active and
// holds none, so that a sampler which nothing sets reads black, never the picture being drawn.
// Shadertoy's iChannelResolution is told too.
void textures_bind(const struct textures *textures, const struct gl *gl, GLuint program);

#endif
