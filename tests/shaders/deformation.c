// deformation.c - the largest stretch of the twist, the bend, a displacement and a height field,
// measured in double precision at many points and compared with the value that
// shaders/transform.glsl states.
#include "lib/test.h"
#include "lib/gpu.h"
#include "lib/matrix.h"

#define SHADER "tests/shaders/transform.frag"

enum { TWIST = 10, BEND, STRETCH = 22 };
enum { WIDE = 256, ROWS = 64, ITEMS = WIDE * ROWS, SLOTS = 4 };

// The shader's results for ITEMS items: 4 slots of 4 floats each. The caller frees them.
static float *ask(int function, float a, float b, float c)
{
    return gpu_call(SHADER, WIDE * SLOTS, ROWS, function, (const float[4]){a, b, c});
}

typedef struct d3 (*map)(struct d3 p, double rate);

static struct d3 twisted(struct d3 p, double rate)
{
    return m3_turned(d3(0.0, 1.0, 0.0), rate * p.y, p);
}

static struct d3 bent(struct d3 p, double rate)
{
    return m3_turned(d3(0.0, 0.0, 1.0), rate * p.x, p);
}

// The largest singular value of a map's derivative at a point, from central differences.
static double stretch_at(map function, struct d3 p, double rate)
{
    const double h = 1e-5;
    struct m3 m;
    for (int i = 0; i < 3; i++) {
        struct d3 step = d3_times(h, d3(i == 0, i == 1, i == 2));
        struct d3 change = d3_sub(function(d3_add(p, step), rate), function(d3_sub(p, step), rate));
        m.column[i] = d3_times(0.5 / h, change);
    }
    return m3_largest_stretch(&m);
}

// The largest stretch over many points of a cylinder around an axis: 0 for x, 1 for y, 2 for z.
static double stretch_in_cylinder(map function, double rate, double radius, int axis)
{
    double largest = 0.0;
    for (int i = 0; i <= 20; i++)          // along the axis
        for (int j = 0; j <= 20; j++)      // outwards
            for (int k = 0; k < 72; k++) { // around
                double r = radius * j / 20.0, angle = 2.0 * MIRROR_PI * k / 72.0;
                double c[3];
                c[axis] = 0.1 * i - 1.0;
                c[(axis + 1) % 3] = r * cos(angle);
                c[(axis + 2) % 3] = r * sin(angle);
                largest = fmax(largest, stretch_at(function, d3(c[0], c[1], c[2]), rate));
            }
    return largest;
}

// The largest |f(p) - f(q)| / |p - q| over random pairs of points of the cylinder of
// stretch_in_cylinder. This ratio never exceeds the largest stretch.
static double stretch_of_pairs(map function, double rate, double radius, int axis)
{
    double largest = 0.0;
    srand(5);
    for (int i = 0; i < 50000; i++) {
        double c[2][3];
        for (int k = 0; k < 2; k++) {
            double angle = 2.0 * MIRROR_PI * rand() / RAND_MAX,
                   r = radius * sqrt(1.0 * rand() / RAND_MAX);
            c[k][axis] = 2.0 * rand() / RAND_MAX - 1.0;
            c[k][(axis + 1) % 3] = r * cos(angle);
            c[k][(axis + 2) % 3] = r * sin(angle);
        }
        struct d3 p = d3(c[0][0], c[0][1], c[0][2]), q = d3(c[1][0], c[1][1], c[1][2]);
        double apart = d3_length(d3_sub(p, q));
        double change = d3_length(d3_sub(function(p, rate), function(q, rate)));
        largest = apart > 1e-6 ? fmax(largest, change / apart) : largest;
    }
    return largest;
}

static void check_deformation(const char *name, int which, map function, int axis)
{
    static const float cases[][2] = {{0.5f, 1.0f}, {-1.0f, 1.0f}, {2.0f, 0.5f}, {2.4f, 1.84f}};
    for (int k = 0; k < 4; k++) {
        double rate = (double)cases[k][0], radius = (double)cases[k][1];
        float *values = ask(which, cases[k][0], cases[k][1], 0.0f);
        double stated = (double)values[3], worst = 0.0;
        for (int i = 0; i < ITEMS; i++)
            worst = fmax(worst, d3_length(d3_sub(d3_of(values + 16 * i + 4),
                                                 function(d3_of(values + 16 * i), rate))));
        free(values);
        double measured = stretch_in_cylinder(function, rate, radius, axis);
        double pairs = stretch_of_pairs(function, rate, radius, axis);
        print_message(
            "# %s, rate %.1f, radius %.2f: stretch stated %.4f, measured %.4f, of pairs of points "
            "%.4f; GPU off by at most %.1g\n",
            name, rate, radius, stated, measured, pairs, worst);
        assert_true(worst < 5e-6);
        assert_true(measured <= stated * (1.0 + 1e-6) && measured > 0.999 * stated);
        assert_true(pairs <= stated * (1.0 + 1e-6) && pairs > 0.5 * stated);
    }
}

TEST(test_twist_stretches_as_stated)
{
    check_deformation("twist", TWIST, twisted, 1);
    float *values = ask(TWIST, 1.0f, 1.0f, 0.0f);
    // With a rate and a radius of 1, the stretch is the golden ratio, not sqrt(2).
    assert_true(fabs((double)values[3] - 0.5 * (1.0 + sqrt(5.0))) < 1e-6);
    free(values);
}

TEST(test_bend_stretches_as_stated)
{
    check_deformation("bend", BEND, bent, 2);
}

// The length of a function's gradient at p, from central differences.
static double slope(double (*function)(struct d3), struct d3 p)
{
    const double h = 1e-5;
    double c[3];
    for (int i = 0; i < 3; i++) {
        struct d3 step = d3_times(h, d3(i == 0, i == 1, i == 2));
        c[i] = (function(d3_add(p, step)) - function(d3_sub(p, step))) / (2.0 * h);
    }
    return d3_length(d3(c[0], c[1], c[2]));
}

// The bumps of chapters/experiments/05_stretched.frag, whose slope is at most 0.045 x 14 = 0.63.
static double bumps(struct d3 p)
{
    return 0.045 * sin(14.0 * p.x) * sin(14.0 * p.y) * sin(14.0 * p.z);
}

static double bumpy_ball(struct d3 p)
{
    return mirror_sphere(p, 0.6) + bumps(p);
}

// The waves of chapters/05_transforms.frag at time 0, whose slope is at most 0.210.
static double sea(struct d3 p)
{
    return p.y - 0.060 * sin(0.45 * p.x + 1.20 * p.z) - 0.036 * sin(-1.10 * p.x + 1.70 * p.z) -
           0.024 * sin(1.90 * p.x + 1.60 * p.z);
}

static double largest_slope(double (*function)(struct d3), double size, int count)
{
    double largest = 0.0;
    for (int i = 0; i <= count; i++)
        for (int j = 0; j <= count; j++)
            for (int k = 0; k <= count; k++)
                largest = fmax(largest, slope(function, d3(size * (2.0 * i / count - 1.0),
                                                           size * (2.0 * j / count - 1.0),
                                                           size * (2.0 * k / count - 1.0))));
    return largest;
}

TEST(test_displacements_stretch_as_stated)
{
    float *values = ask(STRETCH, 0.63f, 0.0f, 0.0f);
    double stated = (double)values[0], general = largest_slope(bumpy_ball, 0.7, 60);
    double alone = largest_slope(bumps, 0.7, 60);
    free(values);
    print_message("# bumps: largest slope %.4f; on a ball stated %.4f, measured %.4f\n", alone,
                  stated, general);
    assert_true(alone <= 0.6301 && alone > 0.95 * 0.63);
    assert_true(fabs(stated - 1.63) < 1e-6 && general <= stated && general > 0.95 * stated);
    values = ask(STRETCH, 0.210f, 0.0f, 0.0f);
    double height = (double)values[1];
    double measured = largest_slope(sea, 12.0, 60);
    free(values);
    print_message("# sea: largest slope stated %.5f, measured %.5f\n", height, measured);
    assert_true(fabs(height - sqrt(1.0 + 0.210 * 0.210)) < 1e-6);
    assert_true(measured <= height && measured > 0.99 * height);
}

TESTS(gpu_setup, gpu_teardown)
