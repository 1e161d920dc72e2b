// test_coarse_pass.c - the coarse pass in the renderer: every way to draw a picture reads one
// table, to the bit, and it is there only where it is asked for.
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "support_coarse.h"
#include "support_compare.h"
#include "support_scratch.h"

// ---- One table for every way to draw ----

// A view of the wire in more than one tile, whose sides no block fills.
static struct renderer_inputs wide_inputs(int samples)
{
    struct coarse_scene scene = coarse_wire(1.0, 0.11);
    struct renderer_inputs inputs = {.width = 700, .height = 530, .samples = samples};
    inputs.camera.position[2] = 7.0f;
    assert_true(gpu_load(COARSE_SHADER));
    coarse_set_scene(&scene);
    return inputs;
}

static size_t size_of(const struct renderer_inputs *inputs)
{
    return sizeof(float[4]) * (size_t)inputs->width * (size_t)inputs->height;
}

// Any bands, also such as begin within a block; the sharpened rows of a window, with another
// picture drawn between them.
static void test_parts_of_a_picture_are_the_whole_to_the_bit(void **unused)
{
    (void)unused;
    for (int samples = 1; samples <= 2; samples++) {
        struct renderer_inputs inputs = wide_inputs(samples);
        struct renderer_inputs other = {.width = 175, .height = 133, .samples = 1};
        float *whole = coarse_picture(&inputs), *parts = malloc(size_of(&inputs));
        size_t row = 4 * (size_t)inputs.width;
        assert_non_null(parts);
        for (int bottom = 0, rows; bottom < inputs.height; bottom += rows) {
            rows = inputs.height - bottom < 37 ? inputs.height - bottom : 37;
            assert_true(renderer_draw(&gpu.renderer, &inputs, bottom, rows));
            renderer_read(&gpu.renderer, &gpu.renderer.picture, parts + row * (size_t)bottom);
        }
        assert_memory_equal(parts, whole, size_of(&inputs));
        for (int top = inputs.height, rows = 1; top > 0; top -= rows, rows = 3 * rows % 101 + 1) {
            free(coarse_picture(&other));
            rows = rows < top ? rows : top;
            assert_true(renderer_sharpen(&gpu.renderer, &inputs, top - rows, rows));
        }
        renderer_read(&gpu.renderer, &gpu.renderer.sharp, parts);
        assert_memory_equal(parts, whole, size_of(&inputs));
        free(parts);
        free(whole);
    }
}

// The probe begins where the picture does, and both are in the table, whatever was drawn between.
static void test_a_probe_begins_where_the_picture_does(void **unused)
{
    (void)unused;
    static struct probe probe;
    struct renderer_inputs inputs = wide_inputs(1), other = inputs;
    float *table = coarse_table(&inputs), *picture = coarse_picture(&inputs);
    other.camera.position[2] = 4.0f;
    for (int i = 0; i < 30; i++) {
        int x = 137 * i % inputs.width, y = (89 * i + 7) % inputs.height;
        const float *texel = table + 4 * (coarse_blocks(inputs.width) * (y / 8) + x / 8);
        const float *pixel = picture + 4 * (inputs.width * y + x);
        assert_true(pixel[2] == fminf(texel[0] / 64.0f, 1.0f));
        assert_true(renderer_draw(&gpu.renderer, &other, 0, other.height));
        assert_true(renderer_probe(&gpu.renderer, &inputs, x, y, &probe));
        assert_true(probe.interval[0] == texel[0]);
        assert_true(probe.steps == 0 || probe.step[0].t == texel[0]);
        assert_true((probe.end == PROBE_HIT) == (pixel[0] > 0.5f));
        assert_int_equal(probe.colour[2], (int)(255.0f * pixel[2] + 0.5f));
    }
    free(table);
    free(picture);
}

// Samples stand within their pixel, so one table serves them all: more samples are the pixels of a
// larger picture but for its smaller blocks, and no ray has met anything before.
static void test_samples_find_what_a_larger_picture_finds(void **unused)
{
    (void)unused;
    struct renderer_inputs small = wide_inputs(4), large = small;
    small.width /= 4, small.height /= 4;
    large.width = 4 * small.width, large.height = 4 * small.height, large.samples = 1;
    coarse_set("growth", 0.0);
    float *mean = coarse_picture(&small), *all = coarse_picture(&large);
    int differ = 0;
    for (int y = 0; y < small.height; y++)
        for (int x = 0; x < small.width; x++) {
            double sum = 0.0;
            for (int k = 0; k < 16; k++)
                sum += (double)all[4 * (large.width * (4 * y + k / 4) + 4 * x + k % 4)];
            differ += fabs(sum / 16.0 - (double)mean[4 * (small.width * y + x)]) > 1e-5;
        }
    free(mean);
    free(all);
    assert_int_equal(differ, 0);
}

// A sample that moves its ray: the margin takes it in.
static void test_rays_that_samples_move_lose_nothing(void **unused)
{
    (void)unused;
    struct renderer_inputs inputs = wide_inputs(3);
    coarse_set("growth", 0.0);
    coarse_set("moved", 0.1);
    coarse_set("threshold", 0.0001);
    float *with = coarse_picture(&inputs);
    coarse_set("coarsePass", 0.0);
    float *without = coarse_picture(&inputs);
    int differ = 0;
    for (int i = 0; i < inputs.width * inputs.height; i++)
        differ += with[4 * i] != without[4 * i];
    free(with);
    free(without);
    assert_int_equal(differ, 0);
}

// ---- The scenes of the chapters ----

// Chapter 03's march is march, 06's and 09's is marchCone: each begun by the pass.
#define BEGUN(march, arguments, chapter, margin)                                                   \
    "#include \"main.glsl\"\n#include \"cone.glsl\"\n#include \"shadow.glsl\"\n"                   \
    "#include \"coarse.glsl\"\n"                                                                   \
    "#define " march "(ray, from, to, " arguments ") " march                                       \
    "(ray, max(from, coarseStart(ray)), to, " arguments ")\n"                                      \
    "#include \"" chapter ".frag\"\n#undef " march "\n"                                            \
    "float coarseMargin(float t) { return " margin "; }\n"
#define BEGUN_CONE(chapter)                                                                        \
    BEGUN("marchCone", "threshold, spread, steps", chapter,                                        \
          "hitThreshold + footprint * pixelSpread() * t")

// With and without the pass.
static void check_chapter(const char *stem, const char *text, double threshold)
{
    struct renderer_inputs inputs = {.width = 640, .height = 360, .time = 1.0, .samples = 1};
    struct image picture[2] = {{0}, {0}};
    struct image_difference difference;
    assert_true(mirror_camera(gpu.root, stem, &inputs.camera) && gpu_load_text(text));
    coarse_set("hitThreshold", threshold);
    if (parameters_find(&gpu.renderer.parameters, "levels") != NULL)
        coarse_set("levels", 5.0); // solids that a pixel can tell apart
    if (parameters_find(&gpu.renderer.parameters, "footprint") != NULL) {
        coarse_set("footprint", 0.0);
        coarse_set("maxSteps", 500.0);
    }
    for (int i = 0; i < 2; i++) {
        coarse_set("coarsePass", i);
        assert_true(renderer_picture(&gpu.renderer, &inputs, &picture[i]));
    }
    assert_true(image_compare(&picture[0], &picture[1], &difference));
    printf("# %s: ", stem);
    image_print_difference(&difference);
    assert_true(image_same(&difference));
    image_free(&picture[0]);
    image_free(&picture[1]);
}

// A threshold that is wide as a pixel leaves open where within it a march ends, so that any other
// start moves colours. A thin one does not.
static void test_a_thin_threshold_shows_the_same_picture(void **unused)
{
    (void)unused;
    check_chapter("03_shadows", BEGUN("march", "threshold, steps", "03_shadows", "hitThreshold"),
                  0.0005);
    check_chapter("06_sierpinski_symmetry", BEGUN_CONE("06_sierpinski_symmetry"), 0.00001);
    check_chapter("09_sky_and_sunset", BEGUN_CONE("09_sky_and_sunset"), 0.0001);
}

static void test_backends_agree_to_the_bit(void **unused)
{
    (void)unused;
    static const enum context_backend backends[] = {CONTEXT_EGL, CONTEXT_OSMESA};
    struct renderer_inputs inputs = wide_inputs(2);
    struct coarse_scene scene = coarse_wire(1.0, 0.11);
    float *first = coarse_picture(&inputs);
    gpu_close();
    for (int i = 0; i < 2; i++) {
        capture_begin(); // of a backend that this machine has not
        bool opened = context_open_offscreen(&gpu.context, backends[i]);
        capture_end();
        if (!opened)
            continue;
        assert_true(renderer_open(&gpu.renderer, &gpu.context.gl, gpu.root));
        assert_true(gpu_load(COARSE_SHADER));
        coarse_set_scene(&scene);
        float *values = coarse_picture(&inputs);
        assert_memory_equal(values, first, size_of(&inputs));
        free(values);
        gpu_close();
    }
    free(first);
    assert_true(gpu_open());
}

// ---- Only where it is asked for ----

static void test_switched_off_there_is_no_pass(void **unused)
{
    (void)unused;
    struct renderer_inputs inputs = wide_inputs(1);
    gpu_close();
    assert_true(gpu_open());
    assert_true(gpu_load(COARSE_SHADER));
    coarse_set("coarsePass", 0.0);
    float *picture = coarse_picture(&inputs);
    assert_int_equal(gpu.renderer.coarse.width, 0);
    for (int i = 0; i < inputs.width * inputs.height; i++)
        assert_true(picture[4 * i + 2] == 0.0f);
    free(picture);
}

static void test_a_shader_that_does_not_ask_gets_no_pass(void **unused)
{
    (void)unused;
    struct renderer_inputs inputs = {.width = 64, .height = 36, .samples = 1};
    gpu_close();
    assert_true(gpu_open());
    assert_true(gpu_load("chapters/03_shadows.frag"));
    free(coarse_picture(&inputs));
    // The file is there, but nothing calls coarseStart; nor need coarseMargin be there then.
    assert_true(
        gpu_load_text("#include \"main.glsl\"\n#include \"coarse.glsl\"\n"
                      "Ray pixelRay(vec2 s) { return Ray(vec3(s, 0.0), vec3(0.0, 0.0, 1.0)); }\n"
                      "float sceneDistance(vec3 p) { return 1.0; }\n"
                      "vec3 rayColour(Ray ray) { return vec3(0.5); }\n"));
    free(coarse_picture(&inputs));
    // A name of the author's own in a whole file.
    capture_begin();
    assert_true(gpu_load_text("#version 330 core\nuniform float iCoarse;\nout vec4 c;\n"
                              "void main() { c = vec4(iCoarse); }\n"));
    assert_non_null(strstr(capture_end(), "uniform float iCoarse is 0"));
    free(coarse_picture(&inputs));
    assert_int_equal(gpu.renderer.coarse.width, 0);
    assert_int_equal(gpu.renderer.program[SHADER_COARSE], 0);
}

// An error of the pass is found with the picture's, while the shader before is still there.
static void test_a_missing_margin_is_told_at_once(void **unused)
{
    (void)unused;
    struct renderer_inputs inputs = wide_inputs(1);
    float *before = coarse_picture(&inputs);
    capture_begin();
    assert_false(
        gpu_load_text("#include \"main.glsl\"\n#include \"coarse.glsl\"\n"
                      "Ray pixelRay(vec2 s) { return Ray(vec3(s, 0.0), vec3(0.0, 0.0, 1.0)); }\n"
                      "float sceneDistance(vec3 p) { return 1.0; }\n"
                      "vec3 rayColour(Ray ray) { return vec3(coarseStart(ray)); }\n"));
    assert_non_null(strstr(capture_end(), "coarseMargin"));
    float *after = coarse_picture(&inputs);
    assert_memory_equal(after, before, size_of(&inputs));
    free(before);
    free(after);
}

// A driver that makes no float target of the table's size, which is asked for before the picture's.
static GLenum no_target(GLenum target)
{
    return target == GL_FRAMEBUFFER ? GL_FRAMEBUFFER_UNSUPPORTED : 0;
}

static void test_a_driver_without_the_table_is_told(void **unused)
{
    (void)unused;
    struct renderer_inputs inputs = wide_inputs(1);
    gpu_close();
    assert_true(gpu_open());
    assert_true(gpu_load(COARSE_SHADER));
    PFNGLCHECKFRAMEBUFFERSTATUSPROC real = gpu.context.gl.CheckFramebufferStatus;
    gpu.context.gl.CheckFramebufferStatus = no_target;
    capture_begin();
    assert_null(gpu_numbers(&inputs));
    assert_non_null(strstr(capture_end(), "float target 88x67: the driver cannot make it"));
    gpu.context.gl.CheckFramebufferStatus = real;
    free(coarse_picture(&inputs));
}

#define UNIT(test) cmocka_unit_test(test)

int main(void)
{
    const struct CMUnitTest tests[] = {
        UNIT(test_parts_of_a_picture_are_the_whole_to_the_bit),
        UNIT(test_a_probe_begins_where_the_picture_does),
        UNIT(test_samples_find_what_a_larger_picture_finds),
        UNIT(test_rays_that_samples_move_lose_nothing),
        UNIT(test_a_thin_threshold_shows_the_same_picture),
        UNIT(test_backends_agree_to_the_bit),
        UNIT(test_switched_off_there_is_no_pass),
        UNIT(test_a_shader_that_does_not_ask_gets_no_pass),
        UNIT(test_a_missing_margin_is_told_at_once),
        UNIT(test_a_driver_without_the_table_is_told),
    };
    return cmocka_run_group_tests(tests, gpu_setup, gpu_teardown);
}
