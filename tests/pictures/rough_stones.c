// rough_stones.c - tests the carved stones of chapter 12 in double precision: how steep their
// function is, that no ray passes through a stone, and how far the normal of the bump-mapped stone
// is from that of the carved stone.
#include "lib/test.h"
#include "lib/chapter.h"
#include "lib/noise.h"
#include "lib/random.h"

static const double roughness = 0.12, cells = 2.8;

// ---- The stones ----

static double round_box(struct d3 p, struct d3 half, double radius)
{
    return mirror_box(p, d3_sub(half, d3(radius, radius, radius))) - radius;
}

static double smooth_stones(struct d3 p)
{
    double under = round_box(d3(fabs(p.x - 0.2) - 1.2, p.y - 0.36, p.z), d3(0.45, 0.53, 0.5), 0.16);
    struct d3 q = d3_sub(p, d3(1.9, 0.9, -3.2));
    double along = 0.329994 * q.x + 0.943983 * q.z, nearest = round(along / 2.7);
    nearest = fmin(fmax(nearest, -2.0), 0.0);
    return fmin(under, round_box(d3(0.943983 * q.x - 0.329994 * q.z, q.y, along - 2.7 * nearest),
                                 d3(0.5, 1.25, 0.62), 0.3));
}

static double rough_stones(struct d3 p)
{
    return smooth_stones(p) + roughness * noise_value(d3_times(cells, p)).value;
}

static double stretch(void)
{
    return 1.0 + roughness * cells * 15.0 / 8.0;
}

// ---- The bound and its slack ----

static struct d3 random_near_stones(void)
{
    double x = random_in(-1.7, 2.1), y = random_in(0.0, 1.0);
    return d3(x, y, random_in(-0.6, 0.6));
}

TEST(test_the_shader_and_the_test_carve_the_same_stones)
{
    float *values = chapter_numbers(
        "12_textures",
        "vec3 p = vec3(-1.7 + 0.006 * pixel.x, 0.003 * pixel.y, 0.6 * sin(pixel.x + pixel.y));"
        "return vec3(0.5 + 0.2 * (partDistances(p).x + roughness * stoneNoise(p, OCTAVES).x));");
    double worst = 0.0;
    for (int i = 0; i < CHAPTER_WIDTH * CHAPTER_HEIGHT; i += 11) {
        int x = i % CHAPTER_WIDTH, y = i / CHAPTER_WIDTH;
        struct d3 p = d3(-1.7 + 0.006 * x, 0.003 * y, 0.6 * sin(x + y));
        worst = fmax(worst, fabs(5.0 * ((double)values[4 * i] - 0.5) - rough_stones(p)));
    }
    free(values);
    print_message("# the shader's distances to the stones are off by at most %.1e\n", worst);
    assert_true(worst < 1e-4);
}

TEST(test_the_divisor_of_the_rough_distance_is_large_enough)
{
    enum { PAIRS = 300000 };
    double steepest = 0.0;
    srand(4);
    for (int i = 0; i < PAIRS; i++) {
        struct d3 p = random_near_stones(), q = d3_add(p, d3_times(1e-3, random_direction()));
        steepest = fmax(steepest, fabs(rough_stones(p) - rough_stones(q)) / 1e-3);
    }
    print_message(
        "# %d pairs of points: the undivided distance to the rough stones changes by at most "
        "%.4f times the distance between the points; the divisor is %.4f: %.0f %% to spare\n",
        PAIRS, steepest, stretch(), 100.0 * (stretch() / steepest - 1.0));
    assert_true(steepest <= stretch() && steepest > 0.75 * stretch());
}

// The distance along a ray to the point where it first enters a rough stone, or end if it does not.
// The point is found with small steps of equal length, so no bound on the slope is needed.
static double first_inside(struct mirror_ray ray, double end)
{
    const double step = 2e-3;
    for (double t = 0.0; t < end; t += step)
        if (rough_stones(mirror_at(ray, t)) < 0.0)
            return t;
    return end;
}

static double stones_alone(struct d3 p, int *nearest)
{
    if (nearest != NULL)
        *nearest = 0;
    return fmax(smooth_stones(p), rough_stones(p) / stretch());
}

static const struct mirror_scene stones_scene = {.function = stones_alone};

// The march never passes the first point that small steps find inside a stone. If the march reports
// a hit, the function is below the threshold there; if it reports a miss, small steps find no stone
// either.
TEST(test_no_ray_passes_a_rough_stone)
{
    int hits = 0, misses = 0;
    double steps = 0.0;
    srand(5);
    for (int i = 0; i < 1500; i++) {
        struct d3 from = d3_add(d3(-1.0, 0.45, 0.0), d3_times(1.6, random_direction()));
        struct d3 to = d3_add(d3(-1.0, 0.45, 0.0), d3_times(0.75, random_direction()));
        struct mirror_ray ray = {from, d3_unit(d3_sub(to, from))};
        double truth = first_inside(ray, 3.0);
        struct mirror_march march = mirror_march(&stones_scene, ray, 0.0, 3.0, 1e-5, 4000);
        assert_true(march.end != MIRROR_GAVE_UP);
        assert_true(truth >= 3.0 || march.t <= truth + 1e-9);
        if (march.end == MIRROR_HIT) {
            assert_true(stones_alone(mirror_at(ray, march.t), NULL) < 1e-5);
            hits += truth < 3.0;
            steps += march.steps;
        } else {
            assert_true(truth >= 3.0);
            misses++;
        }
    }
    print_message("# %d rays hit, %d miss; %.1f steps per hit\n", hits, misses, steps / hits);
    assert_true(hits > 300 && misses > 100);
}

// ---- The normal of the first octave ----

static struct d3 smooth_normal(struct d3 p)
{
    const double h = 1e-5;
    struct d3 x = d3(h, 0.0, 0.0), y = d3(0.0, h, 0.0), z = d3(0.0, 0.0, h);
    return d3_unit(d3(smooth_stones(d3_add(p, x)) - smooth_stones(d3_sub(p, x)),
                      smooth_stones(d3_add(p, y)) - smooth_stones(d3_sub(p, y)),
                      smooth_stones(d3_add(p, z)) - smooth_stones(d3_sub(p, z))));
}

// Measure the angle between the normal of the carved stone and that of the smooth stone, tilted by
// the same noise, on the front stones between the ground and the board.
TEST(test_bumped_normals_are_close_to_carved_normals)
{
    int seen = 0;
    double sum = 0.0, largest = 0.0;
    srand(6);
    while (seen < 20000) {
        struct d3 p = random_near_stones();
        if (rough_stones(p) <= 0.0)
            continue;
        for (int i = 0; i < 60; i++)
            p = d3_sub(p, d3_times(0.6 * rough_stones(p), smooth_normal(p)));
        if (fabs(rough_stones(p)) > 1e-6 || p.y < 0.0 || p.y > 0.84)
            continue;
        struct d3 n = smooth_normal(p);
        struct d3 slope = d3_times(roughness * cells, noise_value(d3_times(cells, p)).gradient);
        struct d3 carved = d3_unit(d3_add(n, slope));
        struct d3 bumped = d3_unit(d3_sub(d3_add(n, slope), d3_times(d3_dot(slope, n), n)));
        double angle = asin(fmin(d3_length(d3_cross(carved, bumped)), 1.0)) * 180.0 / acos(-1.0);
        sum += angle;
        largest = fmax(largest, angle);
        seen++;
    }
    print_message("# bumped and carved normals: %.2f degrees apart on average, at most %.2f\n",
                  sum / seen, largest);
    assert_true(sum / seen < 0.6 && largest < 4.0);
}

TESTS(gpu_setup, gpu_teardown)
