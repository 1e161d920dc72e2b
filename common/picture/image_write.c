#include "picture/image.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <png.h>

#include "platform.h"
#include "report.h"

static bool refuse(const char *path, const char *why)
{
    return report("%s: cannot be written: %s", path, why);
}

bool image_check_target(const char *path)
{
    char target[PLATFORM_PATH], why[PLATFORM_WHY];
    return platform_target(path, target, why) || refuse(path, why);
}

bool image_write_png(const struct image *image, const char *path)
{
    char target[PLATFORM_PATH], why[PLATFORM_WHY];
    if (!platform_target(path, target, why))
        return refuse(path, why);
    // Fast compression takes a fifth of the time of normal compression, but the file is a third
    // larger.
    png_image png = {.version = PNG_IMAGE_VERSION,
                     .width = (png_uint_32)image->width,
                     .height = (png_uint_32)image->height,
                     .format = PNG_FORMAT_RGB,
                     .flags = PNG_IMAGE_FLAG_FAST,
                     .message = "not enough memory"};
    char *data = NULL;
    size_t size = 0;
    FILE *stream = platform_open_text(&data, &size);
    bool encoded =
        stream != NULL && png_image_write_to_stdio(&png, stream, 0, image->pixel, 0, NULL) != 0;
    if (stream != NULL && !platform_close_text(stream))
        encoded = false;
    int error = encoded ? platform_replace(target, data, size) : 0;
    free(data);
    return (encoded && error == 0) || refuse(path, encoded ? platform_why(error) : png.message);
}
