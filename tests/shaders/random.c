// random.c - the inputs iSample, iSamples and iPixel, and pixelRandom of shaders/random.glsl.
//
// The shader's numbers equal those of random_of to the last bit, wherever a pixel is drawn, so the
// tests of their distribution call random_of. It always gives the same numbers: a test that has
// passed once always passes.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/mirror.h"
#include "lib/random.h"
#include "lib/scratch.h"

#define RANDOM_COLOUR                                                                              \
    GPU_COURSE                                                                                     \
    "#include \"random.glsl\"\n"                                                                   \
    "vec3 rayColour(Ray ray) { return vec3(pixelRandom(0), pixelRandom(1), pixelRandom(7)); }\n"

static const int dimensions[3] = {0, 1, 7};

// The picture as floats, drawn in bands of `band` rows. The caller frees the result.
static float *draw(struct renderer *renderer, const struct renderer_inputs *inputs, int band)
{
    size_t row = 4 * (size_t)inputs->width;
    float *values = malloc(row * (size_t)inputs->height * sizeof *values);
    assert_non_null(values);
    for (int bottom = 0; bottom < inputs->height; bottom += band) {
        int rows = inputs->height - bottom < band ? inputs->height - bottom : band;
        assert_true(renderer_draw(renderer, inputs, bottom, rows));
        target_read(&renderer->picture, renderer->gl, values + row * (size_t)bottom);
    }
    return values;
}

// ---- What the harness sets ----

// Some pictures are wider or higher than a tile, and some are drawn in bands.
TEST(a_number_is_that_of_its_pixel_in_every_tile_and_band)
{
    assert_true(gpu_load_text(RANDOM_COLOUR));
    static const int sizes[][3] = {{1100, 600, 600}, {1100, 600, 37}, {513, 1030, 512}, {1, 1, 1}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        struct renderer_inputs inputs = gpu_inputs(sizes[i][0], sizes[i][1], 1);
        inputs.time = (double)i; // no number depends on time or frame
        inputs.frame = (int)i;
        float *values = draw(&gpu.renderer, &inputs, sizes[i][2]);
        for (int y = 0; y < inputs.height; y++)
            for (int x = 0; x < inputs.width; x++)
                for (int k = 0; k < 3; k++) {
                    size_t at = 4 * ((size_t)inputs.width * (size_t)y + (size_t)x) + (size_t)k;
                    if ((double)values[at] != random_of(x, y, 0, dimensions[k]))
                        fail_msg("size %zu: pixel %d,%d has a wrong number in dimension %d", i, x,
                                 y, dimensions[k]);
                }
        free(values);
    }
}

// Each sample has different numbers, whatever its position in the pixel. The sum of 36 shares is
// accurate to a few roundings of a float.
TEST(samples_have_numbers_of_their_own)
{
    assert_true(gpu_load_text(RANDOM_COLOUR));
    for (int samples = 2; samples <= 6; samples++) {
        struct renderer_inputs inputs = gpu_inputs(67, 41, samples);
        float *values = draw(&gpu.renderer, &inputs, 9);
        for (int i = 0; i < 67 * 41; i++)
            for (int k = 0; k < 3; k++) {
                double sum = 0.0;
                for (int sample = 0; sample < samples * samples; sample++)
                    sum += random_of(i % 67, i / 67, sample, dimensions[k]);
                double off = fabs((double)values[4 * i + k] - sum / (samples * samples));
                assert_true(off < 20.0 * MIRROR_FLOAT_ROUNDING);
            }
        free(values);
    }
}

// Each of 9 samples is drawn once, and iSamples is 9 in all of them.
TEST(samples_are_counted)
{
    assert_true(gpu_load_text(GPU_COURSE
                              "vec3 rayColour(Ray ray)\n"
                              "{\n"
                              "    bool mine = iSample == int(gl_FragCoord.x);\n"
                              "    return vec3(mine, iSamples == 9, float(iSample) / 64.0);\n"
                              "}\n"));
    struct renderer_inputs inputs = gpu_inputs(10, 1, 3);
    float *values = draw(&gpu.renderer, &inputs, 1);
    for (int x = 0; x < 10; x++) {
        assert_true(fabs((double)values[4 * x] - (x < 9 ? 1.0 / 9.0 : 0.0)) < 1e-6);
        assert_true(fabs((double)values[4 * x + 1] - 1.0) < 1e-6);
        assert_true(fabs((double)values[4 * x + 2] - 4.0 / 64.0) < 1e-6);
    }
    free(values);
}

// A scene whose distance is a random number of the pixel. The number appears in the table of a
// probe, and in a slice.
#define RANDOM_SCENE                                                                               \
    "#include \"main.glsl\"\n"                                                                     \
    "#include \"march.glsl\"\n"                                                                    \
    "#include \"random.glsl\"\n"                                                                   \
    "Ray pixelRay(vec2 screen) { return Ray(vec3(0.0), vec3(0.0, 0.0, -1.0)); }\n"                 \
    "float sceneDistance(vec3 p) { return pixelRandom(0) - 0.5; }\n"                               \
    "vec3 rayColour(Ray ray)\n"                                                                    \
    "{\n"                                                                                          \
    "    march(ray, 0.0, 2.0, 0.001, 8);\n"                                                        \
    "    return vec3(pixelRandom(0), float(iSamples) / 16.0, float(iSample) / 16.0);\n"            \
    "}\n"

TEST(a_probe_marches_sample_0_of_1_of_its_pixel)
{
    assert_true(gpu_load_text(RANDOM_SCENE));
    static const int pixels[][2] = {{0, 0}, {3, 5}, {63, 35}, {17, 30}};
    for (int samples = 1; samples <= 3; samples += 2)
        for (size_t i = 0; i < sizeof pixels / sizeof *pixels; i++) {
            struct renderer_inputs inputs = gpu_inputs(64, 36, samples);
            int x = pixels[i][0], y = pixels[i][1];
            struct probe probe;
            assert_true(renderer_probe(&gpu.renderer, &inputs, x, y, &probe));
            assert_true((double)probe.step[0].distance == random_of(x, y, 0, 0) - 0.5);
            // The probe's colour is that of the picture, from all samples.
            float *picture = draw(&gpu.renderer, &inputs, 36);
            for (int k = 0; k < 3; k++) {
                double value = (double)picture[4 * (64 * y + x) + k];
                assert_int_equal(probe.colour[k], (int)floor(255.0 * value + 0.5));
            }
            free(picture);
        }
}

// The slice is blue inside and orange outside.
TEST(a_slice_is_that_of_its_pixel)
{
    assert_true(gpu_load_text(RANDOM_SCENE));
    assert_true(renderer_set_view(&gpu.renderer, VIEW_SLICE));
    int inside = 0;
    for (int x = 0; x < 8; x++) {
        struct renderer_inputs inputs = gpu_inputs(64, 36, 1);
        inputs.pixel[0] = x;
        inputs.pixel[1] = 2 * x;
        float *picture = draw(&gpu.renderer, &inputs, 36);
        const float *corner = picture + 4 * (64 * 35 + 1);
        bool blue = corner[2] > corner[0];
        assert_int_equal(blue, random_of(x, 2 * x, 0, 0) < 0.5);
        inside += blue;
        free(picture);
    }
    assert_true(inside > 0 && inside < 8);
    assert_true(renderer_set_view(&gpu.renderer, VIEW_PICTURE));
}

// ---- How the numbers are distributed ----

enum { SIDE = 256, COUNT = SIDE * SIDE, SAMPLES = 9, DIMENSIONS = 6 };

// The numbers of one sample and dimension in a square of pixels.
static void numbers_of(int sample, int dimension, double number[COUNT])
{
    for (int i = 0; i < COUNT; i++)
        number[i] = random_of(i % SIDE, i / SIDE, sample, dimension);
}

// The mean of n numbers has a standard deviation of 1 / sqrt(12 n), and their second moment about
// 1/2 has one of 1 / sqrt(180 n). A value is off by more than 4.5 standard deviations once in
// 150,000 tries, and there are 108 values.
TEST(the_mean_of_numbers_is_a_half_and_their_variance_a_twelfth)
{
    static double number[COUNT];
    double worst[2] = {0.0, 0.0};
    for (int sample = 0; sample < SAMPLES; sample++)
        for (int dimension = 0; dimension < DIMENSIONS; dimension++) {
            double sum = 0.0, squares = 0.0;
            numbers_of(sample, dimension, number);
            for (int i = 0; i < COUNT; i++) {
                assert_true(number[i] >= 0.0 && number[i] < 1.0);
                sum += number[i];
                squares += (number[i] - 0.5) * (number[i] - 0.5);
            }
            worst[0] = fmax(worst[0], fabs(sum / COUNT - 0.5) * sqrt(12.0 * COUNT));
            worst[1] = fmax(worst[1], fabs(squares / COUNT - 1.0 / 12.0) * sqrt(180.0 * COUNT));
        }
    print_message("# mean off by at most %.2f sigma, variance by at most %.2f\n", worst[0],
                  worst[1]);
    assert_true(worst[0] < 4.5 && worst[1] < 4.5);
}

// The chi-square sum over the bins of (count - expected)^2 / expected, in standard deviations from
// its mean. The sum has bins - 1 degrees of freedom; this number is its mean, and twice this number
// is its variance.
static double chi_square(const int *count, int bins, int numbers)
{
    double sum = 0.0, expected = (double)numbers / bins;
    for (int i = 0; i < bins; i++)
        sum += (count[i] - expected) * (count[i] - expected) / expected;
    return (sum - (bins - 1)) / sqrt(2.0 * (bins - 1));
}

// With 256 bins, the distribution is neither too uniform nor too irregular.
TEST(each_bin_gets_its_share)
{
    static double number[COUNT];
    double least = 0.0, most = 0.0;
    for (int sample = 0; sample < SAMPLES; sample++)
        for (int dimension = 0; dimension < DIMENSIONS; dimension++) {
            int count[256] = {0};
            numbers_of(sample, dimension, number);
            for (int i = 0; i < COUNT; i++)
                count[(int)(256.0 * number[i])]++;
            double chi = chi_square(count, 256, COUNT);
            least = fmin(least, chi);
            most = fmax(most, chi);
        }
    print_message("# chi-square between %.2f and %.2f sigma\n", least, most);
    assert_true(least > -4.5 && most < 4.5);
}

// The steps between the numbers that are compared: in x, y, sample and dimension.
static const int steps[][4] = {{1, 0, 0, 0}, {0, 1, 0, 0},  {1, 1, 0, 0}, {1, -1, 0, 0},
                               {2, 0, 0, 0}, {0, 2, 0, 0},  {0, 0, 1, 0}, {0, 0, 2, 0},
                               {0, 0, 0, 1}, {0, 0, 0, 2},  {0, 0, 1, 1}, {1, 0, 1, 0},
                               {0, 1, 0, 1}, {16, 0, 0, 0}, {0, 64, 0, 0}};
enum { STEPS = sizeof steps / sizeof *steps };

// If neighbours are independent, their measured correlation has a standard deviation of
// 1 / sqrt(n), and their pairs fill the 16 x 16 bins of a square evenly. Pairs that depend on each
// other without being correlated would not fill the bins evenly.
TEST(neighbours_are_not_related)
{
    double worst = 0.0, least = 0.0, most = 0.0;
    for (int s = 0; s < STEPS; s++)
        for (int sample = 0; sample < 3; sample++) {
            int count[256] = {0};
            double sum = 0.0;
            for (int i = 0; i < COUNT; i++) {
                int x = i % SIDE + 1, y = i / SIDE + 1;
                double a = random_of(x, y, sample, sample);
                double b = random_of(x + steps[s][0], y + steps[s][1], sample + steps[s][2],
                                     sample + steps[s][3]);
                sum += (a - 0.5) * (b - 0.5);
                count[16 * (int)(16.0 * a) + (int)(16.0 * b)]++;
            }
            worst = fmax(worst, fabs(12.0 * sum / sqrt((double)COUNT)));
            double chi = chi_square(count, 256, COUNT);
            least = fmin(least, chi);
            most = fmax(most, chi);
        }
    print_message("# correlation at most %.2f sigma, chi-square between %.2f and %.2f\n", worst,
                  least, most);
    assert_true(worst < 4.5 && least > -4.5 && most < 4.5);
}

TESTS(gpu_setup, gpu_teardown)
