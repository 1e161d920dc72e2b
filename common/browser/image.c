// Replaces picture/image_read.c and picture/image_write.c in a browser, where there is no libpng:
// stb reads PNG files, and the browser writes them.
#include "picture/image.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_MAX_DIMENSIONS IMAGE_SIDE_LIMIT
#include <stb/stb_image.h>

#include "browser/page.h"
#include "shader/text_file.h"

bool image_check_target(const char *path)
{
    (void)path;
    return true;
}

bool image_write_png(const struct image *image, const char *path)
{
    page_picture(image->pixel, image->width, image->height, path);
    return true;
}

// Convert 16-bit values to 8 bits, rounded as libpng rounds them.
static void round_to_bytes(unsigned char *to, const stbi_us *from, size_t count)
{
    for (size_t i = 0; i < count; i++)
        to[i] = (unsigned char)((from[i] * 255u + 32895u) >> 16);
}

static bool decode(struct image_bytes *bytes, FILE *file, size_t most, char why[IMAGE_WHY])
{
    int own;
    if (stbi_info_from_file(file, &bytes->width, &bytes->height, &own) &&
        (size_t)bytes->width * (size_t)bytes->height > most) {
        snprintf(why, IMAGE_WHY, "too many pixels: make the picture's sides half as long");
        return false;
    }
    if (stbi_is_16_bit_from_file(file)) {
        stbi_us *wide =
            stbi_load_from_file_16(file, &bytes->width, &bytes->height, &own, bytes->channels);
        bytes->value = (unsigned char *)wide;
        if (wide != NULL)
            round_to_bytes(bytes->value, wide,
                           (size_t)bytes->width * (size_t)bytes->height * (size_t)bytes->channels);
    } else {
        bytes->value =
            stbi_load_from_file(file, &bytes->width, &bytes->height, &own, bytes->channels);
    }
    if (bytes->value == NULL)
        snprintf(why, IMAGE_WHY, "cannot be read: %s: save it again as a PNG",
                 stbi_failure_reason());
    return bytes->value != NULL;
}

bool image_read_bytes(struct image_bytes *bytes, const char *path, int channels, size_t most,
                      char why[IMAGE_WHY])
{
    *bytes = (struct image_bytes){.channels = channels};
    FILE *file = text_file_open(path, why);
    bool done = file != NULL && decode(bytes, file, most, why);
    if (file != NULL)
        fclose(file);
    return done;
}
