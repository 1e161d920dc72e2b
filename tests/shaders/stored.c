// stored.c - shaders/stored.glsl with the grid of the clay elephant, compared with the file and the
// mesh in double precision: the interpolation, its error and its Lipschitz constant, and steps that
// never cross the surface.
#include "lib/test.h"

#include "picture/image.h"
#include "textures/elephant.h"
#include "textures/mesh_distance.h"
#include "textures/paint.h"
#include "lib/chapter.h"

enum { SIDE = ELEPHANT_SIDE, COUNT = CHAPTER_WIDTH * CHAPTER_HEIGHT, SOME = 7 };

static const double cell = 2.0 / (SIDE - 1), root3 = 1.7320508075688772;
static double value_at[SIDE][SIDE][SIDE]; // the file's values, indexed by z, y, x

static int read_grid(void **state)
{
    struct image_bytes bytes;
    char why[IMAGE_WHY], path[4200];
    snprintf(path, sizeof path, "%s/shaders/textures/clay.png", gpu_project_root());
    if (!image_read_bytes(&bytes, path, 3, (size_t)SIDE * SIDE * SIDE, why))
        return -1;
    for (int z = 0; z < SIDE; z++)
        for (int y = 0; y < SIDE; y++)
            for (int x = 0; x < SIDE; x++) {
                const unsigned char *b =
                    bytes.value + 3 * ((size_t)(z * SIDE + SIDE - 1 - y) * SIDE + (size_t)x);
                value_at[z][y][x] = (2.0 * (256.0 * b[0] + b[1]) / 65535.0 - 1.0) * ELEPHANT_RANGE;
            }
    free(bytes.value);
    return gpu_setup(state);
}

// ---- The truth ----

// Point n of a lattice that fills a cube a little larger than the grid's, as the shader computes
// it.
static void point_of(int n, double p[3])
{
    const int i[3] = {n % 61, n / 61 % 67, n / 4087};
    static const double last[3] = {60.0, 66.0, 58.0};
    for (int a = 0; a < 3; a++)
        p[a] = 2.4 * i[a] / last[a] - 1.2;
}

// The interpolation at a point of the cube, and its gradient.
static double inside_value(const double q[3], double gradient[3])
{
    double sum = 0.0, share[3];
    int low[3];
    for (int a = 0; a < 3; a++) {
        double position = (q[a] + 1.0) / cell;
        low[a] = (int)fmin(fmax(floor(position), 0.0), SIDE - 2.0);
        share[a] = position - low[a];
        gradient[a] = 0.0;
    }
    for (int k = 0; k < 8; k++) {
        int d[3] = {k & 1, k >> 1 & 1, k >> 2};
        double weight[3], value = value_at[low[2] + d[2]][low[1] + d[1]][low[0] + d[0]];
        for (int a = 0; a < 3; a++)
            weight[a] = d[a] == 1 ? share[a] : 1.0 - share[a];
        sum += weight[0] * weight[1] * weight[2] * value;
        for (int a = 0; a < 3; a++)
            gradient[a] +=
                (2 * d[a] - 1) * weight[(a + 1) % 3] * weight[(a + 2) % 3] * value / cell;
    }
    return sum;
}

static double stored(const double p[3], double *slope)
{
    double q[3], outside = 0.0, gradient[3];
    for (int a = 0; a < 3; a++) {
        q[a] = fmin(fmax(p[a], -1.0), 1.0);
        outside += (p[a] - q[a]) * (p[a] - q[a]);
    }
    double value = inside_value(q, gradient);
    *slope =
        sqrt(gradient[0] * gradient[0] + gradient[1] * gradient[1] + gradient[2] * gradient[2]);
    return outside > 0.0 ? sqrt(outside + value * value) : value;
}

static double step_of(double value)
{
    return fmax(0.577 * fabs(value), fabs(value) - 1.733 * cell);
}

// ---- The shader ----

static const char *const body =
    "int n = int(pixel.x) + 640 * int(pixel.y);"
    "vec3 p = 2.4 * vec3(n % 61, n / 61 % 67, n / 4087) / vec3(60.0, 66.0, 58.0) - 1.2;"
    "float value = storedDistance(grid, p);"
    "vec3 gradient = trilinearGradient(storedCell(grid, clamp(p, -1.0, 1.0)));"
    "return vec3(0.5 + 0.2 * value, 0.5 + 0.2 * storedStep(value), 0.5 * length(gradient));";

TEST(the_shader_interpolates_the_file)
{
    float *number = chapter_numbers("23_stored_distances", body);
    double worst = 0.0, steepest = 0.0, wrong = 0.0;
    for (int n = 0; n < COUNT; n++) {
        double p[3], slope;
        point_of(n, p);
        double truth = stored(p, &slope), value = ((double)number[4 * n] - 0.5) / 0.2;
        worst = fmax(worst, fabs(value - truth));
        assert_true(fabs(fabs((double)number[4 * n + 1] - 0.5) / 0.2 - step_of(truth)) < 2e-6);
        // On the boundary between two cells, rounding decides which cell is used.
        wrong += fabs(2.0 * (double)number[4 * n + 2] - slope) > 1e-3;
        steepest = fmax(steepest, slope);
    }
    print_message(
        "# largest error %.2g; steepest slope %.4f; gradients of a neighbouring cell: %.0f of %d\n",
        worst, steepest, wrong, COUNT);
    assert_true(worst < 2e-6);
    assert_true(wrong < 0.001 * COUNT);
    assert_true(steepest > 1.0 && steepest < root3);
    free(number);
}

// ---- The claims ----

// In the cube, the interpolation F differs from the distance d, clamped to the range of the file,
// by at most sqrt(3) / 2 of a cell. At a distance a outside the cube, sqrt(a^2 + F^2) exceeds d by
// at most the same amount.
TEST(the_error_is_within_its_bound)
{
    struct triangles t = elephant_mesh(3);
    struct mesh_tree tree = mesh_tree_build(&t);
    double worst = 0.0, mean = 0.0;
    for (int n = 0; n < COUNT; n += SOME) {
        double p[3], slope;
        point_of(n, p);
        double value = stored(p, &slope), d = mesh_distance(&tree, p);
        bool in = fmax(fabs(p[0]), fmax(fabs(p[1]), fabs(p[2]))) <= 1.0;
        if (in) {
            worst = fmax(worst, fabs(value - fmin(fmax(d, -ELEPHANT_RANGE), ELEPHANT_RANGE)));
            mean += fabs(value - fmin(fmax(d, -ELEPHANT_RANGE), ELEPHANT_RANGE)) * SOME / COUNT;
        } else
            assert_true(value - d < 0.5 * root3 * cell + 2e-5);
    }
    print_message("# error of the interpolation: largest %.4f of a cell, mean %.5f\n", worst / cell,
                  mean / cell);
    assert_true(worst < 0.5 * root3 * cell + 2e-5);
    assert_true(worst > 0.1 * cell);
    mesh_tree_free(&tree);
    triangles_free(&t);
}

// A step in a random direction never ends at a point where the value has the opposite sign.
TEST(a_step_crosses_no_surface)
{
    int crossed = 0, beyond = 0;
    for (int n = 0; n < COUNT; n++) {
        double p[3], q[3], slope, aside[3], size = 0.0;
        point_of(n, p);
        double value = stored(p, &slope);
        for (int a = 0; a < 3; a++) {
            aside[a] = paint_random(n, a, 5) - 0.5;
            size += aside[a] * aside[a];
        }
        for (int k = 0; k < 2; k++) { // the second time, the step is the whole value
            for (int a = 0; a < 3; a++)
                q[a] = p[a] + (k == 0 ? step_of(value) : fabs(value)) * aside[a] / sqrt(size);
            int *count = k == 0 ? &crossed : &beyond;
            *count += stored(q, &slope) * value < -1e-9;
        }
    }
    print_message("# crossings: %d with the step, %d with the whole value\n", crossed, beyond);
    assert_int_equal(crossed, 0);
    assert_true(beyond > 0);
}

// Experiment 5 of docs/23_stored_distances.md: if all corners of a brick of 3 x 3 x 3 cells have
// values of at least 4 cells, inside or outside, then no value in the brick has the opposite sign,
// and the interpolation between the corners differs from the finer one by less than 2 sqrt(3)
// cells.
TEST(a_shell_of_bricks_keeps_the_surface)
{
    enum { BRICK = 3, BRICKS = (SIDE - 1) / BRICK };
    int kept = 0;
    double worst = 0.0;
    for (int n = 0; n < BRICKS * BRICKS * BRICKS; n++) {
        const int low[3] = {BRICK * (n % BRICKS), BRICK * (n / BRICKS % BRICKS),
                            BRICK * (n / (BRICKS * BRICKS))};
        double corner[8], least = ELEPHANT_RANGE;
        for (int k = 0; k < 8; k++) {
            corner[k] = value_at[low[2] + BRICK * (k >> 2)][low[1] + BRICK * (k >> 1 & 1)]
                                [low[0] + BRICK * (k & 1)];
            least = fmin(least, fabs(corner[k]));
        }
        if (least < 4.0 * cell) {
            kept++;
            continue;
        }
        for (int m = 0; m < 64; m++) {
            const int at[3] = {m & 3, m >> 2 & 3, m >> 4};
            double coarse = 0.0, fine = value_at[low[2] + at[2]][low[1] + at[1]][low[0] + at[0]];
            for (int k = 0; k < 8; k++) {
                double weight = 1.0;
                for (int a = 0; a < 3; a++)
                    weight *= ((k >> a & 1) == 1 ? at[a] : BRICK - at[a]) / (double)BRICK;
                coarse += weight * corner[k];
            }
            worst = fmax(worst, fabs(coarse - fine));
            assert_true(coarse * fine > 0.0);
        }
    }
    int all = BRICKS * BRICKS * BRICKS, corners = (BRICKS + 1) * (BRICKS + 1) * (BRICKS + 1);
    print_message("# a shell of bricks: %d of %d keep their 64 points; %d values instead of %d; "
                  "largest difference %.2f of a cell\n",
                  kept, all, 64 * kept + corners, SIDE * SIDE * SIDE, worst / cell);
    assert_true(worst < 2.0 * root3 * cell);
}

// The length of the gradient next to a point of the grid, if the grid stores the distance to this
// point, less an error there and plus the same error elsewhere.
static double slope_at_a_point(double error)
{
    double p[3] = {-1.0 + 1e-9, -1.0 + 1e-9, -1.0 + 1e-9}, slope, keep[8];
    for (int k = 0; k < 8; k++) {
        double *value = &value_at[k >> 2][k >> 1 & 1][k & 1];
        keep[k] = *value;
        *value = cell * sqrt((k & 1) + (k >> 1 & 1) + (k >> 2)) + (k == 0 ? -error : error);
    }
    stored(p, &slope);
    for (int k = 0; k < 8; k++)
        value_at[k >> 2][k >> 1 & 1][k & 1] = keep[k];
    return slope;
}

// The length is sqrt(3), and more if the values are rounded. The step of the shader is still short
// enough, whereas one divided by sqrt(3) is not.
TEST(the_lipschitz_constant_is_attained)
{
    double rounded = slope_at_a_point(ELEPHANT_RANGE / 65535.0);
    assert_true(fabs(slope_at_a_point(0.0) - root3) < 1e-6);
    assert_true(step_of(0.01) * rounded < 0.01 && 0.01 / root3 * rounded > 0.01);
}

TESTS(read_grid, gpu_teardown)
