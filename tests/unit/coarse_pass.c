// coarse_pass.c - tests the renderer's coarse pass: a picture is the same, bit for bit, however it
// is drawn, because all its parts and samples start from the same table; and there is a table only
// if the shader asks for it and the pass is switched on.
#include "lib/test.h"
#include "lib/coarse.h"
#include "lib/scratch.h"

// ---- The same table however a picture is drawn ----

// Load the scene of a wire, and return the inputs of a picture that takes more than one tile and
// whose sides are not multiples of a block's side.
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

// The picture is drawn in bands, some of which begin within a block, and then in groups of rows, as
// a window sharpens a picture, with another picture drawn before each group.
TEST(test_the_parts_of_a_picture_equal_the_whole_bit_for_bit)
{
    for (int samples = 1; samples <= 2; samples++) {
        struct renderer_inputs inputs = wide_inputs(samples);
        struct renderer_inputs other = {.width = 175, .height = 133, .samples = 1};
        float *whole = gpu_numbers(&inputs), *parts = malloc(size_of(&inputs));
        size_t row = 4 * (size_t)inputs.width;
        assert_non_null(parts);
        for (int bottom = 0, rows; bottom < inputs.height; bottom += rows) {
            rows = inputs.height - bottom < 37 ? inputs.height - bottom : 37;
            assert_true(renderer_draw(&gpu.renderer, &inputs, bottom, rows));
            target_read(&gpu.renderer.picture, gpu.renderer.gl, parts + row * (size_t)bottom);
        }
        assert_memory_equal(parts, whole, size_of(&inputs));
        for (int top = inputs.height, rows = 1; top > 0; top -= rows, rows = 3 * rows % 101 + 1) {
            free(gpu_numbers(&other));
            rows = rows < top ? rows : top;
            assert_true(gpu_sharpen(&gpu.renderer, &inputs, top - rows, rows));
        }
        target_read(&gpu.renderer.sharp, gpu.renderer.gl, parts);
        assert_memory_equal(parts, whole, size_of(&inputs));
        free(parts);
        free(whole);
    }
}

// A probe's march begins at the same distance as the picture's march for the same pixel, because
// both starts come from the table, even if another picture was drawn in between.
TEST(test_a_probe_begins_where_the_picture_does)
{
    static struct probe probe;
    struct renderer_inputs inputs = wide_inputs(1), other = inputs;
    float *table = coarse_table(&inputs), *picture = gpu_numbers(&inputs);
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

// All samples are within their pixel, so the same table serves every sample. The samples agree with
// the pixels of a picture four times as wide and high, although each block of the larger picture
// covers less of the view, because no ray meets a surface before the start in either table.
TEST(test_samples_find_what_a_larger_picture_finds)
{
    struct renderer_inputs small = wide_inputs(4), large = small;
    small.width /= 4, small.height /= 4;
    large.width = 4 * small.width, large.height = 4 * small.height, large.samples = 1;
    gpu_set("growth", 0.0);
    float *mean = gpu_numbers(&small), *all = gpu_numbers(&large);
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

// Here each sample shifts its ray, and coarseMargin includes the largest shift.
TEST(test_rays_that_samples_move_lose_nothing)
{
    struct renderer_inputs inputs = wide_inputs(3);
    gpu_set("growth", 0.0);
    gpu_set("moved", 0.1);
    gpu_set("threshold", 0.0001);
    float *with = gpu_numbers(&inputs);
    gpu_set("coarsePass", 0.0);
    float *without = gpu_numbers(&inputs);
    int differ = 0;
    for (int i = 0; i < inputs.width * inputs.height; i++)
        differ += with[4 * i] != without[4 * i];
    free(with);
    free(without);
    assert_int_equal(differ, 0);
}

// ---- No table unless it is requested ----

TEST(test_there_is_no_pass_when_switched_off)
{
    struct renderer_inputs inputs = wide_inputs(1);
    gpu_close();
    assert_true(gpu_open());
    assert_true(gpu_load(COARSE_SHADER));
    gpu_set("coarsePass", 0.0);
    float *picture = gpu_numbers(&inputs);
    assert_int_equal(gpu.renderer.coarse.width, 0);
    for (int i = 0; i < inputs.width * inputs.height; i++)
        assert_true(picture[4 * i + 2] == 0.0f);
    free(picture);
}

TEST(test_a_shader_that_does_not_call_coarse_start_gets_no_pass)
{
    struct renderer_inputs inputs = {.width = 64, .height = 36, .samples = 1};
    gpu_close();
    assert_true(gpu_open());
    assert_true(gpu_load("chapters/03_shadows.frag"));
    free(gpu_numbers(&inputs));
    // coarse.glsl is included, but nothing calls coarseStart, so coarseMargin is not needed.
    assert_true(
        gpu_load_text("#include \"main.glsl\"\n#include \"coarse.glsl\"\n"
                      "Ray pixelRay(vec2 s) { return Ray(vec3(s, 0.0), vec3(0.0, 0.0, 1.0)); }\n"
                      "float sceneDistance(vec3 p) { return 1.0; }\n"
                      "vec3 rayColour(Ray ray) { return vec3(0.5); }\n"));
    free(gpu_numbers(&inputs));
    // A shader with its own main may declare its own uniform iCoarse.
    capture_begin();
    assert_true(gpu_load_text("#version 330 core\nuniform float iCoarse;\nout vec4 c;\n"
                              "void main() { c = vec4(iCoarse); }\n"));
    assert_non_null(strstr(capture_end(), "uniform float iCoarse is 0"));
    free(gpu_numbers(&inputs));
    assert_int_equal(gpu.renderer.coarse.width, 0);
    assert_int_equal(gpu.renderer.program[VIEW_COARSE], 0);
}

// An error in the coarse pass is found while the shader is being loaded, so the previous shader
// stays loaded.
TEST(test_a_missing_margin_is_reported_at_once)
{
    struct renderer_inputs inputs = wide_inputs(1);
    float *before = gpu_numbers(&inputs);
    capture_begin();
    assert_false(
        gpu_load_text("#include \"main.glsl\"\n#include \"coarse.glsl\"\n"
                      "Ray pixelRay(vec2 s) { return Ray(vec3(s, 0.0), vec3(0.0, 0.0, 1.0)); }\n"
                      "float sceneDistance(vec3 p) { return 1.0; }\n"
                      "vec3 rayColour(Ray ray) { return vec3(coarseStart(ray)); }\n"));
    assert_non_null(strstr(capture_end(), "coarseMargin"));
    float *after = gpu_numbers(&inputs);
    assert_memory_equal(after, before, size_of(&inputs));
    free(before);
    free(after);
}

// Simulate a driver that cannot make a float target. The renderer requests the table's target
// before the picture's.
static GLenum no_target(GLenum target)
{
    return target == GL_FRAMEBUFFER ? GL_FRAMEBUFFER_UNSUPPORTED : 0;
}

TEST(test_a_driver_that_cannot_make_the_table_is_reported)
{
    struct renderer_inputs inputs = wide_inputs(1);
    gpu_close();
    assert_true(gpu_open());
    assert_true(gpu_load(COARSE_SHADER));
    GLenum (*real)(GLenum) = gpu.context.gl.CheckFramebufferStatus;
    gpu.context.gl.CheckFramebufferStatus = no_target;
    capture_begin();
    assert_false(renderer_draw(&gpu.renderer, &inputs, 0, inputs.height));
    assert_non_null(strstr(capture_end(), "float target 88x67: the driver cannot make it"));
    gpu.context.gl.CheckFramebufferStatus = real;
    free(gpu_numbers(&inputs));
}

TESTS(gpu_setup, gpu_teardown)
