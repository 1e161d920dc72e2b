#include "paint.h"

#include <math.h>
#include <setjmp.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>

#include <png.h>

#include "report.h"

// ---- Chance ----

// A bijection of the 32-bit numbers that spreads every bit over all bits (Wellons, "Prospecting for
// hash functions").
static uint32_t mix_bits(uint32_t x)
{
    x ^= x >> 16;
    x *= 0x7feb352dU;
    x ^= x >> 15;
    x *= 0x846ca68bU;
    x ^= x >> 16;
    return x;
}

uint32_t paint_hash(int i, int j, uint32_t seed)
{
    return mix_bits((uint32_t)i + mix_bits((uint32_t)j + mix_bits(seed)));
}

double paint_random(int i, int j, uint32_t seed)
{
    return paint_hash(i, j, seed) / 4294967296.0;
}

// ---- Real arithmetic ----

// The rest, x - n log 2, is at most log 2 / 2 = 0.347 in size, where 14 terms are enough:
// 0.35^15 / 15! is 1e-19. Two constants add up to log 2; n times the first constant is exact.
double paint_exp(double x)
{
    if (x < -700.0)
        return 0.0;
    double n = floor(fmin(x, 700.0) / 0.69314718055994531 + 0.5);
    double rest = (fmin(x, 700.0) - n * 0.693145751953125) - n * 1.42860682030941723212e-6;
    double sum = 1.0;
    for (int k = 14; k > 0; k--)
        sum = 1.0 + rest / k * sum;
    double factor = n < 0.0 ? 0.5 : 2.0;
    for (int i = (int)(n < 0.0 ? -n : n); i > 0; i /= 2) {
        sum *= i % 2 != 0 ? factor : 1.0;
        factor *= factor;
    }
    return sum;
}

// ---- Patterns ----

static int wrap(int i, int period)
{
    int rest = i % period;
    return rest < 0 ? rest + period : rest;
}

static double smooth(double t)
{
    return t * t * t * (t * (6.0 * t - 15.0) + 10.0);
}

double paint_step(double a, double b, double x)
{
    double t = (x - a) / (b - a);
    return smooth(t > 0.0 ? (t < 1.0 ? t : 1.0) : 0.0);
}

double paint_noise(double u, double v, int columns, int rows, uint32_t seed)
{
    double x = u * columns, y = v * rows, i = floor(x), j = floor(y);
    int left = wrap((int)i, columns), bottom = wrap((int)j, rows);
    int right = wrap(left + 1, columns), top = wrap(bottom + 1, rows);
    double s = smooth(x - i), t = smooth(y - j);
    double low = paint_random(left, bottom, seed), high = paint_random(left, top, seed);
    low += s * (paint_random(right, bottom, seed) - low);
    high += s * (paint_random(right, top, seed) - high);
    return low + t * (high - low);
}

double paint_octaves(double u, double v, int columns, int rows, int octaves, uint32_t seed)
{
    double sum = 0.0, total = 0.0, strength = 1.0;
    for (int i = 0; i < octaves; i++) {
        sum += strength * paint_noise(u, v, columns << i, rows << i, seed + (uint32_t)i);
        total += strength;
        strength *= 0.5;
    }
    return sum / total;
}

// How far a number lies outside [cell, cell + 1].
static double outside(double x, int cell)
{
    return x < cell ? cell - x : x > cell + 1 ? x - cell - 1 : 0.0;
}

struct paint_grain paint_grain(double u, double v, int columns, int rows, uint32_t seed)
{
    // The nearest cells come first, so that most of the others need not be evaluated.
    static const signed char around[25][2] = {
        {0, 0},  {1, 0},  {-1, 0},  {0, 1},  {0, -1}, {1, 1},  {-1, 1}, {1, -1},  {-1, -1},
        {2, 0},  {-2, 0}, {0, 2},   {0, -2}, {2, 1},  {2, -1}, {-2, 1}, {-2, -1}, {1, 2},
        {-1, 2}, {1, -2}, {-1, -2}, {2, 2},  {-2, 2}, {2, -2}, {-2, -2}};
    const double largest = 0.5, part = 1.0 / 1024.0;
    double x = u * columns, y = v * rows, first = 1e9, second = 1e9;
    struct paint_grain grain = {0};
    for (int i = 0; i < 25; i++) {
        int column = (int)floor(x) + around[i][0], row = (int)floor(y) + around[i][1];
        double away_x = outside(x, column), away_y = outside(y, row), far = second + largest;
        if (away_x * away_x + away_y * away_y > far * far)
            continue;
        uint32_t name = paint_hash(wrap(column, columns), wrap(row, rows), seed);
        double dx = x - column - part * (name & 1023U), dy = y - row - part * (name >> 10 & 1023U);
        double distance = sqrt(dx * dx + dy * dy) - largest * part * (name >> 20 & 1023U);
        if (distance < first) {
            second = first;
            first = distance;
            grain = (struct paint_grain){.name = mix_bits(name), .u = dx, .v = dy};
        } else if (distance < second) {
            second = distance;
        }
    }
    grain.edge = 0.5 * (second - first);
    return grain;
}

// ---- Colour ----

// The fifth root of x in (0, 1], from a fixed number of steps of Newton's method from above.
static double fifth_root(double x)
{
    double y = 1.0;
    for (int i = 0; i < 24; i++)
        y -= (y - x / (y * y * y * y)) / 5.0;
    return y;
}

// The linear light of an sRGB value in [0, 1]: x^2.4 is x^2 times the fifth root of x^2.
static double decode(double value)
{
    if (value <= 0.04045)
        return value / 12.92;
    double x = (value + 0.055) / 1.055;
    return x * x * fifth_root(x * x);
}

// The linear light of the bytes and of the limits halfway between them: entry k is the light of the
// byte value k / 2.
static const double *light_of_halves(void)
{
    static double light[511];
    if (light[510] == 0.0)
        for (int k = 0; k <= 510; k++)
            light[k] = decode(k / 510.0);
    return light;
}

// The byte is the number of limits that the light reaches.
unsigned char paint_byte(double light)
{
    const double *half = light_of_halves();
    int byte = 0;
    for (int step = 128; step > 0; step /= 2)
        byte += light >= half[2 * (byte + step) - 1] ? step : 0;
    return (unsigned char)byte;
}

double paint_light(int byte)
{
    return light_of_halves()[2 * byte];
}

void paint_colour(uint32_t code, double value[3])
{
    for (int c = 0; c < 3; c++)
        value[c] = light_of_halves()[2 * (code >> (16 - 8 * c) & 255U)];
}

void paint_scale(int count, const uint32_t *code, double x, double value[3])
{
    double position = fmin(fmax(x, 0.0), 1.0) * (count - 1);
    int i = (int)fmin(floor(position), count - 2.0);
    double next[3];
    paint_colour(code[i], value);
    paint_colour(code[i + 1], next);
    for (int c = 0; c < 3; c++)
        value[c] += (position - i) * (next[c] - value[c]);
}

// ---- The picture ----

struct picture {
    int width, height, samples;
    enum paint_kind kind;
    void (*at)(double u, double v, double *value);
};

// The mean of a pixel's samples.
static void draw_pixel(const struct picture *picture, int x, int y, double mean[4])
{
    int n = picture->samples;
    mean[0] = mean[1] = mean[2] = mean[3] = 0.0;
    for (int i = 0; i < n * n; i++) {
        double value[4] = {0.0, 0.0, 0.0, 0.0};
        picture->at((x + (i % n + 0.5) / n) / picture->width,
                    1.0 - (y + (i / n + 0.5) / n) / picture->height, value);
        for (int c = 0; c < 4; c++)
            mean[c] += value[c] / (n * n);
    }
}

// The byte that stores a number in [0, 1] unchanged; other numbers are clamped.
static unsigned char number_byte(double number)
{
    return (unsigned char)lround(255.0 * fmin(fmax(number, 0.0), 1.0));
}

static int channels_of(enum paint_kind kind)
{
    return kind == PAINT_NUMBER ? 1 : kind == PAINT_FOUR || kind == PAINT_BYTES ? 4 : 3;
}

static void draw_row(const struct picture *picture, int y, unsigned char *row)
{
    for (int x = 0; x < picture->width; x++) {
        double mean[4];
        draw_pixel(picture, x, y, mean);
        int channels = channels_of(picture->kind);
        bool light = picture->kind == PAINT_COLOUR || picture->kind == PAINT_FOUR;
        for (int c = 0; c < channels; c++)
            row[channels * x + c] = light && c < 3 ? paint_byte(mean[c]) : number_byte(mean[c]);
    }
}

static bool refuse(const char *why)
{
    return report("standard output: the picture cannot be written: %s", why);
}

// An error handler must not return to libpng, so this one jumps to the call of setjmp.
static void on_png_error(png_structp png, png_const_charp why)
{
    refuse(why);
    png_longjmp(png, 1);
}

int paint_texture(int width, int height, int samples, enum paint_kind kind,
                  void (*at)(double u, double v, double *value))
{
    const int colours[] = {
        [1] = PNG_COLOR_TYPE_GRAY, [3] = PNG_COLOR_TYPE_RGB, [4] = PNG_COLOR_TYPE_RGB_ALPHA};
    const struct picture picture = {width, height, samples, kind, at};
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, NULL, on_png_error, NULL);
    png_infop info = png != NULL ? png_create_info_struct(png) : NULL;
    unsigned char *row = malloc(4 * (size_t)width);
    if (info == NULL || row == NULL || setjmp(png_jmpbuf(png)) != 0) {
        free(row);
        png_destroy_write_struct(&png, &info);
        return EXIT_FAILURE;
    }
    png_init_io(png, stdout);
    png_set_compression_level(png, 9);
    if (kind == PAINT_BYTES) // neighbouring bytes are not alike, so differences pack no better
        png_set_filter(png, PNG_FILTER_TYPE_BASE, PNG_FILTER_NONE);
    png_set_IHDR(png, info, (png_uint_32)width, (png_uint_32)height, 8, colours[channels_of(kind)],
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_BASE, PNG_FILTER_TYPE_BASE);
    if (kind == PAINT_COLOUR || kind == PAINT_FOUR)
        png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png, info);
    for (int y = 0; y < height; y++) {
        draw_row(&picture, y, row);
        png_write_row(png, row);
    }
    png_write_end(png, NULL);
    free(row);
    png_destroy_write_struct(&png, &info);
    bool done = fflush(stdout) == 0 || refuse("is the disk full?");
    return done ? EXIT_SUCCESS : EXIT_FAILURE;
}
