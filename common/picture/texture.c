#include "picture/texture.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "picture/colour.h"
#include "memory.h"

enum { CHANNELS = 4, BYTES = 256, WORDS = 4 }; // WORDS: numbers in a texel of a table

// ---- Values and bytes ----

// The value of each byte, and the limit above which the next byte is nearer, for a linear or an
// sRGB channel.
struct code {
    float value[BYTES], above[BYTES];
};

static void make_code(struct code *code, bool srgb)
{
    for (int i = 0; i < BYTES; i++) {
        double value = i / 255.0, above = (i + 0.5) / 255.0;
        code->value[i] = (float)(srgb ? colour_decode(value) : value);
        code->above[i] = (float)(srgb ? colour_decode(above) : above);
    }
}

// Return the byte that is nearest to a value on the encoded scale.
static unsigned char encode(const struct code *code, float value)
{
    int byte = 0;
    for (int step = BYTES / 2; step > 0; step /= 2)
        if (value >= code->above[byte + step - 1])
            byte += step;
    return (unsigned char)byte;
}

// ---- Levels ----

static size_t texels(const int size[3])
{
    return (size_t)size[0] * (size_t)size[1] * (size_t)size[2];
}

// Halve one axis: each new texel is the mean of the old texels that it covers, some of them only
// partly if the side is odd.
//   size  the size of the old values; receives that of the new values
// Returns the new values, which the caller frees, or NULL if memory is short.
static float *halve(const float *value, int size[3], int axis)
{
    size_t inner = CHANNELS, outer = 1;
    for (int i = 0; i < 3; i++)
        if (i != axis)
            *(i < axis ? &inner : &outer) *= (size_t)size[i];
    int n = size[axis], m = n / 2;
    float *result = calloc(outer * (size_t)m * inner, sizeof *result);
    for (size_t o = 0; result != NULL && o < outer; o++)
        for (int to = 0; to < m; to++)
            for (int from = to * n / m; from * m < (to + 1) * n; from++) {
                int begin = from * m > to * n ? from * m : to * n;
                int end = (from + 1) * m < (to + 1) * n ? (from + 1) * m : (to + 1) * n;
                float share = (float)(end - begin) / (float)n;
                float *sum = result + (o * (size_t)m + (size_t)to) * inner;
                const float *part = value + (o * (size_t)n + (size_t)from) * inner;
                for (size_t i = 0; i < inner; i++)
                    sum[i] += share * part[i];
            }
    size[axis] = m;
    return result;
}

// Allocate one more level. Returns NULL if memory is short.
static unsigned char *add_level(struct texture_image *image, const int size[3])
{
    unsigned char *level = calloc(texels(size), CHANNELS);
    memcpy(image->size[image->count], size, sizeof image->size[0]);
    image->level[image->count] = level;
    image->count += level != NULL;
    return level;
}

// Make the first level from a file's bytes, each slice with its bottom row first. Returns the
// level's values, which the caller frees, or NULL if memory is short.
static float *first_level(struct texture_image *image, const struct image_bytes *bytes,
                          const struct code code[2], const int size[3])
{
    size_t row = CHANNELS * (size_t)size[0], count = CHANNELS * texels(size);
    unsigned char *level = add_level(image, size), *to = level;
    float *value = level != NULL ? calloc(count, sizeof *value) : NULL;
    for (int slice = 0; level != NULL && slice < size[2]; slice++)
        for (int y = size[1] - 1; y >= 0; y--, to += row)
            memcpy(to, bytes->value + row * (size_t)(slice * size[1] + y), row);
    for (size_t i = 0; value != NULL && i < count; i++)
        value[i] = code[i % CHANNELS == CHANNELS - 1].value[level[i]];
    return value;
}

// Make the other levels from the values of the first level, and free these values. Returns false if
// memory is short.
static bool make_levels(struct texture_image *image, const struct code code[2], float *value,
                        int size[3])
{
    while (value != NULL && texels(size) > 1) {
        for (int axis = 0; axis < 3 && value != NULL; axis++)
            if (size[axis] > 1) {
                float *next = halve(value, size, axis);
                free(value);
                value = next;
            }
        unsigned char *level = value != NULL ? add_level(image, size) : NULL;
        if (level == NULL)
            break;
        for (size_t i = 0; i < CHANNELS * texels(size); i++)
            level[i] = encode(&code[i % CHANNELS == CHANNELS - 1], value[i]);
    }
    free(value);
    return image->count > 0 && texels(image->size[image->count - 1]) == 1;
}

// Make the only level of a table: four pixels of the file become the four numbers of a texel. The
// first byte of a pixel is the lowest of its number. Returns false if memory is short.
static bool make_words(struct texture_image *image, const struct image_bytes *bytes)
{
    size_t row = (size_t)bytes->width, count = row * (size_t)bytes->height;
    uint32_t *word = calloc(count, sizeof *word);
    for (size_t i = 0; word != NULL && i < count; i++) {
        const unsigned char *b =
            bytes->value + CHANNELS * (row * ((size_t)bytes->height - 1 - i / row) + i % row);
        word[i] = b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
    }
    image->size[0][0] = bytes->width / WORDS;
    image->size[0][1] = bytes->height;
    image->size[0][2] = 1;
    image->level[0] = (unsigned char *)word;
    image->count = word != NULL;
    return word != NULL;
}

// Make all levels.
//   size  width, height, slices
static bool make_image(struct texture_image *image, const struct image_bytes *bytes,
                       const struct sampler *sampler, int size[3])
{
    struct code code[2]; // for the colours, and for alpha
    make_code(&code[0], sampler->srgb);
    make_code(&code[1], false);
    return make_levels(image, code, first_level(image, bytes, code, size), size);
}

bool texture_image_read(struct texture_image *image, const struct sampler *sampler,
                        const char *path, char why[IMAGE_WHY])
{
    struct image_bytes bytes;
    *image = (struct texture_image){0};
    if (!image_read_bytes(&bytes, path, CHANNELS, TEXTURE_PIXELS, why))
        return false;
    int slices = sampler->slices > 0 ? sampler->slices : 1;
    int size[3] = {bytes.width, bytes.height / slices, slices};
    bool done = false;
    if (bytes.height % slices != 0)
        snprintf(why, IMAGE_WHY, "%d slices do not divide the height of %d pixels", slices,
                 bytes.height);
    else if (sampler->words && bytes.width % WORDS != 0)
        snprintf(why, IMAGE_WHY,
                 "a usampler2D has four pixels in each texel, and the width of %d pixels is not "
                 "divisible by four",
                 bytes.width);
    else {
        done =
            sampler->words ? make_words(image, &bytes) : make_image(image, &bytes, sampler, size);
        snprintf(why, IMAGE_WHY, "not enough memory for %dx%d pixels%s", bytes.width, bytes.height,
                 memory_limit());
    }
    free(bytes.value);
    if (!done)
        texture_image_free(image);
    return done;
}

void texture_image_free(struct texture_image *image)
{
    for (int i = 0; i < image->count; i++)
        free(image->level[i]);
    *image = (struct texture_image){0};
}

// ---- OpenGL ----

static bool within_driver(const struct gl *gl, const struct texture_image *image, bool volume,
                          char why[IMAGE_WHY])
{
    GLint most = 0;
    gl->GetIntegerv(volume ? GL_MAX_3D_TEXTURE_SIZE : GL_MAX_TEXTURE_SIZE, &most);
    for (int i = 0; i < 3; i++)
        if (image->size[0][i] > most) {
            snprintf(why, IMAGE_WHY, "a side of %d texels: the driver supports at most %d",
                     image->size[0][i], most);
            return false;
        }
    return true;
}

static bool upload(struct texture *texture, const struct gl *gl, const struct texture_image *image,
                   const struct sampler *sampler)
{
    GLint format = sampler->words ? GL_RGBA32UI : sampler->srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8;
    GLint edge = sampler->repeat ? GL_REPEAT : GL_CLAMP_TO_EDGE;
    GLenum target = texture->target;
    memcpy(texture->size, image->size[0], sizeof texture->size);
    gl->GenTextures(1, &texture->texture);
    gl->BindTexture(target, texture->texture);
    for (int i = 0; i < image->count; i++) {
        const int *size = image->size[i];
        if (target == GL_TEXTURE_3D)
            gl->TexImage3D(target, i, format, size[0], size[1], size[2], 0, GL_RGBA,
                           GL_UNSIGNED_BYTE, image->level[i]);
        else
            gl->TexImage2D(target, i, format, size[0], size[1], 0,
                           sampler->words ? GL_RGBA_INTEGER : GL_RGBA,
                           sampler->words ? GL_UNSIGNED_INT : GL_UNSIGNED_BYTE, image->level[i]);
    }
    gl->TexParameteri(target, GL_TEXTURE_MIN_FILTER,
                      sampler->words ? GL_NEAREST : GL_LINEAR_MIPMAP_LINEAR);
    gl->TexParameteri(target, GL_TEXTURE_MAG_FILTER, sampler->words ? GL_NEAREST : GL_LINEAR);
    gl->TexParameteri(target, GL_TEXTURE_WRAP_S, edge);
    gl->TexParameteri(target, GL_TEXTURE_WRAP_T, edge);
    gl->TexParameteri(target, GL_TEXTURE_WRAP_R, edge);
    return gl->GetError() == GL_NO_ERROR;
}

// A texture without a picture, which is black.
static struct texture texture_for(const struct sampler *sampler)
{
    struct texture texture = {.channel = sampler->channel,
                              .target = sampler->cube         ? GL_TEXTURE_CUBE_MAP
                                        : sampler->slices > 0 ? GL_TEXTURE_3D
                                                              : GL_TEXTURE_2D};
    memcpy(texture.name, sampler->name, sizeof texture.name);
    return texture;
}

// Load the picture of one sampler.
static bool load(struct texture *texture, const struct gl *gl, const struct sampler *sampler,
                 const char *path, char why[IMAGE_WHY])
{
    struct texture_image image;
    if (!texture_image_read(&image, sampler, path, why))
        return false;
    bool done = within_driver(gl, &image, sampler->slices > 0, why);
    if (done && !upload(texture, gl, &image, sampler)) {
        snprintf(why, IMAGE_WHY, "the driver has no room for %dx%dx%d texels", image.size[0][0],
                 image.size[0][1], image.size[0][2]);
        done = false;
    }
    texture_image_free(&image);
    return done;
}

bool textures_load(struct textures *textures, const struct gl *gl, const struct samplers *samplers,
                   const struct shader_source *source)
{
    GLint units = 0;
    char why[IMAGE_WHY];
    *textures = (struct textures){0};
    gl->GetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
    for (int i = 0; i < samplers->count; i++) {
        const struct sampler *sampler = &samplers->item[i];
        textures->item = memory_row(textures->item, i, sizeof *textures->item);
        snprintf(why, sizeof why, "the driver supports at most %d textures", units - 2);
        textures->item[textures->count++] = texture_for(sampler);
        bool black = sampler->file < 0;
        if (i + 2 < units &&
            (black || load(&textures->item[i], gl, sampler, source->paths[sampler->file], why)))
            continue;
        textures_free(textures, gl);
        return sampler_refuse(source, sampler, "%s", why);
    }
    return true;
}

void texture_borrow(struct texture *texture, const struct target *target)
{
    texture->borrowed = true;
    texture->texture = target->texture;
    texture->size[0] = target->width;
    texture->size[1] = target->height;
}

void textures_free(struct textures *textures, const struct gl *gl)
{
    for (int i = 0; i < textures->count; i++)
        if (!textures->item[i].borrowed)
            gl->DeleteTextures(1, &textures->item[i].texture);
    free(textures->item);
    *textures = (struct textures){0};
}

void textures_locate(const struct textures *textures, const struct gl *gl, GLuint program,
                     GLint *location)
{
    for (int i = 0; i < textures->count; i++, location += TEXTURE_UNIFORMS) {
        int channel = textures->item[i].channel;
        char size[96];
        location[0] = gl->GetUniformLocation(program, textures->item[i].name);
        location[1] = location[2] = -1;
        if (channel < 0)
            continue;
        snprintf(size, sizeof size, "iChannelResolution[%d]", channel);
        location[1] = gl->GetUniformLocation(program, size);
        snprintf(size, sizeof size, "u_tex%dResolution", channel);
        location[2] = gl->GetUniformLocation(program, size);
    }
}

void textures_bind(const struct textures *textures, const struct gl *gl, const GLint *location)
{
    for (int i = 0; i < textures->count; i++, location += TEXTURE_UNIFORMS) {
        const struct texture *texture = &textures->item[i];
        float width = (float)texture->size[0], height = (float)texture->size[1];
        gl->ActiveTexture(GL_TEXTURE1 + (GLenum)i);
        gl->BindTexture(texture->target, texture->texture);
        gl->Uniform1i(location[0], 1 + i);
        gl->Uniform3f(location[1], width, height, 1.0f);
        gl->Uniform2f(location[2], width, height);
    }
    gl->ActiveTexture(GL_TEXTURE0);
    gl->BindTexture(GL_TEXTURE_2D, 0);
}
