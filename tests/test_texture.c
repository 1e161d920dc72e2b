// test_texture.c - pictures that shaders read: every kind of PNG, the levels against double
// precision, and what the driver makes of them.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
// cmocka needs the four above.
#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <png.h>

#include "../common/picture/texture.h"
#include "support_gpu.h"
#include "support_scratch.h"

// ---- Files ----

// A PNG of any kind.
struct kind {
    int type, depth; // as libpng has them
    bool interlaced, transparent;
    double gamma; // that the file names; 0: none
};

static const png_color palette[16] = {{1, 2, 3}, {250, 0, 9},  {7, 99, 8},     {0, 0, 255},
                                      {9, 9, 9}, {40, 50, 60}, {255, 255, 255}};
static const png_byte palette_alpha[3] = {0, 100, 255};
static const png_color_16 clear = {.red = 3, .green = 3, .blue = 3, .gray = 1};

static int channels_of(int type)
{
    return type == PNG_COLOR_TYPE_RGB          ? 3
           : type == PNG_COLOR_TYPE_RGB_ALPHA  ? 4
           : type == PNG_COLOR_TYPE_GRAY_ALPHA ? 2
                                               : 1;
}

static void describe(png_structp png, png_infop info, const struct kind *kind, int width,
                     int height)
{
    png_set_IHDR(png, info, (png_uint_32)width, (png_uint_32)height, kind->depth, kind->type,
                 kind->interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    bool indexed = kind->type == PNG_COLOR_TYPE_PALETTE;
    if (indexed)
        png_set_PLTE(png, info, palette, kind->depth < 4 ? 1 << kind->depth : 16);
    if (kind->transparent)
        png_set_tRNS(png, info, indexed ? palette_alpha : NULL, indexed ? 2 : 0,
                     indexed ? NULL : &clear);
    if (kind->gamma > 0.0)
        png_set_gAMA(png, info, kind->gamma);
}

// Write samples, one after the other, as a PNG into the scratch folder. Returns its path.
static const char *write_png(const char *name, const struct kind *kind, int width, int height,
                             const uint16_t *sample)
{
    const char *path = scratch_path(name);
    FILE *file = fopen(path, "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, NULL, NULL);
    png_infop info = png_create_info_struct(png);
    size_t bytes = kind->depth == 16 ? 2 : 1, row = (size_t)(channels_of(kind->type) * width);
    png_byte *data = malloc(row * bytes * (size_t)height);
    assert_true(file != NULL && info != NULL);
    assert_non_null(data);
    for (size_t i = 0; i < row * (size_t)height; i++)
        if (bytes == 2) {
            data[2 * i] = (png_byte)(sample[i] >> 8);
            data[2 * i + 1] = (png_byte)sample[i];
        } else
            data[i] = (png_byte)sample[i];
    png_init_io(png, file);
    describe(png, info, kind, width, height);
    png_write_info(png, info);
    png_set_packing(png);
    int passes = png_set_interlace_handling(png);
    for (int pass = 0; pass < passes; pass++)
        for (int y = 0; y < height; y++)
            png_write_row(png, data + (size_t)y * row * bytes);
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    free(data);
    fclose(file);
    return path;
}

static uint32_t random_state = 1;

static unsigned random_below(unsigned limit)
{
    random_state = random_state * 1664525u + 1013904223u;
    return (random_state >> 8) % limit;
}

// RGBA of 8 bits: random bytes, written as a PNG. Returns its path; texel receives them, row 0 at
// the top.
static const char *write_random(const char *name, int width, int height, unsigned char *texel)
{
    const struct kind kind = {.type = PNG_COLOR_TYPE_RGB_ALPHA, .depth = 8};
    size_t count = 4 * (size_t)width * (size_t)height;
    uint16_t *sample = malloc(count * sizeof *sample);
    assert_non_null(sample);
    for (size_t i = 0; i < count; i++) {
        sample[i] = (uint16_t)random_below(256);
        if (texel != NULL)
            texel[i] = (unsigned char)sample[i];
    }
    const char *path = write_png(name, &kind, width, height, sample);
    free(sample);
    return path;
}

// ---- Every kind of PNG ----

// What a sample of some bits is with 8.
static unsigned char byte_of(unsigned sample, int depth)
{
    return (unsigned char)floor(255.0 * sample / ((1 << depth) - 1) + 0.5);
}

static void expected_texel(const struct kind *kind, const uint16_t *sample, unsigned char texel[4])
{
    bool grey = kind->type == PNG_COLOR_TYPE_GRAY || kind->type == PNG_COLOR_TYPE_GRAY_ALPHA;
    int channels = channels_of(kind->type);
    bool hidden = kind->transparent;
    if (kind->type == PNG_COLOR_TYPE_PALETTE) {
        const png_color *colour = &palette[sample[0]];
        bool listed = kind->transparent && sample[0] < 2;
        texel[0] = colour->red;
        texel[1] = colour->green;
        texel[2] = colour->blue;
        texel[3] = listed ? palette_alpha[sample[0]] : 255;
        return;
    }
    for (int i = 0; i < 3; i++) {
        texel[i] = byte_of(sample[grey ? 0 : i], kind->depth);
        hidden = hidden && sample[grey ? 0 : i] == (grey ? clear.gray : clear.red);
    }
    texel[3] = channels % 2 == 0 ? byte_of(sample[channels - 1], kind->depth) : 255;
    if (hidden)
        texel[3] = 0;
}

static void check_kind(const struct kind *kind)
{
    enum { WIDTH = 11, HEIGHT = 9 };
    uint16_t sample[4 * WIDTH * HEIGHT];
    char why[IMAGE_WHY] = "";
    struct image_bytes bytes;
    int channels = channels_of(kind->type);
    unsigned limit =
        kind->type == PNG_COLOR_TYPE_PALETTE && kind->depth == 8 ? 16 : 1u << kind->depth;
    for (int i = 0; i < channels * WIDTH * HEIGHT; i++)
        sample[i] =
            (uint16_t)(random_below(3) == 0 ? random_below(4) % limit : random_below(limit));
    sample[0] = sample[1] = sample[2] = channels == 1 ? 1 : 3; // what tRNS hides
    const char *path = write_png("kind.png", kind, WIDTH, HEIGHT, sample);
    for (int wanted = 3; wanted <= 4; wanted++) {
        if (!image_read_bytes(&bytes, path, wanted, 1000, why))
            fail_msg("type %d, %d bits: %s", kind->type, kind->depth, why);
        assert_true(bytes.width == WIDTH && bytes.height == HEIGHT && bytes.channels == wanted);
        for (int i = 0; i < WIDTH * HEIGHT; i++) {
            unsigned char texel[4];
            expected_texel(kind, sample + channels * i, texel);
            if (memcmp(texel, bytes.value + wanted * i, (size_t)wanted) != 0)
                fail_msg("type %d, %d bits, transparent %d: texel %d", kind->type, kind->depth,
                         kind->transparent, i);
        }
        free(bytes.value);
    }
}

static void every_kind_of_png_is_read(void **state)
{
    (void)state;
    static const int kinds[][2] = {{PNG_COLOR_TYPE_GRAY, 1},       {PNG_COLOR_TYPE_GRAY, 2},
                                   {PNG_COLOR_TYPE_GRAY, 4},       {PNG_COLOR_TYPE_GRAY, 8},
                                   {PNG_COLOR_TYPE_GRAY, 16},      {PNG_COLOR_TYPE_PALETTE, 1},
                                   {PNG_COLOR_TYPE_PALETTE, 2},    {PNG_COLOR_TYPE_PALETTE, 4},
                                   {PNG_COLOR_TYPE_PALETTE, 8},    {PNG_COLOR_TYPE_RGB, 8},
                                   {PNG_COLOR_TYPE_RGB, 16},       {PNG_COLOR_TYPE_RGB_ALPHA, 8},
                                   {PNG_COLOR_TYPE_RGB_ALPHA, 16}, {PNG_COLOR_TYPE_GRAY_ALPHA, 8},
                                   {PNG_COLOR_TYPE_GRAY_ALPHA, 16}};
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        for (int option = 0; option < 8; option++) {
            struct kind kind = {.type = kinds[i][0],
                                .depth = kinds[i][1],
                                .interlaced = option % 2 == 1,
                                .transparent = option / 2 % 2 == 1,
                                .gamma = option / 4 == 1 ? 1.0 : 0.0};
            if (!kind.transparent || channels_of(kind.type) % 2 == 1)
                check_kind(&kind);
        }
}

// ---- What is refused ----

static void write_bytes(const char *name, const unsigned char *bytes, size_t size)
{
    scratch_write_bytes(name, bytes, size);
}

// Returns why a picture is refused; fails where it is taken.
static const char *refusal(const char *name, int slices)
{
    static char why[IMAGE_WHY];
    struct texture_image image;
    const struct sampler sampler = {.srgb = true, .slices = slices};
    if (texture_image_read(&image, &sampler, scratch_path(name), why))
        fail_msg("%s is taken", name);
    assert_int_equal(image.count, 0);
    return why;
}

static void assert_refused(const char *name, int slices, const char *expected)
{
    const char *why = refusal(name, slices);
    if (strstr(why, expected) == NULL)
        fail_msg("%s: '%s', not '%s'", name, why, expected);
}

static void what_is_no_picture_is_refused(void **state)
{
    (void)state;
    assert_refused("none.png", 0, "No such file");
    write_bytes("empty.png", (const unsigned char *)"", 0);
    assert_refused("empty.png", 0, "cannot be read");
    write_bytes("text.png", (const unsigned char *)"P6 1 1 255 and more text", 24);
    assert_refused("text.png", 0, "cannot be read: Not a PNG file: save it again as a PNG");
    assert_int_equal(mkdir(scratch_path("folder.png"), 0700), 0);
    assert_refused("folder.png", 0, "not a regular file");
    assert_int_equal(mkfifo(scratch_path("fifo.png"), 0600), 0);
    assert_refused("fifo.png", 0, "not a regular file");
}

// Each beginning of a file, and a file with one byte changed. The last four are the checksum of the
// chunk that ends it: nothing stands in there, and libpng 1.6.48 no longer looks.
static void broken_pictures_are_refused(void **state)
{
    (void)state;
    unsigned char bytes[4096];
    struct texture_image image;
    const struct sampler sampler = {.repeat = true};
    char why[IMAGE_WHY];
    FILE *file = fopen(write_random("whole.png", 7, 5, NULL), "rb");
    assert_non_null(file);
    size_t size = fread(bytes, 1, sizeof bytes, file), taken = 0;
    fclose(file);
    for (size_t i = 0; i < size; i++) {
        write_bytes("part.png", bytes, i);
        assert_refused("part.png", 0, "cannot be read");
    }
    for (size_t i = 0; i < size - 4; i++) {
        bytes[i] ^= 0x11;
        write_bytes("part.png", bytes, size);
        bytes[i] ^= 0x11;
        taken += texture_image_read(&image, &sampler, scratch_path("part.png"), why);
        texture_image_free(&image);
    }
    assert_int_equal(taken, 0); // every other byte of this file is under a checksum
}

static void sizes_have_their_limits(void **state)
{
    (void)state;
    const struct kind kind = {.type = PNG_COLOR_TYPE_GRAY, .depth = 1};
    uint16_t *sample = calloc(16385 * 1025, sizeof *sample);
    assert_non_null(sample);
    write_png("long.png", &kind, 16385, 1, sample);
    assert_refused("long.png", 0, "longer than 16384 pixels: make it smaller");
    write_png("large.png", &kind, 16384, 1025, sample);
    assert_refused("large.png", 0, "too many pixels");
    write_png("volume.png", &kind, 4, 12, sample);
    free(sample);
    assert_refused("volume.png", 5, "5 slices do not divide its height of 12 pixels");
    assert_refused("volume.png", 24, "24 slices do not divide");
    // A width of 0 under a right checksum: libpng writes none.
    unsigned char bytes[4096];
    FILE *file = fopen(scratch_path("volume.png"), "rb");
    assert_non_null(file);
    size_t size = fread(bytes, 1, sizeof bytes, file);
    fclose(file);
    static const unsigned char none[] = {0, 0, 0, 0, 0,    0,    0,    12,  1,
                                         0, 0, 0, 0, 0x64, 0x32, 0x81, 0xC4};
    memcpy(bytes + 16, none, sizeof none);
    write_bytes("zero.png", bytes, size);
    assert_refused("zero.png", 0, "Invalid IHDR");
}

// ---- Levels ----

static double to_linear(double v)
{
    return v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
}

static double from_linear(double v)
{
    return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055;
}

// How much of cell a of n is in cell b of m, where both rows fill [0, 1].
static double common_part(int a, int n, int b, int m)
{
    double begin = fmax((double)a / n, (double)b / m);
    double end = fmin((a + 1.0) / n, (b + 1.0) / m);
    return fmax(end - begin, 0.0);
}

// The mean of a level over a texel of the next one, by its volume in common with each texel.
static double mean_over(const double *value, const int n[3], const int m[3], const int at[3],
                        int channel)
{
    double sum = 0.0, all = 0.0;
    for (int z = 0; z < n[2]; z++)
        for (int y = 0; y < n[1]; y++)
            for (int x = 0; x < n[0]; x++) {
                double part = common_part(x, n[0], at[0], m[0]) *
                              common_part(y, n[1], at[1], m[1]) * common_part(z, n[2], at[2], m[2]);
                sum += part * value[4 * ((z * n[1] + y) * n[0] + x) + channel];
                all += part;
            }
    return sum / all;
}

static void check_level(const struct texture_image *image, int level, const double *value,
                        bool srgb)
{
    const int *size = image->size[level];
    for (int i = 0; i < 4 * size[0] * size[1] * size[2]; i++) {
        double wanted = 255.0 * (srgb && i % 4 < 3 ? from_linear(value[i]) : value[i]);
        // Half a step of rounding, and what single precision may move it by.
        if (fabs(wanted - image->level[level][i]) > 0.5 + 1e-3)
            fail_msg("level %d, value %d: %d, not %f", level, i, image->level[level][i], wanted);
    }
}

static void check_levels(const int size[3], bool srgb)
{
    enum { MOST = 4 * 4096 };
    static double value[2][MOST];
    static unsigned char texel[MOST];
    int width = size[0], height = size[1] * size[2], level = 0;
    struct texture_image image;
    char why[IMAGE_WHY] = "";
    const struct sampler sampler = {.srgb = srgb, .slices = size[2]};
    if (!texture_image_read(&image, &sampler, write_random("levels.png", width, height, texel),
                            why))
        fail_msg("%s", why);
    for (int z = 0; z < size[2]; z++)
        for (int y = 0; y < size[1]; y++)
            for (int i = 0; i < 4 * width; i++) {
                // The slices from the top of the file, each with its bottom row first.
                int row = z * size[1] + size[1] - 1 - y;
                double v = texel[4 * width * row + i] / 255.0;
                value[0][4 * width * (z * size[1] + y) + i] = srgb && i % 4 < 3 ? to_linear(v) : v;
            }
    assert_memory_equal(image.size[0], size, sizeof image.size[0]);
    check_level(&image, 0, value[0], srgb);
    for (int n[3] = {size[0], size[1], size[2]}; n[0] * n[1] * n[2] > 1; level++) {
        int m[3], at[3];
        for (int i = 0; i < 3; i++)
            m[i] = n[i] > 1 ? n[i] / 2 : 1;
        double *to = value[(level + 1) % 2];
        for (at[2] = 0; at[2] < m[2]; at[2]++)
            for (at[1] = 0; at[1] < m[1]; at[1]++)
                for (at[0] = 0; at[0] < m[0]; at[0]++)
                    for (int c = 0; c < 4; c++)
                        to[4 * ((at[2] * m[1] + at[1]) * m[0] + at[0]) + c] =
                            mean_over(value[level % 2], n, m, at, c);
        assert_true(level + 1 < image.count);
        assert_memory_equal(image.size[level + 1], m, sizeof m);
        check_level(&image, level + 1, to, srgb);
        memcpy(n, m, sizeof m);
    }
    assert_int_equal(image.count, level + 1);
    texture_image_free(&image);
}

static void levels_are_means_in_linear_light(void **state)
{
    (void)state;
    static const int sizes[][3] = {{16, 16, 1}, {1, 1, 1}, {5, 3, 1}, {13, 1, 1}, {1, 6, 1},
                                   {8, 4, 4},   {5, 3, 7}, {1, 1, 9}, {3, 5, 2},  {30, 17, 1}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        for (int srgb = 0; srgb < 2; srgb++)
            check_levels(sizes[i], srgb == 1);
}

// ---- The driver ----

// A shader whose pixel (x, y) shows an expression; size of the picture in pixels.
static float *draw_expression(const char *samplers, const char *expression, int width, int height)
{
    char text[4096];
    snprintf(text, sizeof text,
             "#include \"main.glsl\"\n%s\n"
             "Ray pixelRay(vec2 screen) { return Ray(vec3(0.0), vec3(0.0, 0.0, -1.0)); }\n"
             "float sceneDistance(vec3 p) { return 1.0; }\n"
             "vec3 rayColour(Ray ray)\n{\n"
             "    vec2 pixel = floor(gl_FragCoord.xy + iPixelOffset);\n"
             "    return %s;\n}\n",
             samplers, expression);
    if (!gpu_load_text(text))
        fail_msg("does not load: %s", text);
    struct renderer_inputs inputs = {.width = width, .height = height, .samples = 1};
    float *values = gpu_numbers(&inputs);
    assert_non_null(values);
    assert_int_equal(gpu.context.gl.GetError(), GL_NO_ERROR);
    return values;
}

// A red of all bytes, from 0 on the left to 255.
static void write_ramp(void)
{
    const struct kind kind = {.type = PNG_COLOR_TYPE_GRAY, .depth = 8};
    uint16_t sample[256];
    for (int i = 0; i < 256; i++)
        sample[i] = (uint16_t)i;
    write_png("ramp.png", &kind, 256, 1, sample);
}

static void colours_are_decoded_and_numbers_are_not(void **state)
{
    (void)state;
    double worst = 0.0;
    write_ramp();
    float *values =
        draw_expression("uniform sampler2D a; // \"ramp.png\" sRGB clamp: colours\n"
                        "uniform sampler2D b; // \"ramp.png\" linear repeat: numbers\n",
                        "vec3(textureLod(a, vec2((pixel.x + 0.5) / 256.0, 0.5), 0.0).r,"
                        "     textureLod(b, vec2((pixel.x + 0.5) / 256.0, 0.5), 0.0).rg)",
                        256, 1);
    for (int i = 0; i < 256; i++) {
        worst = fmax(worst, fabs((double)values[4 * i] - to_linear(i / 255.0)));
        // Some drivers weigh neighbours with 8 bits.
        assert_true(fabs((double)values[4 * i + 1] - i / 255.0) < 0.5 / 255.0);
        assert_true(values[4 * i + 2] == values[4 * i + 1]);
    }
    free(values);
    // Mesa's polynomial is off by 0.0012; a power of 2.2 would be off by 0.008.
    if (worst > 0.002)
        fail_msg("decoded sRGB is off by %g", worst);
}

// Two by two texels, whose red tells left from right and green bottom from top; then the same with
// blue for the slices of a volume.
static void pictures_stand_upright(void **state)
{
    (void)state;
    const struct kind kind = {.type = PNG_COLOR_TYPE_RGB, .depth = 8};
    static const uint16_t sample[] = {0, 255, 0,   255, 255, 0,   0, 0, 0,   255, 0, 0,
                                      0, 255, 255, 255, 255, 255, 0, 0, 255, 255, 0, 255};
    write_png("picture.png", &kind, 2, 2, sample);
    write_png("volume.png", &kind, 2, 4, sample);
    static const char samplers[] =
        "uniform sampler2D a; // \"picture.png\" linear clamp: a\n"
        "uniform highp sampler3D v; // \"volume.png\" linear clamp 2: v\n";
    for (int i = 0; i < 2; i++) {
        float *values =
            draw_expression(samplers,
                            i == 0 ? "textureLod(a, (pixel + 0.5) / 2.0, 0.0).rgb"
                                   : "textureLod(v, vec3(mod(pixel.x, 2.0) + 0.5, pixel.y + 0.5, "
                                     "floor(pixel.x / 2.0) + 0.5) / 2.0, 0.0).rgb",
                            i == 0 ? 2 : 4, 2);
        for (int y = 0; y < 2; y++)
            for (int x = 0; x < (i == 0 ? 2 : 4); x++) {
                const float *value = values + 4 * (y * (i == 0 ? 2 : 4) + x);
                assert_true(value[0] == (float)(x % 2) && value[1] == (float)y &&
                            value[2] == (float)(x / 2));
            }
        free(values);
    }
}

static void edges_repeat_or_go_on(void **state)
{
    (void)state;
    const struct kind kind = {.type = PNG_COLOR_TYPE_GRAY, .depth = 8};
    static const uint16_t sample[] = {10, 60, 200, 250};
    static const int repeated[] = {200, 250, 10, 60, 200, 250, 10, 60},
                     clamped[] = {10, 10, 10, 60, 200, 250, 250, 250};
    write_png("four.png", &kind, 4, 1, sample);
    write_png("tower.png", &kind, 1, 4, sample);
    static const char samplers[] =
        "uniform sampler2D r; // \"four.png\" linear repeat: a\n"
        "uniform sampler2D c; // \"four.png\" linear clamp: b\n"
        "uniform highp sampler3D t; // \"tower.png\" linear repeat 4: c\n"
        "uniform highp sampler3D e; // \"tower.png\" linear clamp 4: d\n";
    static const char *const expressions[] = {
        "vec3(textureLod(r, vec2((pixel.x - 1.5) / 4.0, 7.5), 0.0).r,"
        "     textureLod(c, vec2((pixel.x - 1.5) / 4.0, 7.5), 0.0).r, 0.0)",
        "vec3(textureLod(t, vec3(-3.5, 9.5, (pixel.x - 1.5) / 4.0), 0.0).r,"
        "     textureLod(e, vec3(-3.5, 9.5, (pixel.x - 1.5) / 4.0), 0.0).r, 0.0)"};
    for (int i = 0; i < 2; i++) {
        float *values = draw_expression(samplers, expressions[i], 8, 1);
        for (int x = 0; x < 8; x++) {
            assert_true(fabs((double)values[4 * x] * 255.0 - repeated[x]) < 0.5);
            assert_true(fabs((double)values[4 * x + 1] * 255.0 - clamped[x]) < 0.5);
        }
        free(values);
    }
}

// At the middle of a level's texel, its own value: asked for by number, and by the footprint.
static void the_level_is_the_one_asked_for(void **state)
{
    (void)state;
    struct texture_image image;
    char why[IMAGE_WHY], expression[256];
    const struct sampler sampler = {.repeat = true};
    const char *path = write_random("levels.png", 16, 16, NULL);
    assert_true(texture_image_read(&image, &sampler, path, why));
    assert_int_equal(image.count, 5);
    for (int level = 0; level < 5; level++)
        for (int gradient = 0; gradient < 2; gradient++) {
            int side = 16 >> level;
            if (gradient == 0)
                snprintf(expression, sizeof expression,
                         "textureLod(a, (pixel + 0.5) / %d.0, %d.0).rgb", side, level);
            else
                snprintf(expression, sizeof expression,
                         "textureGrad(a, (pixel + 0.5) / %d.0, vec2(1.0 / %d.0, 0.0), "
                         "vec2(0.0, 1.0 / %d.0)).rgb",
                         side, side, side);
            float *values =
                draw_expression("uniform sampler2D a; // \"levels.png\" linear repeat: noise\n",
                                expression, side, side);
            for (int i = 0; i < 4 * side * side; i++)
                if (i % 4 < 3)
                    assert_true(fabs(255.0 * (double)values[i] - image.level[level][i]) < 0.6);
            free(values);
        }
    texture_image_free(&image);
}

// More samplers than any driver has units for.
static void too_many_are_refused(void **state)
{
    (void)state;
    char text[65536] = "#include \"main.glsl\"\n";
    GLint units = 0;
    gpu.context.gl.GetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &units);
    write_ramp();
    for (int i = 0; i < units; i++)
        snprintf(text + strlen(text), sizeof text - strlen(text),
                 "uniform sampler2D a%d; // \"ramp.png\" linear repeat: one of many\n", i);
    capture_begin();
    assert_false(gpu_load_text(text));
    const char *said = capture_end();
    char expected[128];
    snprintf(expected, sizeof expected, "shader.frag:%d: sampler a%d: ", units + 1, units - 1);
    assert_non_null(strstr(said, expected));
    assert_non_null(strstr(said, "the driver takes at most"));
    assert_int_equal(line_count(said), 1);
}

// A picture that cannot be read leaves the shader before, with its textures.
static void a_broken_one_keeps_the_last_good(void **state)
{
    (void)state;
    write_ramp();
    static const char samplers[] = "uniform sampler2D a; // \"ramp.png\" linear repeat: numbers\n";
    static const char expression[] = "textureLod(a, vec2((pixel.x + 0.5) / 4.0, 0.5), 6.0).rrr";
    float *before = draw_expression(samplers, expression, 4, 1);
    write_bytes("ramp.png", (const unsigned char *)"no picture", 10);
    capture_begin();
    assert_false(gpu_load_file(&gpu.renderer, scratch_path("shader.frag")));
    assert_non_null(strstr(capture_end(), "sampler a: "));
    struct renderer_inputs inputs = {.width = 4, .height = 1, .samples = 1};
    float *after = gpu_numbers(&inputs);
    assert_non_null(after);
    assert_memory_equal(before, after, 16 * sizeof *before);
    assert_true(before[0] > 0.0f && before[12] > before[0]);
    free(before);
    free(after);
}

// A sampler in a structure, which the warning says is 0, never reads what is being drawn: the third
// picture goes to the target that the second one left bound.
static void what_nothing_sets_reads_black(void **state)
{
    (void)state;
    struct renderer_inputs inputs = {.width = 4, .height = 2, .samples = 1};
    float values[4 * 4 * 2];
    capture_begin();
    assert_true(gpu_load_text("#version 330 core\nstruct S { sampler2D a; }; uniform S s;\n"
                              "out vec4 colour;\n"
                              "void main() { colour = texture(s.a, vec2(0.5)) + 0.25; }\n"));
    assert_non_null(strstr(capture_end(), "uniform S s is 0"));
    for (int i = 0; i < 3; i++) {
        assert_true(i == 1 ? renderer_sharpen(&gpu.renderer, &inputs, 0, 2)
                           : renderer_draw(&gpu.renderer, &inputs, 0, 2));
        renderer_read(&gpu.renderer, i == 1 ? &gpu.renderer.sharp : &gpu.renderer.picture, values);
        assert_true(values[0] == 0.25f && values[1] == 0.25f && values[2] == 0.25f);
    }
}

// Each backend gives the same numbers, to the bit; tests/test_images.sh adds a hidden window.
static void backends_agree(void **state)
{
    (void)state;
    static const enum context_backend backends[] = {CONTEXT_EGL, CONTEXT_OSMESA};
    static const char *const shader =
        "#include \"main.glsl\"\n"
        "uniform sampler2D a; // \"levels.png\" sRGB repeat: noise\n"
        "uniform highp sampler3D v; // \"levels.png\" linear clamp 4: noise\n"
        "Ray pixelRay(vec2 screen) { return Ray(vec3(screen, 0.0), vec3(0.0, 0.0, -1.0)); }\n"
        "float sceneDistance(vec3 p) { return 1.0; }\n"
        "vec3 rayColour(Ray ray) { vec2 p = ray.origin.xy;\n"
        "    return textureLod(a, 3.0 * p, 2.0 + 3.0 * p.x).rgb * 0.5 +\n"
        "           textureGrad(v, vec3(p, p.x * p.y), vec3(0.01), vec3(p.x, 0.1, 0.0)).rgb * 0.5; "
        "}\n";
    float *values[2] = {NULL, NULL};
    struct renderer_inputs inputs = {.width = 96, .height = 54, .samples = 2};
    write_random("levels.png", 32, 32, NULL);
    const char *path = scratch_write("shader.frag", shader);
    gpu_close();
    for (int i = 0; i < 2; i++) {
        capture_begin(); // of a backend that this machine has not
        bool opened = context_open_offscreen(&gpu.context, backends[i]);
        capture_end();
        if (!opened)
            continue;
        assert_true(renderer_open(&gpu.renderer, &gpu.context.gl, gpu.root));
        assert_true(gpu_load_file(&gpu.renderer, path));
        values[i] = gpu_numbers(&inputs);
        assert_non_null(values[i]);
        gpu_close();
    }
    assert_true(gpu_open()); // for the teardown
    if (values[0] != NULL && values[1] != NULL)
        assert_memory_equal(values[0], values[1], 4 * 96 * 54 * sizeof *values[0]);
    free(values[0]);
    free(values[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_kind_of_png_is_read),
        cmocka_unit_test(what_is_no_picture_is_refused),
        cmocka_unit_test(broken_pictures_are_refused),
        cmocka_unit_test(sizes_have_their_limits),
        cmocka_unit_test(levels_are_means_in_linear_light),
        cmocka_unit_test(colours_are_decoded_and_numbers_are_not),
        cmocka_unit_test(pictures_stand_upright),
        cmocka_unit_test(edges_repeat_or_go_on),
        cmocka_unit_test(the_level_is_the_one_asked_for),
        cmocka_unit_test(too_many_are_refused),
        cmocka_unit_test(a_broken_one_keeps_the_last_good),
        cmocka_unit_test(what_nothing_sets_reads_black),
        cmocka_unit_test(backends_agree),
    };
    return cmocka_run_group_tests_name("texture", tests, gpu_setup, gpu_teardown);
}
