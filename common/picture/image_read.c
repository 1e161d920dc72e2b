#include "picture/image.h"

#include <setjmp.h>
#include <stdio.h>
#include <stdlib.h>

#include <png.h>

#include "memory.h"
#include "shader/text_file.h"

// An error handler must not return to libpng, so this one jumps to the call of setjmp.
static void on_png_error(png_structp png, png_const_charp text)
{
    snprintf(png_get_error_ptr(png), IMAGE_WHY, "cannot be read: %s: save it again as a PNG", text);
    png_longjmp(png, 1);
}

static void refuse(png_structp png, const char *why)
{
    snprintf(png_get_error_ptr(png), IMAGE_WHY, "%s", why);
    png_longjmp(png, 1);
}

static void refuse_memory(png_structp png)
{
    char why[IMAGE_WHY];
    snprintf(why, sizeof why, "not enough memory%s", memory_limit());
    refuse(png, why);
}

static void on_png_warning(png_structp png, png_const_charp text)
{
    (void)png, (void)text;
}

// Read any kind of PNG as 8 bits per channel, with the requested number of channels, without
// applying gamma. Text chunks and colour profiles are skipped, because libpng would allocate as
// much memory as a damaged chunk claims to need, up to 2 GB. May exit through longjmp.
static void read_pixels(png_structp png, png_infop info, struct image_bytes *bytes, size_t most)
{
    png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, NULL, -1);
    png_read_info(png, info);
    size_t width = png_get_image_width(png, info), height = png_get_image_height(png, info);
    if (width > IMAGE_SIDE_LIMIT || height > IMAGE_SIDE_LIMIT)
        refuse(png, "a side is longer than 16384 pixels: make the picture smaller");
    if (width * height > most)
        refuse(png, "too many pixels: make the picture's sides half as long");
    png_set_scale_16(png);
    png_set_expand(png);
    png_set_gray_to_rgb(png);
    if (bytes->channels == 3)
        png_set_strip_alpha(png);
    else
        png_set_add_alpha(png, 0xFF, PNG_FILLER_AFTER);
    int passes = png_set_interlace_handling(png);
    png_read_update_info(png, info);
    size_t row = (size_t)bytes->channels * width;
    bytes->value = malloc(row * height);
    if (bytes->value == NULL)
        refuse_memory(png);
    bytes->width = (int)width;
    bytes->height = (int)height;
    if (png_get_rowbytes(png, info) != row)
        png_error(png, "an unsupported kind of PNG");
    for (int pass = 0; pass < passes; pass++)
        for (size_t y = 0; y < height; y++)
            png_read_row(png, bytes->value + y * row, NULL);
    png_read_end(png, NULL);
}

static bool decode(struct image_bytes *bytes, FILE *file, size_t most, char why[IMAGE_WHY])
{
    snprintf(why, IMAGE_WHY, "not enough memory%s", memory_limit());
    png_structp png =
        png_create_read_struct(PNG_LIBPNG_VER_STRING, why, on_png_error, on_png_warning);
    png_infop info = png != NULL ? png_create_info_struct(png) : NULL;
    if (info == NULL || setjmp(png_jmpbuf(png)) != 0) {
        png_destroy_read_struct(&png, &info, NULL);
        return false;
    }
    png_init_io(png, file);
    read_pixels(png, info, bytes, most);
    png_destroy_read_struct(&png, &info, NULL);
    return true;
}

bool image_read_bytes(struct image_bytes *bytes, const char *path, int channels, size_t most,
                      char why[IMAGE_WHY])
{
    *bytes = (struct image_bytes){.channels = channels};
    FILE *file = text_file_open(path, why);
    bool done = file != NULL && decode(bytes, file, most, why);
    if (!done) {
        free(bytes->value);
        bytes->value = NULL;
    }
    if (file != NULL)
        fclose(file);
    return done;
}
