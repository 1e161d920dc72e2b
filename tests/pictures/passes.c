// passes.c - tests shaders that read what they have kept of the last frame: a picture depends only
// on its inputs, whatever was drawn before it.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/scratch.h"
#include "picture/benchmark.h"
#include "picture/passes.h"
#include "picture/renderer_ray.h"

#define HISTORY GPU_COURSE "uniform sampler2D history; // the last frame\n"
#define SHOWN   "vec3 rayColour(Ray ray) { return texelFetch(history, iPixel, 0).rgb; }\n"

// Each frame stores a whole number below 8191, mixed from its index, its pixel and the numbers that
// this pixel and another one had in the last frame; gain is only used to show them.
static const char mixed[] = HISTORY
    "uniform float gain; // 1 in [0, 4]: brightness\n"
    "uniform float seed; // 3 in [0, 100]: another sequence of numbers\n"
    "vec4 frameKept(vec2 pixel)\n"
    "{\n"
    "    ivec2 other = (iPixel.yx * 7 + 3) % ivec2(iResolution.xy);\n"
    "    int n = 31 * int(texelFetch(history, iPixel, 0).r) + 17 * int(texelFetch(history, other, "
    "0).g)\n"
    "        + iPixel.x + 5 * iPixel.y + int(seed) * (iFrame + 1);\n"
    "    return vec4(n % 8191, (n + 1) % 8191, iSample, iSamples);\n"
    "}\n"
    "vec3 rayColour(Ray ray) { return gain * texelFetch(history, iPixel, 0).rgb / 8191.0; }\n";

static struct renderer_inputs film(int width, int height, int frame)
{
    struct renderer_inputs inputs = gpu_inputs(width, height, 1);
    inputs.rate = 10.0;
    return passes_inputs(&inputs, frame);
}

// Read what a frame has kept; the caller frees the numbers.
static float *kept_numbers(struct renderer *renderer, int frame)
{
    const struct target *target = kept_frame(&renderer->kept, frame);
    float *value = malloc(4 * sizeof *value * (size_t)target->width * (size_t)target->height);
    assert_non_null(value);
    target_read(target, renderer->gl, value);
    return value;
}

static void draw(const struct renderer_inputs *inputs)
{
    assert_true(renderer_draw(&gpu.renderer, inputs, 0, inputs->height));
}

// Put a number into all of a frame that has been drawn, so that a test sees whether it is drawn
// again.
static void stamp(int frame, float value)
{
    const struct gl *gl = gpu.renderer.gl;
    gl->BindFramebuffer(GL_FRAMEBUFFER, kept_frame(&gpu.renderer.kept, frame)->framebuffer);
    gl->ClearColor(value, value, value, value);
    gl->Clear(GL_COLOR_BUFFER_BIT);
}

static bool is_stamped(int frame, float value)
{
    float *number = kept_numbers(&gpu.renderer, frame);
    bool stamped = number[0] == value;
    free(number);
    return stamped;
}

// The same numbers, computed here. One number for each pixel, the bottom row first; the caller
// frees them.
static int *mixed_truth(int width, int height, int frame, int seed)
{
    size_t count = (size_t)width * (size_t)height;
    int *now = calloc(count, sizeof *now), *before = calloc(count, sizeof *before);
    assert_non_null(now);
    assert_non_null(before);
    for (int k = 0; k <= frame; k++) {
        memcpy(before, now, count * sizeof *now);
        for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++) {
                int other = (7 * y + 3) % width + width * ((7 * x + 3) % height);
                int green = k > 0 ? (before[other] + 1) % 8191 : 0;
                int n = 31 * before[x + width * y] + 17 * green + x + 5 * y + seed * (k + 1);
                now[x + width * y] = n % 8191;
            }
    }
    free(before);
    return now;
}

static void assert_mixed(const struct renderer_inputs *inputs, int seed)
{
    int *truth = mixed_truth(inputs->width, inputs->height, inputs->frame, seed);
    float *number = kept_numbers(&gpu.renderer, inputs->frame);
    for (int i = 0; i < inputs->width * inputs->height; i++)
        assert_int_equal((int)number[4 * i], truth[i]);
    free(number);
    free(truth);
}

// The picture is larger than a tile in both directions, so a frame reads texels of other tiles.
TEST(a_frame_reads_the_whole_last_frame)
{
    const struct renderer_inputs inputs = film(531, 517, 7);
    assert_true(gpu_load_text(mixed));
    draw(&inputs);
    assert_mixed(&inputs, 3);
}

// Each frame is that of a film from frame 0, in whatever order frames and sizes are asked for.
TEST(a_frame_depends_only_on_its_inputs)
{
    static const int frames[] = {0, 1, 5, 5, 2, 9, 9, 0};
    assert_true(gpu_load_text(mixed));
    for (size_t i = 0; i < sizeof frames / sizeof *frames; i++) {
        const struct renderer_inputs inputs = film(i % 3 == 2 ? 40 : 48, 27, frames[i]);
        draw(&inputs);
        assert_mixed(&inputs, 3);
        assert_int_equal(passes_drawn(&gpu.renderer, &inputs), frames[i] + 1);
    }
}

// Frames that are drawn are not drawn again, neither for the next frame nor for other views, bands,
// samples and rays.
TEST(frames_go_on)
{
    static struct probe probe;
    struct renderer_inputs inputs = film(32, 18, 3);
    struct renderer_eye eye;
    assert_true(gpu_load_text(mixed));
    draw(&inputs);
    stamp(3, 7.0f);
    inputs.samples = 2;
    inputs.pixel[0] = inputs.pixel[1] = 5;
    for (int view = 0; view < SHADER_VIEW_COUNT; view++) {
        assert_true(renderer_set_view(&gpu.renderer, (enum shader_view)view));
        assert_true(renderer_draw(&gpu.renderer, &inputs, 2, 4));
    }
    assert_true(renderer_set_view(&gpu.renderer, VIEW_PICTURE));
    eye = (struct renderer_eye){.camera = {.position = {1.0f, 2.0f, 3.0f}}, .lens = {1.0, 0.0}};
    inputs.eye = &eye;
    assert_true(renderer_probe(&gpu.renderer, &inputs, 4, 4, &probe));
    inputs.mouse[0] = 3.0f;
    inputs.date[0] = 2026.0f;
    inputs.date[3] = 11.0f;
    draw(&inputs);
    assert_true(is_stamped(3, 7.0f));
    inputs = passes_inputs(&inputs, 4);
    draw(&inputs);
    float *number = kept_numbers(&gpu.renderer, 4);
    assert_int_equal((int)number[0], (31 * 7 + 17 * 7 + 3 * 5) % 8191);
    free(number);
}

TEST(a_kept_frame_has_one_sample_which_counts_the_frames)
{
    struct renderer_inputs inputs = film(16, 9, 6);
    inputs.samples = 3;
    assert_true(gpu_load_text(mixed));
    draw(&inputs);
    float *number = kept_numbers(&gpu.renderer, 6);
    assert_int_equal((int)number[2], 6);
    assert_int_equal((int)number[3], 1);
    free(number);
    assert_mixed(&inputs, 3);
}

// ---- The key ----

// True if a change of the inputs, the parameters or the shader makes the frames begin again.
static bool begins_again(const struct renderer_inputs *after)
{
    return passes_drawn(&gpu.renderer, after) == 0;
}

TEST(what_a_frame_reads_makes_the_frames_begin_again)
{
    const struct renderer_inputs inputs = film(16, 9, 3);
    struct renderer_inputs after;
    assert_true(gpu_load_text(mixed));
    draw(&inputs);
    assert_false(begins_again(&inputs));
    after = film(17, 9, 3);
    assert_true(begins_again(&after));
    after = film(16, 9, 2);
    assert_true(begins_again(&after));
    after = inputs;
    after.begin = 1.0;
    assert_true(begins_again(&after));
    after = inputs;
    after.rate = 20.0;
    assert_true(begins_again(&after));
    gpu_set("seed", 4.0);
    assert_true(begins_again(&inputs));
    draw(&inputs);
    assert_mixed(&inputs, 4);
    assert_true(gpu_load_text(mixed)); // a shader that is loaded again keeps its parameters
    assert_true(begins_again(&inputs));
}

// What only the picture reads, such as a camera or a film curve, leaves the frames as they are.
TEST(what_only_the_picture_reads_lets_the_frames_go_on)
{
    struct renderer_inputs inputs = film(16, 9, 3);
    assert_true(gpu_load_text(mixed));
    draw(&inputs);
    gpu_set("gain", 0.5);
    inputs.camera.pan = 30.0f;
    assert_false(begins_again(&inputs));
    inputs.samples = 2;
    inputs.zoom = 2.0f;
    assert_false(begins_again(&inputs));
}

TEST(a_frame_that_sees_the_camera_begins_again_when_it_moves)
{
    static struct probe probe;
    struct renderer_eye eye = {.camera = {.position = {1.0f, 2.0f, 3.0f}}, .lens = {1.0, 0.0}};
    const struct renderer_inputs inputs = film(16, 9, 3);
    assert_true(gpu_load_text(
        HISTORY "vec4 frameKept(vec2 pixel) { return vec4(iCameraPosition, 1.0); }\n" SHOWN));
    draw(&inputs);
    struct renderer_inputs after = inputs;
    after.camera.position[1] += 0.001f;
    assert_true(begins_again(&after));
    after = inputs;
    after.camera.tilt += 1.0f;
    assert_true(begins_again(&after));
    assert_false(begins_again(&inputs));
    after = inputs; // a selected ray keeps its own eye when the camera moves
    after.eye = &eye;
    stamp(3, 7.0f);
    assert_true(renderer_probe(&gpu.renderer, &after, 4, 4, &probe));
    assert_true(is_stamped(3, 7.0f));
}

TEST(strokes_make_the_frames_begin_again)
{
    static const struct sculpture_tool tool = {.texture = "clay"};
    struct renderer_inputs inputs = film(16, 9, 3);
    struct strokes strokes = {0};
    assert_true(gpu_load_text(mixed));
    gpu.renderer.sculpture.tool = &tool;
    inputs.strokes = &strokes;
    draw(&inputs);
    assert_true(strokes_read(&strokes, "0.1,0,0,0"));
    assert_true(begins_again(&inputs));
    draw(&inputs);
    strokes_add(&strokes, (const double[]){1.0, 0.0, 0.0});
    assert_true(begins_again(&inputs));
    draw(&inputs);
    strokes_take_back(&strokes, 1);
    assert_true(strokes_read(&strokes, "0.1,0,0,0,2,0,0"));
    assert_true(begins_again(&inputs));
    strokes_free(&strokes);
    gpu.renderer.sculpture.tool = NULL;
}

// ---- What is kept ----

TEST(the_times_of_the_frames_are_fixed)
{
    struct renderer_inputs inputs = film(8, 8, 4);
    inputs.begin = 2.0;
    inputs.date[0] = 1970.0f;
    inputs = passes_inputs(&inputs, 4);
    assert_true(gpu_load_text(HISTORY "vec4 frameKept(vec2 pixel)\n"
                                      "{\n"
                                      "    float sum = texelFetch(history, iPixel, 0).x + iTime;\n"
                                      "    return vec4(sum, iTimeDelta, iDate.w, float(iFrame));\n"
                                      "}\n" SHOWN));
    draw(&inputs);
    float *number = kept_numbers(&gpu.renderer, 4);
    assert_true(fabsf(number[0] - 11.0f) < 1e-5f); // 2.0 + 2.1 + 2.2 + 2.3 + 2.4
    assert_true(fabsf(number[1] - 0.1f) < 1e-7f);
    assert_true(fabsf(number[2] - 2.4f) < 1e-6f);
    assert_int_equal((int)number[3], 4);
    free(number);
}

// Frame 0 keeps a NaN. Frame 2 is drawn into the same target, and keeps what it asks for.
TEST(a_frame_replaces_the_bits_of_an_earlier_one)
{
    const struct renderer_inputs inputs = film(8, 8, 2);
    assert_true(gpu_load_text(HISTORY
                              "vec4 frameKept(vec2 pixel)\n"
                              "{\n"
                              "    texelFetch(history, iPixel, 0);\n"
                              "    return iFrame == 0 ? vec4(sqrt(-1.0 - iTime)) : vec4(5.0);\n"
                              "}\n" SHOWN));
    draw(&inputs);
    assert_true(is_stamped(2, 5.0f));
}

// llvmpipe leaves out a blending that changes nothing; other drivers multiply the old value by 0.
static int blends;

static void count_blends(GLenum what)
{
    blends += what == GL_BLEND;
}

TEST(a_pass_is_drawn_without_blending)
{
    struct gl *gl = &gpu.context.gl, own = *gl;
    const struct renderer_inputs inputs = film(8, 8, 5);
    assert_true(gpu_load_text(mixed));
    gl->Enable = count_blends;
    blends = 0;
    draw(&inputs);
    *gl = own;
    assert_int_equal(blends, 1); // for the picture alone
}

// Patterns of bits that are stored as floats come back: numbers, subnormal numbers and NaNs.
TEST(patterns_of_bits_survive_a_frame)
{
    const struct renderer_inputs inputs = film(64, 8, 9);
    assert_true(gpu_load_text(
        HISTORY "vec4 frameKept(vec2 pixel)\n"
                "{\n"
                "    uint own = uint(iPixel.x + 64 * iPixel.y);\n"
                "    uvec4 start = uvec4(own, own << 14u, 0x7fc00000u | own, 0x3f800000u + own);\n"
                "    uvec4 last = floatBitsToUint(texelFetch(history, iPixel, 0));\n"
                "    return uintBitsToFloat(iFrame == 0 ? start : last + 1u);\n"
                "}\n" SHOWN));
    draw(&inputs);
    float *number = kept_numbers(&gpu.renderer, 9);
    for (uint32_t i = 0; i < 64 * 8; i++) {
        const uint32_t start[4] = {i, i << 14, 0x7fc00000u | i, 0x3f800000u + i};
        uint32_t bits[4];
        memcpy(bits, number + 4 * i, sizeof bits);
        for (int k = 0; k < 4; k++)
            assert_int_equal(bits[k], start[k] + 9);
    }
    free(number);
}

// A pixel that is discarded has what its target contained: the frame before the last, or 0.
TEST(a_discarded_pixel_keeps_the_frame_before_the_last)
{
    const struct renderer_inputs inputs = film(8, 8, 5);
    assert_true(gpu_load_text(HISTORY "vec4 frameKept(vec2 pixel)\n"
                                      "{\n"
                                      "    if (iFrame == 0 || iFrame > 3)\n"
                                      "        discard;\n"
                                      "    return texelFetch(history, iPixel, 0) + float(iFrame);\n"
                                      "}\n" SHOWN));
    draw(&inputs); // frame 1: 0 + 1, frame 2: 1 + 2, frame 3: 3 + 3
    assert_true(is_stamped(4, 3.0f));
    assert_true(is_stamped(5, 6.0f));
}

TEST(a_nan_stays)
{
    const struct renderer_inputs inputs = film(8, 8, 6);
    assert_true(gpu_load_text(
        HISTORY "vec4 frameKept(vec2 pixel)\n"
                "{\n"
                "    float broken = iFrame == 2 && iPixel.x == 3 ? sqrt(-1.0 - iTime) : 1.0;\n"
                "    return texelFetch(history, iPixel, 0) + broken;\n"
                "}\n" SHOWN));
    draw(&inputs);
    float *number = kept_numbers(&gpu.renderer, 6);
    for (int x = 0; x < 8; x++)
        assert_true(x == 3 ? isnan(number[4 * x]) : number[4 * x] == 7.0f);
    free(number);
}

// A frame is read with linear filtering, and its edge is continued.
TEST(a_frame_is_filtered)
{
    const struct renderer_inputs inputs = film(8, 8, 1);
    assert_true(gpu_load_text(
        HISTORY
        "vec4 frameKept(vec2 pixel)\n"
        "{\n"
        "    vec2 between = pixel + vec2(0.5, 0.0);\n"
        "    return iFrame == 0 ? vec4(pixel.x) : textureLod(history, between / 8.0, 0.0);\n"
        "}\n" SHOWN));
    draw(&inputs);
    float *number = kept_numbers(&gpu.renderer, 1);
    assert_true(number[0] == 1.0f && number[4] == 2.0f && number[28] == 7.5f);
    free(number);
}

// ---- Rays, views, comparisons, benchmarks ----

TEST(a_probe_and_the_views_read_the_frame)
{
    static struct probe probe;
    struct renderer_inputs inputs = film(16, 9, 3);
    assert_true(gpu_load_text(
        "#include \"main.glsl\"\n#include \"march.glsl\"\n"
        "uniform sampler2D history; // the last frame\n"
        "Ray pixelRay(vec2 screen) { return Ray(vec3(screen, 4.0), vec3(0.0, 0.0, -1.0)); }\n"
        "float sceneDistance(vec3 p) { return 0.5; }\n"
        "vec4 frameKept(vec2 pixel) { return texelFetch(history, iPixel, 0) + 0.1; }\n"
        "vec3 rayColour(Ray ray)\n"
        "{\n"
        "    float kept = texelFetch(history, iPixel, 0).r;\n"
        "    march(ray, 0.0, 9.0, 1e-9, int(10.0 * kept + 0.5));\n"
        "    return vec3(kept);\n"
        "}\n"));
    struct march march;
    float steps[2];
    for (int frame = 3; frame < 5; frame++) { // frame + 1 times 0.1, and so many steps
        inputs = passes_inputs(&inputs, frame);
        assert_true(renderer_set_view(&gpu.renderer, VIEW_PICTURE));
        assert_true(renderer_probe(&gpu.renderer, &inputs, 4, 4, &probe));
        assert_int_equal(probe.colour[0], frame == 3 ? 102 : 128);
        assert_int_equal(probe_rows(&probe), frame + 1);
        inputs.pixel[0] = inputs.pixel[1] = 4;
        assert_true(renderer_set_view(&gpu.renderer, VIEW_SLICE));
        draw(&inputs);
        assert_true(renderer_march_selected(&gpu.renderer, NULL, &inputs, &march));
        assert_int_equal(march.steps, frame + 1);
        assert_true(renderer_set_view(&gpu.renderer, VIEW_STEPS));
        float *colour = gpu_numbers(&inputs);
        steps[frame - 3] = colour[0] + 2.0f * colour[1] + 4.0f * colour[2];
        free(colour);
    }
    assert_true(fabsf(steps[1] - steps[0]) > 0.01f);
    assert_true(renderer_set_view(&gpu.renderer, VIEW_PICTURE));
}

TEST(both_pictures_of_a_comparison_keep_their_frames)
{
    struct renderer other = {0};
    struct comparison comparison = {.other = &other, .divider = 0.5};
    const struct renderer_inputs inputs = film(32, 18, 5);
    assert_true(gpu_load_text(mixed));
    scratch_write("other.frag", mixed);
    assert_true(renderer_open(&other, &gpu.context.gl, gpu.root));
    assert_true(gpu_load_file(&other, scratch_path("other.frag")));
    parameters_find(&other.parameters, "seed")->value[0] = 4.0;
    gpu.renderer.comparison = &comparison;
    assert_int_equal(passes_drawn(&gpu.renderer, &inputs), 0);
    draw(&inputs);
    assert_int_equal(passes_drawn(&gpu.renderer, &inputs), 6);
    for (int side = 0; side < 2; side++) {
        int *truth = mixed_truth(32, 18, 5, 3 + side);
        float *number = kept_numbers(side == 0 ? &gpu.renderer : &other, 5);
        for (int i = 0; i < 32 * 18; i++)
            assert_int_equal((int)number[4 * i], truth[i]);
        free(number);
        free(truth);
    }
    gpu.renderer.comparison = NULL;
    renderer_close(&other);
}

TEST(a_benchmark_measures_one_frame_after_the_other)
{
    struct benchmark benchmark = {.shader = "", .frames = 4, .inputs = film(16, 9, 0)};
    assert_true(gpu_load_text(mixed));
    assert_true(benchmark_run(&benchmark, &gpu.context, &gpu.renderer));
    assert_int_equal(gpu.renderer.kept.frames, BENCHMARK_WARM_UP + 4);
    const struct renderer_inputs last = film(16, 9, BENCHMARK_WARM_UP + 3);
    assert_mixed(&last, 3);
}

TESTS(gpu_setup, gpu_teardown)
