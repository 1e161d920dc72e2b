#include "picture/image.h"

#include <stdlib.h>

#include "memory.h"
#include "report.h"

enum { CHANNELS = 3 };

bool image_create(struct image *image, int width, int height)
{
    *image = (struct image){0};
    if (width < 1 || width > IMAGE_SIDE_LIMIT || height < 1 || height > IMAGE_SIDE_LIMIT)
        return report("picture %dx%d: each side must be 1 to %d pixels", width, height,
                      IMAGE_SIDE_LIMIT);
    unsigned char *pixel = calloc((size_t)width * (size_t)height, CHANNELS);
    if (pixel == NULL)
        return report("picture %dx%d: not enough memory: choose a smaller one%s", width, height,
                      memory_limit());
    *image = (struct image){.width = width, .height = height, .pixel = pixel};
    return true;
}

void image_free(struct image *image)
{
    free(image->pixel);
    *image = (struct image){0};
}

// A NaN becomes 0, because any comparison with a NaN is false.
static unsigned char byte_of(float value)
{
    float positive = value > 0.0f ? value : 0.0f;
    return (unsigned char)((positive < 1.0f ? positive : 1.0f) * 255.0f + 0.5f);
}

void image_store(struct image *image, const float *values, int bottom, int rows)
{
    for (int row = 0; row < rows; row++) {
        size_t y = (size_t)(image->height - 1 - (bottom + row));
        unsigned char *pixel = image->pixel + CHANNELS * (size_t)image->width * y;
        const float *value = values + 4 * (size_t)image->width * (size_t)row;
        for (int x = 0; x < image->width; x++)
            for (int channel = 0; channel < CHANNELS; channel++)
                pixel[CHANNELS * x + channel] = byte_of(value[4 * x + channel]);
    }
}
