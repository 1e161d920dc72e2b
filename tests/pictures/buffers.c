// buffers.c - tests exports from Shadertoy with several passes. In the ten of
// tests/shaders/buffers/, each pass stores a whole number below 8191 that it mixes from all that it
// reads; here the same numbers are computed without a driver. tests/web/buffers.mjs compares them
// with Chromium's.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/scratch.h"
#include "picture/benchmark.h"
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

// An export with two equal buffers, whose text reads channel 1, and an image that shows the first.
//   input  channel 1, as JSON
static const char *export_with(const char *input, const char *code)
{
    char text[4096];
    snprintf(text, sizeof text,
             "{\"renderpass\":[{\"type\":\"image\",\"code\":\"void mainImage(out vec4 c, vec2 p) "
             "{ c = texelFetch(iChannel0, ivec2(p), 0) + texture(iChannel1, p); }\","
             "\"inputs\":[{\"channel\":0,\"ctype\":\"buffer\",\"id\":257},%s]},"
             "{\"type\":\"buffer\",\"code\":\"void mainImage(out vec4 c, vec2 p) { %s }\","
             "\"inputs\":[%s],\"outputs\":[{\"channel\":0,\"id\":257}]},"
             "{\"type\":\"buffer\",\"code\":\"void mainImage(out vec4 c, vec2 p) { %s }\","
             "\"inputs\":[%s],\"outputs\":[{\"channel\":0,\"id\":258}]}]}",
             input, code, input, code, input);
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
    assert_int_equal(source.pass_count, 2);
    shader_free(&source);
    parameters_free(&parameters);
    assert_true(shader_read(&source, path, gpu.root));
    assert_true(parameters_read(&parameters, &source));
    assert_true(samplers_keep(&parameters.samplers));
    shader_free(&source);
    parameters_free(&parameters);
}

// Load a file whose channel 1 reads a picture of the course, and draw a frame.
static struct image with_granite(const char *path, int frame)
{
    char stone[8192];
    const char *channels[4] = {NULL, stone};
    struct shader_request request = {.channels = channels};
    struct shader_source source;
    struct parameters parameters;
    struct image image;
    const struct renderer_inputs inputs = at_frame(frame);
    snprintf(stone, sizeof stone, "%s/shaders/textures/granite.png", gpu.root);
    assert_true(shader_read_asked(&source, path, gpu.root, &request));
    assert_true(parameters_read(&parameters, &source));
    assert_true(renderer_load(&gpu.renderer, &source, &parameters));
    assert_true(renderer_picture(&gpu.renderer, &inputs, &image));
    return image;
}

// Buffers and the picture read the pictures of the command line. The sum of both is what a single
// pass computes.
TEST(a_picture_beside_a_buffer)
{
    struct image image = with_granite(export_with("{\"channel\":1,\"ctype\":\"texture\"}",
                                                  "c = 0.5 * texture(iChannel1, p / 64.0);"),
                                      3);
    assert_null(gpu.renderer.fragment.unset);
    struct image right = with_granite(
        scratch_write("single.frag", "void mainImage(out vec4 c, vec2 p) { c = 0.5 * "
                                     "texture(iChannel1, p / 64.0) + texture(iChannel1, p); }\n"),
        0);
    for (int i = 0; i < 3 * PIXELS; i++)
        assert_true(abs(image.pixel[i] - right.pixel[i]) <= 1);
    assert_int_not_equal(image.pixel[0], image.pixel[3 * 7]);
    image_free(&image);
    image_free(&right);
}

// Between a black and a white texel, a read with the filter of the channel is a mean of both, and
// one of the nearest texel is not.
TEST(a_buffer_is_filtered_between_texels)
{
    static const char *const filters[] = {"linear", "nearest"};
    for (int i = 0; i < 2; i++) {
        char text[2048];
        struct image image;
        const struct renderer_inputs inputs = at_frame(1);
        snprintf(
            text, sizeof text,
            "{\"ver\":\"0.1\",\"renderpass\":[{\"type\":\"buffer\",\"outputs\":[{\"id\":"
            "\"4dXGR8\",\"channel\":0}],\"inputs\":[],\"code\":\"void mainImage(out vec4 c, in "
            "vec2 p) { c = vec4(p.x > 32.0); }\"},{\"type\":\"image\",\"outputs\":[{\"id\":"
            "\"4dfGRr\",\"channel\":0}],\"inputs\":[{\"channel\":0,\"type\":\"buffer\",\"id\":"
            "\"4dXGR8\",\"sampler\":{\"filter\":\"%s\",\"wrap\":\"clamp\"}}],\"code\":\"void "
            "mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, (p + vec2(0.25, 0.0)) / "
            "iResolution.xy); }\"}]}",
            filters[i]);
        assert_true(gpu_load_file(&gpu.renderer, scratch_write("filter.json", text)));
        assert_true(renderer_picture(&gpu.renderer, &inputs, &image));
        const unsigned char *pixel = image.pixel + 3 * (WIDTH / 2 - 1);
        assert_int_equal(pixel[-3], 0);
        assert_in_range(pixel[0], i == 0 ? 62 : 0, i == 0 ? 66 : 0);
        assert_int_equal(pixel[3], 255);
        image_free(&image);
    }
}

// Each line is printed once, whatever passes it is about, and those about the picture too.
TEST(a_warning_is_printed_once)
{
    static const char inputs[] = "{\"channel\":1,\"ctype\":\"keyboard\"},"
                                 "{\"channel\":2,\"ctype\":\"music\"},"
                                 "{\"channel\":3,\"ctype\":\"video\"}";
    const char *path = export_with(
        inputs, "c = texture(iChannel1, p) + texture(iChannel2, p) + smoothstep(1.0, 1.0, p.x) + "
                "texture(iChannel3, p);");
    capture_begin();
    assert_true(gpu_load_file(&gpu.renderer, path));
    const char *said = capture_end();
    int lines = 0;
    for (const char *c = said; *c != '\0'; c++)
        lines += *c == '\n';
    assert_int_equal(lines, 4);
    assert_non_null(strstr(said, "iChannel1 is the keyboard, and is black"));
    assert_non_null(strstr(said, "iChannel2 is a sound, and is black"));
    assert_non_null(strstr(said, "iChannel3 is a film, and is black"));
    assert_non_null(strstr(said, "smoothstep(1.0, 1.0, ...) divides by 0"));
}

static GLenum no_room(GLenum target)
{
    return target == GL_FRAMEBUFFER ? GL_FRAMEBUFFER_UNSUPPORTED : 0;
}

TEST(a_driver_without_room_for_the_passes_is_reported)
{
    const struct renderer_inputs inputs = at_frame(2);
    GLenum (*real)(GLenum) = gpu.context.gl.CheckFramebufferStatus;
    load("ABCD");
    gpu.context.gl.CheckFramebufferStatus = no_room;
    assert_false(renderer_draw(&gpu.renderer, &inputs, 0, HEIGHT));
    gpu.context.gl.CheckFramebufferStatus = real;
    assert_non_null(strstr(report_last(), "kept frames 64x32 (passes: 4, two pictures each)"));
    assert_true(renderer_draw(&gpu.renderer, &inputs, 0, HEIGHT));
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

// Each frame adds 1 to the bits of a number. Where that is not a number, it is drawn as 0.
TEST(an_export_keeps_patterns_of_bits)
{
    const char *count = "uvec4 last = floatBitsToUint(texelFetch(iChannel0, ivec2(p), 0)); uvec4 "
                        "start = uvec4(uint(p.x), 0x7fc00000u + uint(p.x), 0xff800001u, 5u); c = "
                        "uintBitsToFloat(iFrame == 0 ? start : last + 1u);";
    const struct renderer_inputs inputs = at_frame(9);
    static float light[4 * PIXELS];
    static uint32_t bits[4 * PIXELS];
    assert_true(gpu_load_file(
        &gpu.renderer, export_with("{\"channel\":0,\"ctype\":\"buffer\",\"id\":257}", count)));
    assert_true(renderer_draw(&gpu.renderer, &inputs, 0, HEIGHT));
    target_read(kept_frame(&gpu.renderer.pass[0].kept, 9), gpu.renderer.gl, light);
    memcpy(bits, light, sizeof bits);
    for (uint32_t i = 0; i < PIXELS; i++) {
        const uint32_t right[4] = {i % WIDTH + 9, 0x7fc00009u + i % WIDTH, 0xff80000au, 14};
        for (uint32_t k = 0; k < 4; k++)
            assert_true(bits[4 * i + k] == right[k]);
    }
}

// A pixel that is once not a number stays so, and its neighbours are not touched.
TEST(an_export_keeps_a_nan)
{
    float value[4 * PIXELS];
    const struct renderer_inputs inputs = at_frame(8);
    const char *path =
        export_with("{\"channel\":0,\"ctype\":\"buffer\",\"id\":257}",
                    "float broken = iFrame == 2 && p.x < 1.0 ? sqrt(-1.0 - iTime) : 1.0; c = "
                    "texelFetch(iChannel0, ivec2(p), 0) + broken;");
    assert_true(gpu_load_file(&gpu.renderer, path));
    assert_true(renderer_draw(&gpu.renderer, &inputs, 0, HEIGHT));
    target_read(kept_frame(&gpu.renderer.pass[0].kept, 8), gpu.renderer.gl, value);
    for (int i = 0; i < PIXELS; i++)
        assert_true(i % WIDTH == 0 ? isnan(value[4 * i]) : value[4 * i] == 9.0f);
}

// A parameter of the picture is also that of a pass, and its frames begin again when it changes.
TEST(a_pass_follows_the_picture_s_parameters)
{
    static const char other[] =
        "uniform float gain; // 0.2 in [0, 1]: brightness\n"
        "uniform sampler2D backbuffer;\nuniform vec2 resolution;\n"
        "void main() { gl_FragColor = vec4(texture2D(backbuffer, gl_FragCoord.xy / "
        "resolution).g, gain, 0.0, 1.0); }\n";
    const struct renderer_inputs inputs = at_frame(5);
    assert_true(gpu_load_file(&gpu.renderer, scratch_write("gain.frag", other)));
    for (int i = 0; i < 2; i++) {
        struct image image;
        assert_true(i == 0 || parameters_assign(&gpu.renderer.parameters, "gain=0.8"));
        assert_true(renderer_picture(&gpu.renderer, &inputs, &image));
        assert_int_equal(image.pixel[0], i == 0 ? 51 : 204);
        assert_int_equal(image.pixel[1], image.pixel[0]);
        image_free(&image);
    }
}

// A benchmark, a ray and a comparison draw the frames of an export as a picture does.
TEST(an_export_is_measured_probed_and_compared)
{
    static struct probe probe;
    struct image image;
    struct renderer other = {0};
    struct comparison comparison = {.other = &other, .divider = 0.5};
    struct benchmark benchmark = {.shader = "", .frames = 4, .inputs = at_frame(0)};
    struct renderer_inputs inputs = at_frame(BENCHMARK_WARM_UP + 3);
    load("ACBD");
    assert_true(benchmark_run(&benchmark, &gpu.context, &gpu.renderer));
    assert_int_equal(passes_drawn(&gpu.renderer, &inputs), BENCHMARK_WARM_UP + 4);
    assert_true(renderer_picture(&gpu.renderer, &inputs, &image));
    load("ACBD");
    assert_true(renderer_probe(&gpu.renderer, &inputs, 40, 10, &probe));
    assert_memory_equal(probe.colour, image.pixel + 3 * (40 + WIDTH * (HEIGHT - 1 - 10)), 3);
    image_free(&image);
    assert_true(renderer_open(&other, &gpu.context.gl, gpu.root));
    assert_true(gpu_load_file(&other, export_with("{}", "c = vec4(float(iFrame) / 255.0);")));
    gpu.renderer.comparison = &comparison;
    inputs = at_frame(20);
    assert_int_equal(passes_drawn(&gpu.renderer, &inputs), 0);
    assert_true(renderer_picture(&gpu.renderer, &inputs, &image));
    assert_int_equal(passes_drawn(&gpu.renderer, &inputs), 21);
    gpu.renderer.comparison = NULL;
    assert_int_equal(image.pixel[3 * (WIDTH - 1)], 20);
    struct image alone;
    assert_true(renderer_picture(&gpu.renderer, &inputs, &alone));
    assert_memory_equal(image.pixel, alone.pixel, 3 * WIDTH / 2);
    image_free(&alone);
    image_free(&image);
    renderer_close(&other);
}

// ---- Other tools ----

static void load_text(const char *text)
{
    assert_true(gpu_load_file(&gpu.renderer, scratch_write("own.frag", text)));
}

// Draw a frame, and return its pixel at x, y; 0,0 at the bottom left.
static const unsigned char *pixel_at(int frame, int x, int y)
{
    static unsigned char pixel[3];
    struct image image;
    const struct renderer_inputs inputs = at_frame(frame);
    assert_true(renderer_picture(&gpu.renderer, &inputs, &image));
    memcpy(pixel, image.pixel + 3 * (x + WIDTH * (HEIGHT - 1 - y)), sizeof pixel);
    image_free(&image);
    return pixel;
}

// A backbuffer contains the last picture as it was shown, in whole 255ths between 0 and 1. Red
// grows by 1.4 of 255, which is rounded to 1 in each frame; green is clamped, and then falls again.
TEST(a_backbuffer_is_the_last_picture_that_was_shown)
{
    load_text("precision highp float;\n"
              "uniform sampler2D backbuffer;\n"
              "uniform vec2 resolution;\n"
              "uniform float frame;\n"
              "void main() {\n"
              "    vec4 last = texture2D(backbuffer, gl_FragCoord.xy / resolution);\n"
              "    float step = frame < 3.5 ? 0.7 : -0.2;\n"
              "    gl_FragColor = vec4(last.r + 1.4 / 255.0, last.g + step, last.b - 0.5, 1.0);\n"
              "}\n");
    for (int frame = 0; frame < 6; frame++) {
        static const int green[] = {179, 255, 255, 255, 204, 153};
        const unsigned char *pixel = pixel_at(frame, 20, 10);
        assert_int_equal(pixel[0], frame + 1);
        assert_int_equal(pixel[1], green[frame]);
        assert_int_equal(pixel[2], 0);
    }
}

// Beside a bright column, the nearest texel is read, and beyond the edge its continuation. A
// discarded pixel is black.
TEST(a_backbuffer_is_read_at_the_nearest_texel)
{
    load_text("precision highp float;\n"
              "uniform sampler2D backbuffer;\n"
              "uniform vec2 resolution;\n"
              "uniform float frame;\n"
              "void main() {\n"
              "    vec2 p = gl_FragCoord.xy / resolution;\n"
              "    if (frame < 0.5) gl_FragColor = vec4(p.x > 0.5 ? 1.0 : 0.0);\n"
              "    else if (frame > 1.5 && p.y > 0.5) discard;\n"
              "    else gl_FragColor = vec4(texture2D(backbuffer, p + vec2(0.4 / 64.0, 0.0)).r,\n"
              "        texture2D(backbuffer, p + vec2(0.6 / 64.0, 0.0)).r,\n"
              "        texture2D(backbuffer, p + vec2(1.0, 0.0)).r, 1.0);\n"
              "}\n");
    const unsigned char *pixel = pixel_at(1, WIDTH / 2 - 1, 4);
    assert_int_equal(pixel[0], 0);
    assert_int_equal(pixel[1], 255);
    assert_int_equal(pixel[2], 255);
    pixel = pixel_at(4, WIDTH - 1, HEIGHT - 1);
    assert_int_equal(pixel[0], 0);
    pixel = pixel_at(4, WIDTH - 1, 0);
    assert_int_equal(pixel[0], 255);
}

static const char viewer[] =
    "uniform sampler2D u_doubleBuffer0, u_buffer0, u_buffer1;\n"
    "uniform vec2 u_resolution;\n"
    "uniform int u_frame;\n"
    "void main() {\n"
    "    vec2 st = gl_FragCoord.xy / u_resolution;\n"
    "#ifdef BUFFER_0\n"
    "    gl_FragColor = texture2D(u_buffer1, st) + texture2D(u_doubleBuffer0, st) + 1.0;\n"
    "#elif defined(BUFFER_1)\n"
    "    gl_FragColor = 2.0 * texture2D(u_buffer0, st);\n"
    "#elif defined(DOUBLE_BUFFER_0)\n"
    "    if (u_frame > 1 && gl_FragCoord.y < 1.0) discard;\n"
    "    gl_FragColor = texture2D(u_doubleBuffer0, st) - texture2D(u_buffer1, st);\n"
    "#else\n"
    "    gl_FragColor = vec4(texture2D(u_buffer0, st).r, texture2D(u_buffer1, st).r,\n"
    "        -texture2D(u_doubleBuffer0, st).r, 255.0) / 255.0;\n"
    "#endif\n"
    "}\n";

// Buffers come before double buffers. They are neither clamped nor rounded, and 0 where a pixel was
// discarded.
TEST(the_buffers_of_glslviewer_are_drawn_in_order)
{
    int one = 0, two = 0, both = 0;
    load_text(viewer);
    assert_int_equal(gpu.renderer.pass_count, 3);
    for (int frame = 0; frame < 8; frame++) {
        one = two + both + 1;
        two = 2 * one;
        both -= two;
        const unsigned char *pixel = pixel_at(frame, 5, 5);
        const int right[3] = {one, two, -both};
        for (int c = 0; c < 3; c++)
            assert_int_equal(pixel[c], right[c] < 0 ? 0 : right[c] > 255 ? 255 : right[c]);
    }
    assert_int_equal(pixel_at(7, 5, 0)[2], 0);
}

// Buffers are filtered, and repeat beyond their edges.
TEST(the_buffers_of_glslviewer_repeat)
{
    load_text(
        "uniform sampler2D u_buffer0;\n"
        "uniform vec2 u_resolution;\n"
        "void main() {\n"
        "#ifdef BUFFER_0\n"
        "    gl_FragColor = vec4(gl_FragCoord.x < 1.0);\n"
        "#else\n"
        "    gl_FragColor = texture2D(u_buffer0, gl_FragCoord.xy / u_resolution + vec2(0.25 / "
        "64.0, 1.0));\n"
        "#endif\n"
        "}\n");
    assert_int_equal(pixel_at(0, 0, 3)[0], 191);
    assert_int_equal(pixel_at(0, WIDTH - 1, 3)[0], 64);
}

// An error is at the line of the file, in whatever pass.
TEST(an_error_in_a_buffer_has_its_line)
{
    assert_false(gpu_load_file(&gpu.renderer,
                               scratch_write("own.frag",
                                             "uniform sampler2D u_buffer0;\n"
                                             "void main() {\n"
                                             "#ifdef BUFFER_0\n"
                                             "    gl_FragColor = vec4(undeclared);\n"
                                             "#else\n"
                                             "    gl_FragColor = texture2D(u_buffer0, vec2(0));\n"
                                             "#endif\n"
                                             "}\n")));
    assert_non_null(strstr(report_last(), "own.frag:4: "));
    assert_non_null(strstr(report_last(), "undeclared"));
}

TESTS(gpu_setup, gpu_teardown)
