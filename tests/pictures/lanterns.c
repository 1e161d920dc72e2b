// lanterns.c - tests chapter 07's field of lanterns: compares every step that the probe lists with
// the distance to the nearest lantern, computed in double precision.
#include "lib/test.h"
#include "lib/cell.h"
#include "lib/gpu.h"
#include "lib/mirror.h"

enum { WIDTH = 640, HEIGHT = 360 };

static const double period = 5.5;

static struct probe probe; // too large for the stack

struct lantern {
    struct d3 middle;
    double size;
};

static double digits(double x)
{
    return x - floor(x);
}

static struct lantern lantern_of(int x, int z)
{
    double random = cell_hash(x, 0, z);
    return (struct lantern){d3(period * x, 1.55 + random - 0.5, period * z),
                            1.15 - 0.4 * digits(64.0 * random)};
}

static double ball(const struct lantern *lantern, struct d3 p)
{
    return d3_length(d3_sub(p, lantern->middle)) - 0.34 * lantern->size;
}

// The vector to p from the nearest point on the lantern's twelve edges, all of which are tried.
static struct d3 from_edges(const struct lantern *lantern, struct d3 p)
{
    struct d3 q = d3_sub(p, lantern->middle), best = {1e9, 0.0, 0.0};
    const double x = 0.5 * lantern->size, y = 0.7 * lantern->size;
    for (int i = 0; i < 12; i++) {
        double a = i % 2 == 0 ? 1.0 : -1.0, b = i / 2 % 2 == 0 ? 1.0 : -1.0;
        struct d3 edge = d3(a * x, b * y, fmin(fmax(q.z, -x), x));
        if (i / 4 == 1)
            edge = d3(fmin(fmax(q.x, -x), x), a * y, b * x);
        if (i / 4 == 2)
            edge = d3(a * x, fmin(fmax(q.y, -y), y), b * x);
        struct d3 away = d3_sub(q, edge);
        best = d3_length(away) < d3_length(best) ? away : best;
    }
    return best;
}

static double frame(const struct lantern *lantern, struct d3 p)
{
    return d3_length(from_edges(lantern, p)) - 0.05;
}

// The true distance: that to the nearest of the 7 x 7 lanterns around p.
static double brute_distance(struct d3 p)
{
    int x = (int)floor(p.x / period + 0.5), z = (int)floor(p.z / period + 0.5);
    double nearest = 1e9;
    for (int i = 0; i < 49; i++) {
        struct lantern lantern = lantern_of(x + i % 7 - 3, z + i / 7 - 3);
        nearest = fmin(nearest, fmin(ball(&lantern, p), frame(&lantern, p)));
    }
    return nearest;
}

// The totals and extremes of the probe's tables, which have one row per step.
struct rows {
    int rays, hits, rows;
    double over; // the largest excess of a step over the true distance
    int longest; // the number of steps of the longest march
};

static void check_rays(bool capped, struct rows *rows)
{
    struct renderer_inputs inputs = {.width = WIDTH, .height = HEIGHT, .samples = 1};
    inputs.camera = gpu_open_chapter("07_repetition");
    struct parameter *parameter = parameters_find(&gpu.renderer.parameters, "capped");
    assert_non_null(parameter);
    parameter->value[0] = capped ? 1.0 : 0.0;
    for (int y = 5; y < HEIGHT; y += 20)
        for (int x = 7; x < WIDTH; x += 25) {
            assert_true(renderer_probe(&gpu.renderer, &inputs, x, y, &probe));
            for (int i = 0; i < probe.steps; i++) {
                double truth = brute_distance(d3_of(probe.step[i].position));
                rows->over = fmax(rows->over, (double)probe.step[i].distance - truth);
            }
            rows->rays++;
            rows->rows += probe.steps;
            rows->hits += probe.end == PROBE_HIT;
            rows->longest = probe.steps > rows->longest ? probe.steps : rows->longest;
        }
}

TEST(test_no_step_is_longer_than_the_distance_to_any_lantern)
{
    struct rows capped = {0}, own = {0};
    check_rays(true, &capped);
    check_rays(false, &own);
    print_message("# %d rays, %d hits, %d steps, at most %d per ray; steps exceed the true "
                  "distance by at most %.1e, and without the cap by up to %.2f\n",
                  capped.rays, capped.hits, capped.rows, capped.longest, capped.over, own.over);
    assert_true(capped.over < 1e-5 && own.over > 0.2);
    assert_true(capped.hits > 30 && capped.hits < capped.rays / 2);
}

TESTS(gpu_setup, gpu_teardown)
