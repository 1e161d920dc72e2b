// picture.c - tests the pictures that the renderer draws with a shader: positions of pixels,
// samples, tiles, bands and bytes. The pictures are compared with colours that C computes for the
// same positions, or with the same picture at another size.
#include "lib/test.h"
#include "lib/compare.h"
#include "lib/gpu.h"
#include "lib/scratch.h"

static void load_chapter(const char *stem)
{
    gpu_open_chapter(stem);
}

// Draw the whole picture, in bands of at most band rows, and return it as floats. The caller frees
// them.
static float *draw(const struct renderer_inputs *inputs, int band)
{
    size_t row = 4 * (size_t)inputs->width;
    float *values = malloc(row * (size_t)inputs->height * sizeof *values);
    assert_non_null(values);
    for (int bottom = 0; bottom < inputs->height; bottom += band) {
        int rows = inputs->height - bottom < band ? inputs->height - bottom : band;
        assert_true(renderer_draw(&gpu.renderer, inputs, bottom, rows));
        target_read(&gpu.renderer.picture, gpu.renderer.gl, values + row * (size_t)bottom);
    }
    return values;
}

// ---- The position of each pixel ----

// Two shaders whose colour is 0.5 plus a quarter of the pixel's position. The colour is not clamped
// for positions within [-2, 2] on both axes.
#define COURSE_POSITION                                                                            \
    GPU_COURSE                                                                                     \
    "vec3 rayColour(Ray ray) { return 0.5 + 0.25 * ray.origin; }\n"

#define WHOLE_POSITION                                                                             \
    "#version 330 core\n"                                                                          \
    "in vec2 FragCoord;\n"                                                                         \
    "out vec4 colour;\n"                                                                           \
    "void main() { colour = vec4(0.5 + 0.25 * FragCoord, 0.5, 1.0); }\n"

// The largest difference along an axis, in pixels, between the position that a pixel shows and its
// true position.
static double worst_position(const struct renderer_inputs *inputs, int band)
{
    float *values = draw(inputs, band);
    double worst = 0.0;
    for (int y = 0; y < inputs->height; y++)
        for (int x = 0; x < inputs->width; x++) {
            const float *value = values + 4 * ((size_t)inputs->width * (size_t)y + (size_t)x);
            double screen[2] = {(2.0 * x + 1.0 - inputs->width) / inputs->height,
                                (2.0 * y + 1.0 - inputs->height) / inputs->height};
            for (int k = 0; k < 2; k++)
                worst = fmax(worst, fabs(4.0 * ((double)value[k] - 0.5) - screen[k]));
        }
    free(values);
    return worst * inputs->height / 2.0;
}

// A float stores 0.5 + screen / 4 with an error of at most 2^-24, which is 4 * 2^-24 * height / 2
// pixels. An interpolated position has a few more rounding errors.
//   most  the largest error that is allowed, pixels
static void check_positions(const char *text, double most)
{
    assert_true(gpu_load_text(text));
    static const int sizes[][3] = {{1, 1, 1},       {2, 1, 1},      {640, 360, 360},
                                   {700, 530, 530}, {700, 530, 37}, {513, 1030, 512},
                                   {530, 700, 513}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        for (int samples = 1; samples <= 3; samples++) {
            struct renderer_inputs inputs = gpu_inputs(sizes[i][0], sizes[i][1], samples);
            double worst = worst_position(&inputs, sizes[i][2]);
            if (worst > most)
                fail_msg("%dx%d in bands of %d rows, %d samples: a pixel is %g pixels from its "
                         "true position",
                         inputs.width, inputs.height, sizes[i][2], samples, worst);
        }
}

TEST(pixels_are_at_their_positions)
{
    check_positions(COURSE_POSITION, 0.0005);
}

TEST(pixels_of_a_shader_with_its_own_main_are_at_their_positions)
{
    check_positions(WHOLE_POSITION, 0.0005);
}

// renderer_picture draws this picture in several bands. Row 0 of the image is the top row.
TEST(a_picture_of_several_bands_has_no_seam)
{
    assert_true(gpu_load_text(COURSE_POSITION));
    struct renderer_inputs inputs = gpu_inputs(10000, 450, 1);
    struct image image = {0};
    assert_true(renderer_picture(&gpu.renderer, &inputs, &image));
    int worst = 0;
    for (int y = 0; y < inputs.height; y++)
        for (int x = 0; x < inputs.width; x++) {
            double up = 1.0 - (2.0 * y + 1.0) / inputs.height;
            double right = (2.0 * x + 1.0 - inputs.width) / inputs.height;
            double truth[2] = {fmin(fmax(0.5 + 0.25 * right, 0.0), 1.0), 0.5 + 0.25 * up};
            const unsigned char *pixel =
                image.pixel + 3 * ((size_t)inputs.width * (size_t)y + (size_t)x);
            for (int k = 0; k < 2; k++) {
                int off = abs((int)pixel[k] - (int)floor(255.0 * truth[k] + 0.5));
                worst = off > worst ? off : worst;
            }
        }
    image_free(&image);
    assert_true(worst <= 1); // 1 for a value on the border between two bytes
}

// ---- Samples, bands ----

// Check that a pixel with several samples is the mean of the pixels at the same positions in a
// larger picture.
//   difference  values that differ by more than this count as different
//   most        the largest fraction of the values that may be different
static void check_mean(const char *stem, int samples, double difference, double most)
{
    load_chapter(stem);
    struct renderer_inputs small = gpu_inputs(220, 130, samples);
    struct renderer_inputs large = gpu_inputs(220 * samples, 130 * samples, 1);
    float *mean = draw(&small, small.height);
    float *all = draw(&large, large.height);
    size_t differ = 0;
    for (int y = 0; y < small.height; y++)
        for (int x = 0; x < small.width; x++)
            for (int k = 0; k < 3; k++) {
                double sum = 0.0;
                for (int j = 0; j < samples * samples; j++) {
                    size_t column = (size_t)(x * samples + j % samples);
                    size_t row = (size_t)(y * samples + j / samples);
                    sum += (double)all[4 * ((size_t)large.width * row + column) + (size_t)k];
                }
                size_t at = 4 * ((size_t)small.width * (size_t)y + (size_t)x) + (size_t)k;
                differ += fabs((double)mean[at] - sum / (samples * samples)) > difference;
            }
    free(mean);
    free(all);
    double share = (double)differ / (3.0 * small.width * small.height);
    if (share > most)
        fail_msg("%s, %d samples: the fraction of values that are not the mean is %g", stem,
                 samples, share);
}

TEST(samples_are_the_mean_of_a_larger_picture)
{
    check_mean("01_normal_colouring", 2, 1e-6, 0.0);
    check_mean("02_lighting", 2, 1e-6, 0.0);
    check_mean("03_shadows", 2, 1e-6, 0.0);
    check_mean("03_shadows", 4, 1e-6, 0.0);
}

// Thirds of a pixel, and the interpolated position that a shader with its own main reads, are not
// exact, so a few samples on edges differ.
TEST(samples_are_nearly_the_mean_of_a_larger_picture)
{
    check_mean("00_first_scene", 2, 2.0 / 255.0, IMAGE_F2_TOLERANCE);
    check_mean("00_first_scene", 3, 2.0 / 255.0, IMAGE_F2_TOLERANCE);
    check_mean("03_shadows", 3, 2.0 / 255.0, IMAGE_F2_TOLERANCE);
}

// Each sample's colour is clamped to [0, 1] before the mean. Otherwise the edge of a bright surface
// would not be smoothed.
TEST(each_sample_is_clamped)
{
    assert_true(gpu_load_text(
        GPU_COURSE "vec3 rayColour(Ray ray)\n"
                   "{\n"
                   "    float across = 0.5 * (iResolution.y * ray.origin.x + iResolution.x);\n"
                   "    return fract(across) < 0.5 ? vec3(4.0, -3.0, 0.5) : vec3(0.0, 1.0, 0.5);\n"
                   "}\n"));
    struct renderer_inputs inputs = gpu_inputs(64, 48, 2);
    float *values = draw(&inputs, inputs.height);
    for (size_t i = 0; i < 64 * 48; i++)
        for (size_t k = 0; k < 3; k++)
            assert_true(fabs((double)values[4 * i + k] - 0.5) < 1e-6);
    free(values);
}

// Check that a picture that is sharpened from the top down, in parts of any number of rows, equals
// the whole picture bit for bit, even if other pictures are drawn between the parts.
static void check_sharpened(enum shader_view view, int samples)
{
    enum { PARTS = 6 };
    static const int parts[PARTS] = {1, 64, 3, 200, 129, 133};
    struct renderer_inputs inputs = gpu_inputs(700, 530, samples);
    inputs.pixel[0] = inputs.pixel[1] = view == VIEW_SLICE ? 300 : -1;
    assert_true(renderer_set_view(&gpu.renderer, view));
    float *whole = draw(&inputs, inputs.height);
    size_t size = 4 * sizeof *whole * (size_t)inputs.width * (size_t)inputs.height;
    float *sharp = malloc(size);
    assert_non_null(sharp);
    int left = inputs.height;
    for (int i = 0; i < PARTS; i++) {
        struct renderer_inputs coarse = gpu_inputs(175, 133, 1);
        coarse.time = i;
        assert_true(renderer_draw(&gpu.renderer, &coarse, 0, coarse.height));
        left -= parts[i];
        assert_true(gpu_sharpen(&gpu.renderer, &inputs, left, parts[i]));
    }
    assert_int_equal(left, 0);
    target_read(&gpu.renderer.sharp, gpu.renderer.gl, sharp);
    assert_memory_equal(sharp, whole, size);
    free(whole);
    free(sharp);
}

TEST(a_picture_sharpened_in_parts_is_the_same_bit_for_bit)
{
    load_chapter("03_shadows");
    check_sharpened(VIEW_PICTURE, 1);
    check_sharpened(VIEW_PICTURE, 2);
    check_sharpened(VIEW_STEPS, 1);
    check_sharpened(VIEW_SLICE, 1);
    assert_true(renderer_set_view(&gpu.renderer, VIEW_PICTURE));
    load_chapter("00_first_scene");
    check_sharpened(VIEW_PICTURE, 1);
}

// ---- Uniforms ----

static GLint look_up(GLuint program, const GLchar *name)
{
    fail_msg("program %u: a draw looks up the uniform '%s'", program, name);
    return -1;
}

// The locations of uniforms are looked up when a program is linked, not when a picture is drawn.
TEST(draws_look_up_no_uniform)
{
    struct renderer_inputs inputs = gpu_inputs(32, 18, 2);
    struct probe *probe = calloc(1, sizeof *probe);
    GLint (*real)(GLuint, const GLchar *) = gpu.context.gl.GetUniformLocation;
    assert_non_null(probe);
    assert_true(gpu_load("chapters/12_textures.frag"));
    for (int i = 0; i < 2; i++) {
        assert_true(renderer_draw(&gpu.renderer, &inputs, 0, inputs.height));
        assert_true(renderer_probe(&gpu.renderer, &inputs, 16, 9, probe));
        gpu.context.gl.GetUniformLocation = look_up;
    }
    gpu.context.gl.GetUniformLocation = real;
    free(probe);
}

// ---- A driver that does not blend floats ----

static struct {
    void (*image)(GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void *);
    void (*enable)(GLenum);
    GLenum (*check)(GLenum);
    GLint format; // of the most recent texture
} driver;

static void remember_format(GLenum target, GLint level, GLint format_, GLsizei width,
                            GLsizei height, GLint border, GLenum format, GLenum type,
                            const void *pixels)
{
    driver.format = format_;
    driver.image(target, level, format_, width, height, border, format, type, pixels);
}

static void blend_no_floats(GLenum what)
{
    if (what != GL_BLEND || driver.format != GL_RGBA32F)
        driver.enable(what);
}

static GLenum make_no_floats(GLenum target)
{
    return driver.format == GL_RGBA32F ? GL_FRAMEBUFFER_UNSUPPORTED : driver.check(target);
}

TEST(without_float_targets_half_floats_are_used)
{
    struct gl *gl = &gpu.context.gl;
    renderer_close(&gpu.renderer);
    driver.image = gl->TexImage2D;
    driver.check = gl->CheckFramebufferStatus;
    gl->TexImage2D = remember_format;
    gl->CheckFramebufferStatus = make_no_floats;
    capture_begin();
    assert_true(renderer_open(&gpu.renderer, gl, gpu.root));
    assert_string_equal(capture_end(), "");
    assert_int_equal(gpu.renderer.picture.format, GL_RGBA16F);
    renderer_close(&gpu.renderer);
    gl->TexImage2D = driver.image;
    gl->CheckFramebufferStatus = driver.check;
    assert_true(renderer_open(&gpu.renderer, gl, gpu.root));
}

TEST(if_floats_do_not_blend_half_floats_are_used)
{
    struct renderer_inputs inputs = gpu_inputs(220, 130, 2);
    struct gl *gl = &gpu.context.gl;
    load_chapter("03_shadows");
    assert_int_equal(gpu.renderer.picture.format, GL_RGBA32F);
    float *wanted = draw(&inputs, 130);
    renderer_close(&gpu.renderer);
    driver.image = gl->TexImage2D;
    driver.enable = gl->Enable;
    gl->TexImage2D = remember_format;
    gl->Enable = blend_no_floats;
    assert_true(renderer_open(&gpu.renderer, gl, gpu.root));
    assert_int_equal(gpu.renderer.picture.format, GL_RGBA16F);
    load_chapter("03_shadows");
    float *halves = draw(&inputs, 130);
    // Each of the four sums is below 1, and is truncated to 11 bits.
    for (size_t i = 0; i < (size_t)(4 * 220 * 130); i++)
        if (!(fabsf(halves[i] - wanted[i]) <= 4.0f / 2048.0f))
            fail_msg("value %zu is %g, not %g", i, (double)halves[i], (double)wanted[i]);
    free(wanted);
    free(halves);
    gpu_close();
    assert_true(gpu_open());
}

// ---- Bytes ----

TEST(values_become_bytes)
{
    // A shader with its own main writes each value as red, with 0.25 as green and 0.75 as blue. The
    // value is not clamped before it is written to the target.
    static const struct {
        const char *value;
        unsigned char byte;
    } cases[] = {
        {"0.0", 0},
        {"1.0", 255},
        {"0.5", 128},
        {"2.0", 255},
        {"-1.0", 0},
        {"1.0e30", 255},
        {"0.49 / 255.0", 0},
        {"0.51 / 255.0", 1},
        {"-1.0e30", 0},
        {"99.4 / 255.0", 99},
        {"254.51 / 255.0", 255},
        {"uintBitsToFloat(0x7fc00000u)", 0},   // not a number
        {"uintBitsToFloat(0x7f800000u)", 255}, // infinity
        {"uintBitsToFloat(0xff800000u)", 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[512];
        snprintf(text, sizeof text,
                 "#version 330 core\nout vec4 colour;\n"
                 "void main() { colour = vec4(%s, 0.25, 0.75, 1.0); }\n",
                 cases[i].value);
        assert_true(gpu_load_text(text));
        struct renderer_inputs inputs = gpu_inputs(3, 2, 1);
        struct image image = {0};
        assert_true(renderer_picture(&gpu.renderer, &inputs, &image));
        for (int pixel = 0; pixel < 6; pixel++) {
            if (image.pixel[3 * pixel] != cases[i].byte)
                fail_msg("%s became %d", cases[i].value, image.pixel[3 * pixel]);
            assert_int_equal(image.pixel[3 * pixel + 1], 64);
            assert_int_equal(image.pixel[3 * pixel + 2], 191);
        }
        image_free(&image);
    }
}

// ---- Pictures after other pictures ----

// A picture is not changed by a view that is compiled later, by another picture, or by a shader
// that cannot be read.
TEST(earlier_draws_leave_no_trace)
{
    struct renderer_inputs inputs = gpu_inputs(96, 54, 1);
    load_chapter("02_lighting");
    float *first = draw(&inputs, inputs.height);

    assert_true(renderer_set_view(&gpu.renderer, VIEW_STEPS));
    float *steps = draw(&inputs, inputs.height);
    assert_memory_not_equal(first, steps, 4 * sizeof *first * 96 * 54);
    assert_true(renderer_set_view(&gpu.renderer, VIEW_PICTURE));
    struct renderer_inputs smooth = gpu_inputs(40, 30, 2);
    free(draw(&smooth, smooth.height));
    capture_begin();
    bool loaded = gpu_load_file(&gpu.renderer, "/nowhere/shader.frag");
    capture_end();
    assert_false(loaded);

    float *last = draw(&inputs, inputs.height);
    assert_memory_equal(first, last, 4 * sizeof *first * 96 * 54);
    free(first);
    free(steps);
    free(last);
}

// Whoever opens renderers when they are needed asks whether gl is NULL.
TEST(a_renderer_that_cannot_be_opened_is_closed)
{
    struct renderer renderer;
    capture_begin();
    assert_false(renderer_open(&renderer, &gpu.context.gl, "no/such/folder"));
    assert_non_null(strstr(capture_end(), "no/such/folder: cannot be read"));
    assert_null(renderer.gl);
    renderer_close(&renderer);
}

TESTS(gpu_setup, gpu_teardown)
