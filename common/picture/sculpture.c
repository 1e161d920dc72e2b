#include "picture/sculpture.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "number.h"
#include "report.h"

#define ROUND 10000.0 // numbers are rounded to multiples of 1 / ROUND
#define MANY  100     // points after which progress is reported
#define LIMIT 1e9     // largest amount or coordinate; a float this large has no fraction

// ---- Strokes ----

void strokes_begin(struct strokes *strokes, double amount)
{
    strokes->item = memory_row(strokes->item, strokes->count, sizeof *strokes->item);
    strokes->item[strokes->count++] = (struct stroke){.amount = round(ROUND * amount) / ROUND};
}

void strokes_add(struct strokes *strokes, const double point[3])
{
    struct stroke *stroke = &strokes->item[strokes->count - 1];
    stroke->point = memory_row(stroke->point, stroke->points, sizeof *stroke->point);
    for (int i = 0; i < 3; i++)
        stroke->point[stroke->points][i] = round(ROUND * point[i]) / ROUND;
    stroke->points++;
}

void strokes_take_back(struct strokes *strokes, int count)
{
    for (; count > 0 && strokes->count > 0; count--) {
        const struct stroke *last = &strokes->item[--strokes->count];
        strokes->taken_back += last->points > 0; // a stroke without points did nothing
        free(last->point);
    }
}

bool strokes_read(struct strokes *strokes, const char *text)
{
    double value[3];
    size_t length = number_begin(text, &value[0]);
    if (length == 0 || text[length] != ',' || !(fabs(value[0]) <= LIMIT))
        return false;
    strokes_begin(strokes, value[0]);
    while (text[length] == ',') {
        for (int i = 0; i < 3; i++) {
            text += length;
            length = *text == ',' ? number_begin(++text, &value[i]) : 0;
            if (length == 0 || !(fabs(value[i]) <= LIMIT))
                return false;
        }
        strokes_add(strokes, value);
    }
    return text[length] == '\0';
}

char *stroke_text(const struct stroke *stroke)
{
    char *text, number[NUMBER_SIZE];
    FILE *stream = memory_open(&text);
    number_text(stroke->amount, number, sizeof number);
    fputs(number, stream);
    for (int i = 0; i < 3 * stroke->points; i++) {
        number_text(stroke->point[i / 3][i % 3], number, sizeof number);
        fprintf(stream, ",%s", number);
    }
    memory_close(stream);
    return text;
}

void strokes_free(struct strokes *strokes)
{
    strokes_take_back(strokes, strokes->count);
    free(strokes->item);
    *strokes = (struct strokes){0};
}

// ---- The volume ----

static size_t bytes_of(const struct sculpture *sculpture)
{
    const int *size = sculpture->tool->size;
    return 4 * (size_t)size[0] * (size_t)size[1] * (size_t)size[2];
}

// Read the volume from its file. Returns false after reporting the error.
static bool read_volume(struct sculpture *sculpture, const struct sampler *sampler,
                        const struct shader_source *source)
{
    struct texture_image image;
    char why[IMAGE_WHY];
    if (!texture_image_read(&image, sampler, source->paths[sampler->file], why)) {
        sampler_refuse(source, sampler, "%s", why);
        return false;
    }
    const int *size = sculpture->tool->size;
    bool fits = memcmp(size, image.size[0], sizeof image.size[0]) == 0;
    size_t bytes = bytes_of(sculpture);
    if (!fits) {
        sampler_refuse(source, sampler, "a stroke needs a volume of %dx%dx%d texels", size[0],
                       size[1], size[2]);
    } else {
        sculpture->original = memory_zeros(bytes, 1);
        sculpture->before = memory_zeros(bytes, 1);
        sculpture->now = memory_zeros(bytes, 1);
        memcpy(sculpture->original, image.level[0], bytes);
        memcpy(sculpture->now, image.level[0], bytes);
    }
    texture_image_free(&image);
    return fits;
}

// The number of points that have not been applied yet.
static int points_left(const struct sculpture *sculpture, const struct strokes *strokes)
{
    int count = -sculpture->points;
    for (int i = sculpture->done; strokes->item != NULL && i < strokes->count; i++)
        count += strokes->item[i].points;
    return count;
}

// Apply the points that have not been applied yet, and extend the range of changed slices. A point
// takes some milliseconds, so many points need a word of patience.
static void work(struct sculpture *sculpture, const struct strokes *strokes, int slices[2])
{
    size_t bytes = bytes_of(sculpture);
    int count = points_left(sculpture, strokes), done = 0;
    for (; strokes->item != NULL && sculpture->done < strokes->count;
         sculpture->done++, sculpture->points = 0) {
        const struct stroke *stroke = &strokes->item[sculpture->done];
        for (; sculpture->points < stroke->points; sculpture->points++) {
            int i = sculpture->points, changed[2];
            if (count > MANY && done++ % MANY == 0)
                report_progress(done - 1, count, "points of strokes");
            if (i == 0)
                memcpy(sculpture->before, sculpture->now, bytes);
            sculpture->tool->work(sculpture->now, sculpture->before,
                                  stroke->point[i > 0 ? i - 1 : 0], stroke->point[i],
                                  stroke->amount, changed);
            if (changed[0] < changed[1]) {
                slices[0] = changed[0] < slices[0] ? changed[0] : slices[0];
                slices[1] = changed[1] > slices[1] ? changed[1] : slices[1];
            }
        }
        if (sculpture->done == strokes->count - 1) // the last stroke may get more points
            break;
    }
    if (count > MANY)
        report_progress(count, count, "points of strokes");
}

// Upload slices [slices[0], slices[1]) of the texture's first level. Shaders that fetch texels do
// not read the other levels.
static void upload(const struct sculpture *sculpture, const struct gl *gl,
                   const struct texture *texture, const int slices[2])
{
    const int *size = sculpture->tool->size;
    size_t slice = 4 * (size_t)size[0] * (size_t)size[1];
    gl->BindTexture(GL_TEXTURE_3D, texture->texture);
    gl->TexSubImage3D(GL_TEXTURE_3D, 0, 0, 0, slices[0], size[0], size[1], slices[1] - slices[0],
                      GL_RGBA, GL_UNSIGNED_BYTE, sculpture->now + slice * (size_t)slices[0]);
    gl->BindTexture(GL_TEXTURE_3D, 0);
}

bool sculpture_follow(struct sculpture *sculpture, const struct gl *gl,
                      const struct textures *textures, const struct samplers *samplers,
                      const struct shader_source *source, const struct strokes *strokes)
{
    static const struct strokes none = {0};
    strokes = strokes != NULL ? strokes : &none;
    if (sculpture->tool == NULL || (strokes->count == 0 && sculpture->now == NULL))
        return true;
    int i = 0;
    while (i < textures->count && strcmp(textures->item[i].name, sculpture->tool->texture) != 0)
        i++;
    if (i == textures->count || textures->item[i].target != GL_TEXTURE_3D)
        return true;
    if (sculpture->now == NULL && !read_volume(sculpture, &samplers->item[i], source))
        return false;
    int slices[2] = {sculpture->tool->size[2], 0};
    if (strokes != sculpture->strokes || strokes->taken_back != sculpture->taken_back) {
        memcpy(sculpture->now, sculpture->original, bytes_of(sculpture));
        sculpture->strokes = strokes;
        sculpture->taken_back = strokes->taken_back;
        sculpture->done = sculpture->points = 0;
        slices[0] = 0;
        slices[1] = sculpture->tool->size[2];
    }
    work(sculpture, strokes, slices);
    if (slices[0] < slices[1])
        upload(sculpture, gl, &textures->item[i], slices);
    return true;
}

void sculpture_forget(struct sculpture *sculpture)
{
    free(sculpture->original);
    free(sculpture->before);
    free(sculpture->now);
    *sculpture = (struct sculpture){.tool = sculpture->tool};
}
