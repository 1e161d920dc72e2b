// land.c - shaders/land.glsl and water.glsl compared with double precision: noise on the plane as a
// slice of noise in space, slopes and the step that closes a gap, the mean of the waves over a
// pixel, and the total light of the glitter. The land of chapter 21 is tested too: its distance is
// compared with a search for the nearest land, and the share of the sun that it hides is compared
// with rays.
#include "lib/test.h"
#include "lib/chapter.h"
#include "lib/noise.h"
#include "lib/random.h"

#define SHADER "tests/shaders/land.frag"

enum { NOISE, RIDGED, HILL, WAY, WAVES, GLITTER };

// ---- The library ----

static struct noise plane_noise(double x, double z)
{
    return noise_value(d3(x, 0.0, z));
}

TEST(noise_on_the_plane_is_a_slice_of_noise_in_space)
{
    const float from[4] = {-3.0f, 5.0f, 0.0f, 0.0f};
    double worst = 0.0;
    float *values = gpu_call(SHADER, 128, 128, NOISE, from);
    float *folded = gpu_call(SHADER, 128, 128, RIDGED, from);
    for (int i = 0; i < 128 * 128; i++) {
        struct noise right = plane_noise(-3.0 + i % 128 / 16.0, 5.0 + (double)(i / 128) / 16.0);
        double side = right.value > 0.5 ? -2.0 : 2.0;
        worst = fmax(worst, fabs((double)values[4 * i] - right.value));
        worst = fmax(worst, fabs((double)values[4 * i + 1] - right.gradient.x));
        worst = fmax(worst, fabs((double)values[4 * i + 2] - right.gradient.z));
        worst = fmax(worst, fabs((double)folded[4 * i] - (1.0 - fabs(2.0 * right.value - 1.0))));
        if (fabs(right.value - 0.5) > 1e-5)
            worst = fmax(worst, fabs((double)folded[4 * i + 1] - side * right.gradient.x));
    }
    free(values);
    free(folded);
    print_message("# noise on the plane: worst error %.2g\n", worst);
    assert_true(worst < 1e-5);
}

static double bump(double x, double z, double a, double b, double height)
{
    double w = fmax(1.0 - x * x / (a * a) - z * z / (b * b), 0.0);
    return height * w * w;
}

TEST(a_hill_is_not_steeper_than_its_bound)
{
    const float numbers[4] = {3.0f, 2.0f, 1.5f, 0.0f};
    float *values = gpu_call(SHADER, 128, 128, HILL, numbers);
    double steepest = 0.0, worst = 0.0;
    for (int i = 0; i < 128 * 128; i++) {
        double x = i % 128 / 16.0 - 4.0, z = (double)(i / 128) / 16.0 - 4.0, h = 1e-5;
        double gx = (bump(x + h, z, 3.0, 2.0, 1.5) - bump(x - h, z, 3.0, 2.0, 1.5)) / (2.0 * h);
        double gz = (bump(x, z + h, 3.0, 2.0, 1.5) - bump(x, z - h, 3.0, 2.0, 1.5)) / (2.0 * h);
        worst = fmax(worst, fabs((double)values[4 * i] - bump(x, z, 3.0, 2.0, 1.5)));
        worst = fmax(worst, hypot((double)values[4 * i + 1] - gx, (double)values[4 * i + 2] - gz));
        steepest = fmax(steepest, hypot(gx, gz));
    }
    free(values);
    double bound = 8.0 * sqrt(3.0) / 9.0 * 1.5 / 2.0;
    print_message("# hill: worst error %.2g; steepest slope %.4f, bound %.4f\n", worst, steepest,
                  bound);
    assert_true(worst < 1e-4 && steepest <= bound && steepest > 0.99 * bound);
}

TEST(the_gap_closes_where_stated)
{
    double worst = 0.0;
    for (int k = 0; k < 3; k++) {
        const float growth[4] = {k == 0 ? 0.0f : k == 1 ? 0.3f : 5.0f, 0.0f, 0.0f, 0.0f};
        float *values = gpu_call(SHADER, 64, 16, WAY, growth);
        for (int i = 0; i < 64 * 16; i++) {
            double way = (double)values[4 * i + 2];
            double closed = (double)values[4 * i + 1] * way + 0.5 * (double)growth[0] * way * way;
            worst = fmax(worst, fabs(closed / (double)values[4 * i] - 1.0));
        }
        free(values);
    }
    print_message("# path that closes a gap: worst relative error %.2g\n", worst);
    assert_true(worst < 2e-6);
}

// Below the ground, wayToClose is negative, as the gap is. Where the root has no real value, its
// argument is clamped to 1e-9.
TEST(below_the_ground_the_way_is_negative)
{
    const float growth[4] = {5.0f, 1.0f, 0.0f, 0.0f};
    float *values = gpu_call(SHADER, 64, 16, WAY, growth);
    int clamped = 0;
    for (int i = 0; i < 64 * 16; i++) {
        double gap = (double)values[4 * i], slope = (double)values[4 * i + 1];
        double way = (double)values[4 * i + 2];
        assert_true(way < 0.0 && isfinite(way));
        if (slope * slope + 10.0 * gap < 0.0) {
            // The relative error is about sqrt(1e-9) / slope.
            assert_true(fabs(way * slope / (2.0 * gap) - 1.0) < 3e-4);
            clamped++;
        }
    }
    free(values);
    print_message("# below the ground: %d of %d roots are clamped\n", clamped, 64 * 16);
    assert_true(clamped > 100 && clamped < 64 * 16 - 100);
}

// ---- Waves ----

static const double wave_x[4] = {1.0, -2.0, 3.0, 0.5}, wave_z[4] = {0.5, 1.5, -1.0, 2.0},
                    steep[4] = {0.1, 0.2, 0.05, 0.15};

// The slope of the four waves along x.
static double wave_slope(double x, double z)
{
    double sum = 0.0;
    for (int i = 0; i < 4; i++)
        sum += steep[i] * wave_x[i] / hypot(wave_x[i], wave_z[i]) *
               cos(wave_x[i] * x + wave_z[i] * z + i);
    return sum;
}

TEST(a_pixel_sees_the_mean_of_its_waves)
{
    // The mean over the pixel is a sum over 81 x 81 points, weighted with a Gaussian. Along each of
    // the pixel's axes, the variance of the Gaussian is a twelfth of the squared length of the
    // axis.
    const float axes[4] = {1.5f, 0.5f, -0.4f, 1.2f};
    float *values = gpu_call(SHADER, 24, 24, WAVES, axes);
    double worst = 0.0;
    for (int i = 0; i < 24 * 24; i += 7) {
        double mean = 0.0, weights = 0.0;
        for (int k = 0; k < 81 * 81; k++) {
            double a = (k % 81 - 40) / 8.0, b = (double)(k / 81 - 40) / 8.0;
            double weight = exp(-0.5 * (a * a + b * b)), s = 1.0 / sqrt(12.0);
            mean += weight * wave_slope(i % 24 / 8.0 + s * (1.5 * a - 0.4 * b),
                                        (double)(i / 24) / 8.0 + s * (0.5 * a + 1.2 * b));
            weights += weight;
        }
        worst = fmax(worst, fabs((double)values[4 * i] - mean / weights));
    }
    // The variance that the mean loses and the variance that remains add up to the variance over
    // all positions.
    double all = 0.0, left = 0.0;
    for (int i = 0; i < 4; i++) {
        double a = wave_x[i] * 1.5 + wave_z[i] * 0.5, b = -wave_x[i] * 0.4 + wave_z[i] * 1.2;
        all += 0.25 * steep[i] * steep[i];
        left += 0.25 * steep[i] * steep[i] * exp(-(a * a + b * b) / 12.0);
    }
    print_message("# waves: worst error of the mean %.2g; variance lost %.6f of %.6f\n", worst,
                  (double)values[2], all);
    assert_true(worst < 2e-6 && fabs((double)values[2] + left - all) < 1e-6);
    free(values);
}

TEST(glitter_neither_makes_nor_loses_light)
{
    // Summed over all directions of the upper hemisphere, the reflected light times the cosine is
    // pi times the light that a horizontal surface receives.
    for (int k = 0; k < 2; k++) {
        const float numbers[4] = {k == 0 ? 0.8f : 0.5f, 1.0f, 0.004f, 0.0f};
        float *values = gpu_call(SHADER, 256, 256, GLITTER, numbers);
        double sum = 0.0;
        for (int i = 0; i < 256 * 256; i++)
            sum += (double)values[4 * i] * (double)values[4 * i + 3];
        sum *= 2.0 * MIRROR_PI / (256.0 * 256.0);
        free(values);
        double right = MIRROR_PI * (double)numbers[0];
        print_message("# glitter, sine of the light's height %.1f: %.4f of %.4f\n",
                      (double)numbers[0], sum, right);
        assert_true(fabs(sum / right - 1.0) < 0.02);
    }
}

// ---- The land of chapter 21 ----

#define CHAPTER "21_a_landscape"

static const double cells = 0.08, gain = 0.42, lacunarity = 2.1, foot = 0.4, sea_foot = -1.6,
                    ridges = 3.6, hill_slope = 0.45;
enum { OCTAVES = 4, AROUND = 300 };

enum { SEEDS = 100 }; // values of the parameter seed
static int seed = 0;

// The gap between the circle's ground and the water, see landSwell in chapters/valley.glsl.
static double circle(double x, double z)
{
    return 0.001 * ((x - 20.0) * (x - 20.0) + (z - 95.0) * (z - 95.0)) - 16.0;
}

static double wave(double turns, double height)
{
    double s = turns - floor(turns + 0.5);
    return height * s * (0.5 - fabs(s));
}

static double swell(double x, double z)
{
    double sum = wave(0.0023 * x + 0.0084 * z + 0.83 + 0.731 * seed, 18.0);
    sum += wave(-0.0087 * x + 0.0044 * z + 0.39 + 0.818 * seed, 16.0);
    sum += wave(-0.0053 * x - 0.0042 * z + 0.15 + 0.692 * seed, 20.0);
    return fmin(sum - 0.975, circle(x, z));
}

static double hills(double x, double z)
{
    double h = bump(x - 4.0, z - 46.0, 43.0, 25.5, 7.4);
    h = fmax(h, bump(x + 25.0, z - 24.0, 24.0, 24.5, 7.0));
    h = fmax(h, bump(x - 64.0, z - 90.0, 58.0, 42.0, 6.4));
    h = fmax(h, bump(x - 19.0, z - 22.0, 13.0, 12.5, 3.6));
    return fmax(h - 3.0, swell(x, z));
}

// The height of the hills at which ridges begin.
static double foot_at(double x, double z)
{
    return fmin(fmax(foot - 2.0 * (circle(x, z) + 4.0), sea_foot), foot);
}

// The largest height of the ridges above hills of the height base.
static double roughness(double x, double z, double base)
{
    return ridges * fmax(base - foot_at(x, z), 0.0);
}

static double shore(double x, double z)
{
    double a = x + 1.45, b = 1.2 * (z - 0.5);
    return 0.26 - 0.17 * sqrt(a * a + b * b + 0.04);
}

// A lower and an upper bound on the ridges, from their first count octaves: the sum of these
// octaves, without and with the remaining weights, times the first octave.
static void detail(double x, double z, int count, double *least, double *most)
{
    double u = cells * x + 31.2, v = cells * z + 9.9, weight = 1.0 - gain, sum = 0.0, rest = 1.0;
    double first = 1.0;
    for (int i = 0; i < count; i++) {
        double ridge = 1.0 - fabs(2.0 * plane_noise(u, v).value - 1.0);
        first = i == 0 ? ridge : first;
        sum += weight * ridge;
        rest -= weight;
        weight *= gain;
        double next = lacunarity * (0.8 * u - 0.6 * v) + 17.17;
        v = lacunarity * (0.6 * u + 0.8 * v) + 29.73;
        u = next;
    }
    *least = first * sum;
    *most = first * (sum + (count < OCTAVES ? rest : 0.0));
}

static double land(double x, double z)
{
    double base = hills(x, z), least, most;
    detail(x, z, OCTAVES, &least, &most);
    return fmax(base + roughness(x, z, base) * most, shore(x, z));
}

// The distance to the land, as landDistance of chapters/valley.glsl computes it with ALL_WAYS: the
// largest of the bounds from the hills and from each octave, or the bound for the shore if that is
// smaller.
static double land_distance(struct d3 p)
{
    double base = hills(p.x, p.z), high = roughness(p.x, p.z, base), low = foot_at(p.x, p.z);
    double under = fmin(p.y, low + (p.y - low) / (1.0 + ridges));
    double d = (under - base) / (0.65 + hill_slope), slope = 0.0, weight = 1.0 - gain;
    for (int i = 0; i < OCTAVES; i++) {
        double least, most;
        detail(p.x, p.z, i + 1, &least, &most);
        slope += (i == 0 ? 1.0 + weight : weight) * 3.75 * cells * pow(lacunarity, i);
        weight *= gain;
        double s = 0.65 + hill_slope + ridges * hill_slope * most + high * slope;
        double g = 2.0 * ridges * hill_slope * slope, gap = p.y - base - high * most;
        d = fmax(d, 2.0 * gap / (s + sqrt(fmax(s * s + 2.0 * g * gap, 1e-9))));
    }
    return fmin(d, (p.y - shore(p.x, p.z)) / 1.03);
}

// A random point of the valley, up to three units above the land or the water.
static struct d3 in_valley(void)
{
    double x = rand() % 4 ? random_in(-40.0, 40.0) : random_in(-4.0, 2.0);
    double z = rand() % 4 ? random_in(0.0, 80.0) : random_in(-2.0, 3.0);
    return d3(x, fmax(land(x, z), 0.0) + random_in(0.0, 3.0), z);
}

// A random point up to 300 units from the eye, up to three units above the land or the water, over
// the land of a random seed.
static struct d3 around_valley(void)
{
    double turn = random_in(0.0, 2.0 * MIRROR_PI), far = random_in(0.0, AROUND);
    double x = far * cos(turn), z = far * sin(turn);
    seed = rand() % SEEDS;
    return d3(x, fmax(land(x, z), 0.0) + random_in(0.0, 3.0), z);
}

// By how much the distance changes at most between two points that are one unit apart, from 100,000
// pairs of points that are nearer.
static double lipschitz(struct d3 (*random_position)(void))
{
    enum { PAIRS = 100000 };
    double most = 0.0, slopes = 0.0;
    srand(21);
    for (int i = 0; i < PAIRS; i++) {
        struct d3 p = random_position(), v = random_direction();
        struct d3 q = d3_add(p, d3_times(1e-3, v));
        most = fmax(most, fabs(land_distance(p) - land_distance(q)) / 1e-3);
        double level = hypot(v.x, v.z);
        slopes = fmax(slopes, fabs(land(p.x, p.z) - land(q.x, q.z)) / (1e-3 * level));
    }
    seed = 0;
    print_message(
        "# %d pairs: the distance changes by at most %.4f times the step; the largest slope of the "
        "land is %.2f, and its bound at the top is 14.8\n",
        PAIRS, most, slopes);
    assert_true(slopes < 14.8);
    return most;
}

TEST(the_largest_bound_is_1_lipschitz)
{
    assert_true(lipschitz(in_valley) <= 1.0 + 1e-6);
    assert_true(lipschitz(around_valley) <= 1.0 + 1e-6);
}

// How far the land stays below balls with the distance as radius, at least.
static double below_balls(struct d3 (*random_position)(void))
{
    enum { POSITIONS = 300, TURNS = 48, STEPS = 40 };
    double nearest = 1e9;
    srand(22);
    for (int i = 0; i < POSITIONS; i++) {
        struct d3 p = random_position();
        double d = land_distance(p);
        for (int k = 0; d > 0.0 && k < TURNS * STEPS; k++) {
            double turn = 2.0 * MIRROR_PI * (k % TURNS) / TURNS, far = d * (k / TURNS + 1) / STEPS;
            double height = land(p.x + far * cos(turn), p.z + far * sin(turn));
            // The height of the lower surface of the ball at this point.
            double low = p.y - sqrt(fmax(d * d - far * far, 0.0));
            nearest = fmin(nearest, low - height);
        }
    }
    seed = 0;
    print_message(
        "# %d balls with the distance as radius: the land stays below each ball by at least %.2g\n",
        POSITIONS, nearest);
    return nearest;
}

TEST(no_land_is_nearer_than_the_distance)
{
    assert_true(below_balls(in_valley) > -1e-9);
    assert_true(below_balls(around_valley) > -1e-9);
}

// The distance from the eye to the nearest land in a direction, beyond the shore; AROUND if there
// is none.
static int first_land(double turn)
{
    int far = 3;
    while (far < AROUND && land(far * cos(turn), far * sin(turn)) <= 0.0)
        far++;
    return far;
}

TEST(land_lies_in_every_direction)
{
    int without = 0, farthest = 0;
    for (seed = 0; seed < SEEDS; seed++) {
        for (int k = 0; k < 72; k++) {
            int far = first_land(2.0 * MIRROR_PI * k / 72.0);
            farthest = far > farthest ? far : farthest;
            without += far == AROUND;
        }
    }
    seed = 0;
    print_message("# %d seeds, 72 directions: %d without land; the farthest first land is %d units "
                  "away\n",
                  SEEDS, without, farthest);
    assert_int_equal(without, 0);
}

// The heights of the hills and of the foot of the ridges in the shader agree with those above, and
// so does the distance, for two seeds.
TEST(the_land_around_is_that_of_the_shader)
{
    struct renderer_inputs inputs = gpu_inputs(CHAPTER_WIDTH, CHAPTER_HEIGHT, 1);
    float *values = chapter_numbers(
        CHAPTER, "vec2 q = vec2(-300.0) + vec2(0.9375, 1.6666667) * pixel, xz = fromValley(q) / "
                 "dot(AHEAD, AHEAD);"
                 "vec4 h = hills(q); way = ALL_WAYS;"
                 "return 0.5 + 0.04 * vec3(h.x, h.w, landDistance(vec3(xz, 3.0).xzy, 4));");
    inputs.camera = gpu_camera(CHAPTER);
    double worst[3] = {0.0, 0.0, 0.0};
    for (int k = 0; k < 2; k++) {
        for (int i = 0; i < CHAPTER_WIDTH * CHAPTER_HEIGHT; i += 7) {
            double x = -300.0 + 0.9375 * (i % CHAPTER_WIDTH),
                   z = -300.0 + 1.6666667 * (i / CHAPTER_WIDTH);
            const double right[3] = {hills(x, z), foot_at(x, z), land_distance(d3(x, 3.0, z))};
            for (int c = 0; c < 3; c++)
                worst[c] =
                    fmax(worst[c], fabs(25.0 * ((double)values[4 * i + c] - 0.5) - right[c]));
        }
        free(values);
        seed = 57;
        gpu_set("seed", seed);
        values = gpu_numbers(&inputs);
    }
    free(values);
    seed = 0;
    print_message("# land around: height off by at most %.2g, foot by %.2g, distance by %.2g\n",
                  worst[0], worst[1], worst[2]);
    assert_true(worst[0] < 1e-3 && worst[1] < 1e-3 && worst[2] < 1e-3);
}

// ---- Functions of chapter 21, called one by one ----

static const double highest = 18.8, disc = 0.0047;

// Convert from the axes of the valley, with x to the right and z ahead, to those of the world, or
// back.
static struct d3 turned(struct d3 p)
{
    return d3(0.4226 * p.x - 0.9063 * p.z, p.y, -0.9063 * p.x - 0.4226 * p.z);
}

static struct d3 sun_at(double hour)
{
    double h = 15.0 * (hour - 12.0) * MIRROR_PI / 180.0, p = 43.6 * MIRROR_PI / 180.0,
           d = 10.0 * MIRROR_PI / 180.0;
    return d3(cos(p) * sin(d) - sin(p) * cos(d) * cos(h),
              sin(p) * sin(d) + cos(p) * cos(d) * cos(h), -cos(d) * sin(h));
}

// The smallest ratio of the gap below a ray to the distance along the ray, over land with the first
// octave only, found in small steps. The search ends where the ray first meets the land.
static double skyline(struct d3 p, struct d3 direction)
{
    double least = 1e9;
    for (double s = 0.02; s < 60.0 && least > 0.0 && p.y + s * direction.y < highest;
         s += fmax(0.002 * s, 0.002)) {
        struct d3 q = turned(d3_add(p, d3_times(s, direction)));
        double base = hills(q.x, q.z), part, whole;
        detail(q.x, q.z, 1, &part, &whole);
        double land = fmax(base + roughness(q.x, q.z, base) * part, shore(q.x, q.z));
        least = fmin(least, (q.y - land) / s);
    }
    return least;
}

// The largest of each of three numbers that a line of GLSL computes from pixel, each divided by
// two.
static void largest(const char *body, double most[3])
{
    float *values = chapter_numbers(CHAPTER, body);
    for (int i = 0; i < 4 * CHAPTER_WIDTH * CHAPTER_HEIGHT; i++)
        if (i % 4 < 3)
            most[i % 4] = fmax(most[i % 4], 2.0 * (double)values[i]);
    free(values);
}

// The slopes of the hills and of the shore and the height of the land, each divided by the bound on
// which the march relies, at points all over the valley, and at points up to 300 units to all sides
// of the eye.
TEST(no_land_is_steeper_or_higher_than_stated)
{
    double most[3] = {0.0, 0.0, 0.0}, around[3] = {0.0, 0.0, 0.0};
    largest("vec2 q = vec2(-60.0, -20.0) + vec2(0.3, 0.45) * pixel;"
            "vec2 r = vec2(-4.0, -3.0) + 0.0125 * pixel;"
            "return 0.5 * vec3(length(hills(q).yz) / HILL_SLOPE,"
            "length(shore(r).yz) / SHORE_SLOPE, landAt(q, 12.0).x / HIGHEST);",
            most);
    largest("vec2 q = vec2(-300.0) + vec2(0.9375, 1.6666667) * pixel;"
            "return 0.5 * vec3(length(hills(q).yz) / HILL_SLOPE, 0.0,"
            "landAt(q, 12.0).x / HIGHEST);",
            around);
    print_message("# slope of the hills: %.4f of its bound, of the shore: %.4f; height of the "
                  "land: %.4f of its bound\n",
                  most[0], most[1], most[2]);
    print_message("# land around: slope %.4f of its bound, height %.4f\n", around[0], around[2]);
    assert_true(most[0] <= 1.0 && most[1] <= 1.0 && most[2] <= 1.0);
    assert_true(most[0] > 0.99 && most[1] > 0.98 && most[2] > 0.9);
    assert_true(around[0] <= 1.0 && around[2] <= 1.0);
}

// True if the land does not hide a point of the sun's disc. r and a are polar coordinates around
// the centre of the disc; a is measured from the right.
static bool sees(struct d3 p, struct d3 light, double r, double a)
{
    struct d3 right = d3_unit(d3_cross(light, d3(0.0, 1.0, 0.0))), up = d3_cross(right, light);
    struct d3 aside = d3_add(d3_times(r * cos(a), right), d3_times(r * sin(a), up));
    return skyline(p, d3_unit(d3_add(light, aside))) > 0.0;
}

// The visible share of the disc, from rays to 48 points spread evenly over it.
static double free_share(struct d3 p, struct d3 light)
{
    enum { RINGS = 4, TURNS = 12 };
    double sum = 0.0;
    for (int i = 0; i < RINGS * TURNS; i++)
        sum += sees(p, light, disc * sqrt((i / TURNS + 0.5) / RINGS),
                    2.0 * MIRROR_PI * (i % TURNS + 0.5) / TURNS);
    return sum / (RINGS * TURNS);
}

// The share that lightSeen computes on the mountain is compared with rays to the whole disc in the
// penumbra, where only one end of the disc is visible; elsewhere, with a ray to the top of the
// disc.
TEST(the_sun_sets_behind_land_by_shares)
{
    float *values = chapter_numbers(
        CHAPTER, "vec2 q = vec2(-12.0, 24.0) + vec2(0.04, 0.05) * pixel, xz = fromValley(q); "
                 "vec4 h = landAt(q, 4.0);"
                 "vec3 n = normalize(vec3(-fromValley(h.yz), 1.0)).xzy, light = "
                 "sunDirection(18.0, LATITUDE, declination);"
                 "Surface surface = Surface(vec3(xz.x, h.x, xz.y), n, vec3(0.0), 0.0);"
                 "return vec3(lightSeen(surface, light, 0.02), h.x / HIGHEST, dot(n, light));");
    struct d3 light = sun_at(18.0);
    double off[2] = {0.0, 0.0}, hard = 0.0; // off[0]: outside the penumbra; off[1]: in it
    int count[2] = {0, 0}, wrong = 0;
    for (int i = 0; i < CHAPTER_WIDTH * CHAPTER_HEIGHT; i += 23) {
        if (values[4 * i + 1] <= 0.0f || values[4 * i + 2] <= 0.1f) // in the lake, or facing away
            continue;
        double x = -12.0 + 0.04 * (i % CHAPTER_WIDTH), z = 24.0 + 0.05 * (i / CHAPTER_WIDTH),
               share = (double)values[4 * i];
        struct d3 at = turned(d3(x, highest * (double)values[4 * i + 1] + 0.06, z));
        bool top = sees(at, light, disc, 0.5 * MIRROR_PI),
             rim = top != sees(at, light, disc, -0.5 * MIRROR_PI);
        double right = rim ? free_share(at, light) : (double)top;
        off[rim] += fabs(share - right);
        hard += rim ? fabs(round(right) - right) : 0.0;
        wrong += fabs(share - right) > 0.5;
        count[rim]++;
    }
    free(values);
    print_message("# the sun over the land: at %d points in the penumbra, the share is off by "
                  "%.4f on average, and a hard shadow by %.4f; at %d other points, the share is "
                  "off by %.4f; at %d points it is off by more than a half\n",
                  count[1], off[1] / count[1], hard / count[1], count[0], off[0] / count[0], wrong);
    assert_true(count[0] > 2000 && count[1] >= 8);
    assert_true(off[0] < 0.0075 * count[0] && off[1] < 0.45 * count[1]);
}

TESTS(gpu_setup, gpu_teardown)
