// buffers.c - tests exports from Shadertoy with several passes. In the ten of
// tests/shaders/buffers/, each pass stores a whole number below 8191 that it mixes from all that it
// reads; here the same numbers are computed without a driver. tests/web/buffers.mjs compares them
// with Chromium's.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/scratch.h"
#include "picture/passes.h"
#include "report.h"

enum { WIDTH = 64, HEIGHT = 32, PIXELS = WIDTH * HEIGHT, FRAME = 60, MOST = 4 };

// How the passes of an export read each other.
enum reading { BY_TEXEL, REPEATED, MIXED, MEAN, DISCARDED };

static const struct export
{
    const char *name, *row; // the letters of the buffers, in the order in which they are drawn
    enum reading reading;
}
exports[] = {{"A", "A", BY_TEXEL},         {"AB", "AB", BY_TEXEL},     {"ABCD", "ABCD", BY_TEXEL},
             {"ACBD", "ACBD", BY_TEXEL},   {"DCBA", "DCBA", BY_TEXEL}, {"BD", "BD", BY_TEXEL},
             {"repeat", "ABCD", REPEATED}, {"mixed", "ABCD", MIXED},   {"mip", "ABCD", MEAN},
             {"discard", "AB", DISCARDED}};

// What each buffer's pair of targets contains, and which of them was completed last. Buffers are
// numbered by their letters.
struct truth {
    double value[MOST][2][PIXELS];
    int last[MOST];
};

static int wrapped(int i, int size, bool repeat)
{
    return repeat ? (i + size) % size : i < 0 ? 0 : i >= size ? size - 1 : i;
}

// What a pass reads at a pixel from the buffer of a letter. In the export with mixed wraps, the
// last input that names a buffer decides: buffer A repeats, because the image asks for it last.
static double read_buffer(const struct truth *truth, enum reading reading, int letter, int x, int y)
{
    const double *value = truth->value[letter][truth->last[letter]];
    double sum = 0.0;
    if (reading == MEAN) {
        for (int i = 0; i < PIXELS; i++)
            sum += value[i];
        return floor(64.0 * sum / PIXELS);
    }
    if (reading == REPEATED || reading == MIXED) {
        bool repeat = reading == REPEATED || letter == 0;
        x = wrapped(x + 3 * letter + 1, WIDTH, repeat);
        y = wrapped(y - letter - 2, HEIGHT, repeat);
    }
    return value[x + WIDTH * y];
}

static void compute_pass(struct truth *truth, const struct export *export, int number, int frame)
{
    static const int factor[MOST] = {3, 5, 7, 11};
    int own = export->row[number] - 'A';
    double *now = truth->value[own][1 - truth->last[own]];
    double mean[MOST];
    for (int k = 0; k < MOST; k++)
        mean[k] = export->reading == MEAN ? read_buffer(truth, MEAN, k, 0, 0) : 0.0;
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            double sum = 31 * number + 7 + frame + 13.0 * (x + 0.5) + 17.0 * (y + 0.5);
            for (int k = 0; k < MOST; k++)
                if (strchr(export->row, 'A' + k) != NULL)
                    sum += factor[k] * (export->reading == MEAN
                                            ? mean[k]
                                            : read_buffer(truth, export->reading, k, x, y)) +
                           (factor[k] + 2) * HEIGHT;
            if (export->reading != DISCARDED || fmod(x + 0.5 + frame, 3.0) >= 1.0)
                now[x + WIDTH * y] = fmod(floor(sum), 8191.0);
        }
    truth->last[own] ^= 1;
}

static struct renderer_inputs at_frame(int frame)
{
    struct renderer_inputs inputs = gpu_inputs(WIDTH, HEIGHT, 1);
    inputs.rate = 60.0;
    return passes_inputs(&inputs, frame);
}

static void load(const char *name)
{
    char path[8192];
    snprintf(path, sizeof path, "%s/tests/shaders/buffers/%s.json", gpu.root, name);
    assert_true(gpu_load_file(&gpu.renderer, path));
}

// Check what each buffer keeps, and the picture, which shows three of them.
static void check(const struct export *export)
{
    struct truth *truth = calloc(1, sizeof *truth);
    struct image image;
    int count = (int)strlen(export->row);
    const struct renderer_inputs inputs = at_frame(FRAME);
    assert_non_null(truth);
    load(export->name);
    assert_int_equal(gpu.renderer.pass_count, count);
    assert_true(renderer_picture(&gpu.renderer, &inputs, &image));
    for (int frame = 0; frame <= FRAME; frame++)
        for (int i = 0; i < count; i++)
            compute_pass(truth, export, i, frame);
    for (int i = 0; i < count; i++) {
        int own = export->row[i] - 'A';
        const double *value = truth->value[own][truth->last[own]];
        float *number = calloc(4 * PIXELS, sizeof *number);
        assert_non_null(number);
        target_read(kept_frame(&gpu.renderer.pass[i].kept, FRAME), gpu.renderer.gl, number);
        for (int k = 0; k < PIXELS; k++)
            if ((double)number[4 * k] != value[k])
                fail_msg("%s: buffer %c keeps %g instead of %g at %d,%d", export->name,
                         export->row[i], (double)number[4 * k], value[k], k % WIDTH, k / WIDTH);
        free(number);
    }
    for (int k = 0; k < PIXELS; k++) {
        const unsigned char *pixel =
            image.pixel + 3 * (k % WIDTH + WIDTH * (HEIGHT - 1 - k / WIDTH));
        for (int c = 0; c < 3; c++) {
            int own = export->row[c % count] - 'A';
            assert_int_equal(pixel[c], (int)truth->value[own][truth->last[own]][k] % 256);
        }
    }
    image_free(&image);
    free(truth);
}

TEST(ten_exports_keep_exact_numbers)
{
    for (size_t i = 0; i < sizeof exports / sizeof *exports; i++)
        check(&exports[i]);
}

// ---- What passes read beside buffers ----

// An export with one buffer, whose text reads channel 1, and an image that shows the buffer.
//   input  channel 1, as JSON
static const char *export_with(const char *input, const char *code)
{
    char text[4096];
    snprintf(text, sizeof text,
             "{\"renderpass\":[{\"type\":\"image\",\"code\":\"void mainImage(out vec4 c, vec2 p) "
             "{ c = texelFetch(iChannel0, ivec2(p), 0) + texture(iChannel1, p); }\","
             "\"inputs\":[{\"channel\":0,\"ctype\":\"buffer\",\"id\":257},%s]},"
             "{\"type\":\"buffer\",\"code\":\"void mainImage(out vec4 c, vec2 p) { %s }\","
             "\"inputs\":[%s],\"outputs\":[{\"channel\":0,\"id\":257}]}]}",
             input, code, input);
    return scratch_write("export.json", text);
}

// The keyboard reads as not pressed, in all passes, and one line says so.
TEST(the_keyboard_is_black_in_every_pass)
{
    struct image image;
    const struct renderer_inputs inputs = at_frame(2);
    const char *path = export_with("{\"channel\":1,\"ctype\":\"keyboard\",\"id\":33}",
                                   "c = vec4(texture(iChannel1, p).x + 0.25);");
    assert_true(gpu_load_file(&gpu.renderer, path));
    assert_non_null(strstr(gpu.renderer.fragment.unset, "iChannel1 is the keyboard, and is black"));
    assert_string_equal(gpu.renderer.fragment.unset, gpu.renderer.pass[0].fragment.unset);
    assert_true(renderer_picture(&gpu.renderer, &inputs, &image));
    assert_int_equal(image.pixel[0], 64);
    image_free(&image);
}

// A picture that the command line gives for a channel is read instead of the buffer.
TEST(a_picture_replaces_a_buffer)
{
    char stone[8192];
    const char *channels[4] = {stone};
    struct shader_request request = {.channels = channels};
    struct shader_source source;
    struct parameters parameters;
    snprintf(stone, sizeof stone, "%s/shaders/textures/granite.png", gpu.root);
    const char *path = export_with("{}", "c = vec4(0.5);");
    assert_true(shader_read_asked(&source, path, gpu.root, &request));
    assert_true(parameters_read(&parameters, &source));
    assert_false(samplers_keep(&parameters.samplers));
    assert_int_equal(source.pass_count, 1);
    shader_free(&source);
    parameters_free(&parameters);
    assert_true(shader_read(&source, path, gpu.root));
    assert_true(parameters_read(&parameters, &source));
    assert_true(samplers_keep(&parameters.samplers));
    shader_free(&source);
    parameters_free(&parameters);
}

// If one pass has an error, the last good picture stays.
TEST(an_error_in_a_pass_is_reported)
{
    struct image image;
    const struct renderer_inputs inputs = at_frame(2);
    assert_true(gpu_load_file(&gpu.renderer, export_with("{}", "c = vec4(0.5);")));
    assert_false(gpu_load_file(&gpu.renderer, export_with("{}", "c = undeclared;")));
    assert_non_null(strstr(report_last(), "undeclared"));
    assert_true(renderer_picture(&gpu.renderer, &inputs, &image));
    assert_int_equal(image.pixel[0], 128);
    image_free(&image);
}

TESTS(gpu_setup, gpu_teardown)
