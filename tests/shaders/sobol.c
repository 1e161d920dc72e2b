// sobol.c - the pairs of shaders/sobol.glsl, compared with the definitions that they compute in
// other ways: Pascal's triangle, scrambling bit by bit, and one point in each rectangle.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

enum { REVERSED, PASCAL, SCRAMBLED, POINT, PAIR };
enum { SIDE = 256, COUNT = SIDE * SIDE };

static float *values_of(int function, float a, float b, float c)
{
    return gpu_call("tests/shaders/sobol.frag", SIDE, SIDE, function, (const float[4]){a, b, c});
}

static uint32_t integer(const float *halves)
{
    return (uint32_t)halves[0] | (uint32_t)halves[1] << 16;
}

TEST(bits_are_reversed)
{
    float *values = values_of(REVERSED, 0.0f, 0.0f, 0.0f);
    for (int i = 0; i < COUNT; i++) {
        uint32_t n = integer(values + 4 * i), reversed = integer(values + 4 * i + 2);
        for (int bit = 0; bit < 32; bit++)
            assert_int_equal(n >> bit & 1, reversed >> (31 - bit) & 1);
    }
    free(values);
}

// Pascal's triangle modulo 2, row by row.
static void pascal(uint32_t row[32])
{
    row[0] = 1;
    for (int i = 1; i < 32; i++)
        row[i] = row[i - 1] ^ row[i - 1] << 1;
}

TEST(five_steps_multiply_with_the_triangle_of_pascal)
{
    uint32_t row[32];
    pascal(row);
    float *values = values_of(PASCAL, 0.0f, 0.0f, 0.0f);
    for (int i = 0; i < COUNT; i++) {
        uint32_t n = integer(values + 4 * i), sum = 0;
        for (int bit = 0; bit < 32; bit++)
            sum ^= n >> bit & 1 ? row[bit] : 0;
        assert_int_equal(sum, integer(values + 4 * i + 2));
    }
    free(values);
}

// Where one bit of the argument is turned over, this bit of the result is too, no lower bit is, and
// each higher bit is about half of the time.
TEST(a_bit_is_scrambled_by_the_bits_below_it)
{
    double worst = 0.0;
    for (int bit = 0; bit < 32; bit++) {
        int count[32] = {0};
        float *values = values_of(SCRAMBLED, (float)bit, 0.0f, 0.0f);
        for (int i = 0; i < COUNT; i++) {
            uint32_t turned = integer(values + 4 * i);
            assert_int_equal(turned & ((2u << bit) - 1u), 1u << bit);
            for (int k = bit + 1; k < 32; k++)
                count[k] += (int)(turned >> k & 1);
        }
        free(values);
        for (int k = bit + 1; k < 32; k++)
            worst = fmax(worst, fabs((double)count[k] / COUNT - 0.5));
    }
    print_message("# a higher bit is turned over with a probability of 0.5 up to %.3f\n", worst);
    assert_true(worst < 0.3);
}

// The number of points of a block of 2^k that share a rectangle 2^-i wide and 2^-(k-i) high with
// another one. The points of a block are `points`, which has four numbers for each.
static int shared(const float *points, int k, int i)
{
    static bool taken[1 << 16];
    int found = 0;
    memset(taken, 0, sizeof taken);
    for (int n = 0; n < 1 << k; n++) {
        int x = (int)((double)points[4 * n] * (1 << i)),
            y = (int)((double)points[4 * n + 1] * (1 << (k - i)));
        int cell = x << (k - i) | y;
        found += taken[cell];
        taken[cell] = true;
    }
    return found;
}

TEST(each_rectangle_has_one_point_of_each_block)
{
    static const float seeds[][3] = {{0, 0, 0}, {17, 4711, 99991}, {65521, 3, 1234567}};
    for (int s = 0; s < 3; s++) {
        float *points = values_of(POINT, seeds[s][0], seeds[s][1], seeds[s][2]);
        for (int k = 0; k <= 16; k += k < 8 ? 1 : 4)
            for (int block = 0; block < 3 && (block + 1) << k <= COUNT; block++)
                for (int i = 0; i <= k; i++)
                    assert_int_equal(shared(points + 4 * (block << k), k, i), 0);
        free(points);
    }
}

// The first 16 samples of every pixel are a net, and the numbers of one sample are independent from
// pair to pair and from pixel to pixel, as those of a hash are.
TEST(each_pixel_has_pairs_of_its_own)
{
    enum { SAMPLES = 16 };
    float *sample[SAMPLES];
    static float net[4 * SAMPLES];
    for (int n = 0; n < SAMPLES; n++)
        sample[n] = values_of(PAIR, (float)n, 3.0f, 0.0f);
    for (int pixel = 0; pixel < COUNT; pixel++) {
        for (int n = 0; n < SAMPLES; n++)
            memcpy(net + 4 * n, sample[n] + 4 * pixel, sizeof *net * 4);
        for (int i = 0; i <= 4; i++)
            assert_int_equal(shared(net, 4, i), 0);
    }
    float *other = values_of(PAIR, 5.0f, 4.0f, 0.0f);
    double sums[5] = {0.0};
    for (int pixel = 0; pixel < COUNT; pixel++) {
        double x = (double)sample[5][4 * pixel] - 0.5, y = (double)sample[5][4 * pixel + 1] - 0.5;
        double next = (double)sample[5][4 * ((pixel + 1) % COUNT)] - 0.5;
        sums[0] += x;
        sums[1] += x * y;
        sums[2] += x * ((double)other[4 * pixel] - 0.5);
        sums[3] += y * ((double)other[4 * pixel + 1] - 0.5);
        sums[4] += x * next;
    }
    for (int n = 0; n < SAMPLES; n++)
        free(sample[n]);
    free(other);
    // In standard deviations: that of x is 1 / sqrt(12), and that of a product 1 / 12.
    sums[0] /= sqrt(12.0);
    for (int i = 0; i < 5; i++) {
        double sigmas = 12.0 * sums[i] / sqrt((double)COUNT);
        print_message("# sum %d: %.2f standard deviations\n", i, sigmas);
        assert_true(fabs(sigmas) < 4.5);
    }
}

TESTS(gpu_setup, gpu_teardown)
