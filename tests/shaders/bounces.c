// bounces.c - what page 24 claims of its paths: estimators with the same mean, errors that fall as
// theory predicts, a furnace without a mark, and frames that are equal wherever they are drawn.
#include "lib/test.h"
#include "lib/bounces.h"
#include "lib/chapter.h"
#include "lib/gpu.h"

#define FURNACE "chapters/solutions/24_bounces_3.frag"
#define PATCH   "chapters/solutions/24_bounces_4.frag"
#define MISSED  "chapters/experiments/24_patch.frag"

enum { WIDE = 96, HIGH = 54 };

// A number of frames: all of them for a release, otherwise a quarter.
static int frames_of(int all)
{
    return getenv("ALL") != NULL ? all : all / 4;
}

static struct bounces_run run_of(const char *shader, const char *settings)
{
    return (struct bounces_run){shader, settings, WIDE, HIGH, 0.0};
}

// The mean light of frames with the same random numbers, as a share of that of the chapter.
static double ratio(const char *shader, const char *settings, int frames, int channel)
{
    static const struct bounces_run chapter = {BOUNCES_CHAPTER, "", WIDE, HIGH, 0.0};
    static float *light;
    static int drawn;
    struct bounces_run run = run_of(shader, settings);
    if (drawn != frames) {
        free(light);
        light = bounces_kept(&chapter, frames);
        drawn = frames;
    }
    float *other = bounces_kept(&run, frames);
    double share =
        bounces_mean(other, &run, channel) / bounces_mean(light, &chapter, channel) - 1.0;
    print_message("# %s %s: %+.3f %%\n", shader, settings, 100.0 * share);
    free(other);
    return share;
}

TEST(three_estimators_have_one_mean)
{
    assert_true(fabs(ratio(BOUNCES_CHAPTER, "lights=0", frames_of(512), 3)) < 0.002);
    assert_true(fabs(ratio(BOUNCES_CHAPTER, "lights=1", frames_of(512), 3)) < 0.002);
}

TEST(roulette_keeps_the_mean_and_clamping_does_not)
{
    assert_true(fabs(ratio(BOUNCES_CHAPTER, "roulette=0", frames_of(512), 3)) < 0.002);
    assert_true(ratio(BOUNCES_CHAPTER, "clampAt=2", frames_of(512), 3) < -0.02);
}

// The light that the experiment misses is reddish.
TEST(a_connection_with_the_patch_keeps_the_mean_if_no_path_is_missed)
{
    double whole = ratio(PATCH, "", frames_of(512), 0),
           missed = ratio(MISSED, "", frames_of(512), 0);
    assert_true(getenv("ALL") == NULL || fabs(whole) < 0.001);
    assert_true(missed - whole < -0.001 && missed - whole > -0.002);
}

// If the paths lost or invented light anywhere, the furnace would not be 1.
TEST(nothing_is_lost_in_a_furnace)
{
    for (int lights = 0; lights < 3; lights++) {
        char settings[60];
        snprintf(settings, sizeof settings, "white=0.6 bounces=40 lights=%d", lights);
        struct bounces_run run = run_of(FURNACE, settings);
        float *light = bounces_kept(&run, 64);
        double mean = bounces_mean(light, &run, 3);
        print_message("# %s: %.5f\n", settings, mean);
        assert_true(fabs(mean - 1.0) < 0.001);
        free(light);
    }
}

TEST(the_error_of_independent_paths_falls_with_the_root_of_their_number)
{
    static const double frames[] = {1, 4, 16, 64, 256};
    const int last = frames_of(256), count = last == 256 ? 5 : 4;
    struct bounces_run run = run_of(BOUNCES_CHAPTER, "sequence=0");
    double error[5];
    for (int i = 0; i < count; i++)
        error[i] = bounces_noise(&run, (int)frames[i]);
    double slope = bounces_slope(count, frames, error);
    print_message("# slope %.3f\n", slope);
    assert_true(fabs(slope + 0.5) < 0.02);
    // Pairs that fill the square evenly do better; one good pair for everything stops converging.
    struct bounces_run sobol = run_of(BOUNCES_CHAPTER, ""),
                       pair = run_of(BOUNCES_CHAPTER, "sequence=1");
    double of_sobol = bounces_noise(&sobol, last), of_pair = bounces_noise(&pair, last);
    print_message("# after %d frames: hash %.4f, Sobol %.4f, one pair %.4f\n", last,
                  error[count - 1], of_sobol, of_pair);
    assert_true(of_sobol < 0.92 * error[count - 1] &&
                of_pair > (last == 256 ? 1.3 : 1.1) * error[count - 1]);
}

// The largest and the 99th percentile of the differences between the means of 8x8 blocks.
static int by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

// Another driver rounds differently. Here, an eye that is a millionth of a unit to the right plays
// this driver: its frame has the same random numbers, so its picture is the same but for the few
// paths that meet an edge.
TEST(equal_frames_are_equal_pictures)
{
    enum { W = 320, H = 180, BLOCKS = (W / 8) * (H / 8) * 3 };
    static double off[BLOCKS];
    struct bounces_run run = {BOUNCES_CHAPTER, "", W, H, 0.0}, moved = run;
    int count = 0;
    moved.right = 1e-6;
    float *a = bounces_shown(&run, 16), *b = bounces_shown(&moved, 16);
    for (int y = 0; y + 8 <= H; y += 8)
        for (int x = 0; x + 8 <= W; x += 8)
            for (int k = 0; k < 3; k++) {
                double sum = 0.0;
                for (int i = 0; i < 64; i++) {
                    int at = 4 * ((y + i / 8) * W + x + i % 8) + k;
                    sum += (double)a[at] - (double)b[at];
                }
                off[count++] = 255.0 * fabs(sum) / 64.0;
            }
    qsort(off, (size_t)count, sizeof *off, by_size);
    print_message("# of the blocks, 99 %% within %.3f, all within %.3f of 255\n",
                  off[count * 99 / 100], off[count - 1]);
    assert_true(off[count * 99 / 100] < 0.15 && off[count - 1] < 1.5);
    free(a);
    free(b);
}

// The filter keeps the mean, and 16 frames with it are nearer to the truth than 64 without.
TEST(a_filter_over_the_bounced_light_keeps_the_mean)
{
    struct bounces_run filtered = run_of(BOUNCES_CHAPTER, "filterPasses=3"),
                       plain = run_of(BOUNCES_CHAPTER, "");
    struct bounces_run other = run_of(BOUNCES_CHAPTER, "seed=5");
    float *truth = bounces_shown(&other, frames_of(1024));
    float *a = bounces_shown(&filtered, 19), *b = bounces_shown(&plain, 64);
    double with = 255.0 * bounces_apart(a, truth, &plain),
           without = 255.0 * bounces_apart(b, truth, &plain);
    double mean = bounces_mean(a, &plain, 3) / bounces_mean(truth, &plain, 3) - 1.0;
    print_message("# off by %.1f with the filter, %.1f without; mean %+.2f %%\n", with, without,
                  100.0 * mean);
    assert_true(with < without && fabs(mean) < 0.01);
    free(truth);
    free(a);
    free(b);
}

// ---- The room ----

// The wall, floor, ceiling, bar or open end that a ray reaches, found by a march with the distance
// to the room's boundary instead of in closed form.
TEST(walls_and_bars_are_where_a_march_finds_them)
{
    float *values = chapter_numbers(
        "24_bounces",
        "vec3 r = vec3(pixelRandom(0), pixelRandom(1), pixelRandom(2));"
        "bool hole = pixelRandom(3) < 0.3;"
        "vec3 o = hole ? WINDOW_AT + 0.98 * (2.0 * r - 1.0) * WINDOW : ROOM_AT + 0.98 * (2.0 * r - "
        "1.0) * ROOM;"
        "vec3 d = normalize(vec3(pixelRandom(4), pixelRandom(5), pixelRandom(6)) - 0.5);"
        "vec3 b1 = vec3(-2.26, WINDOW_AT.yz), b2 = b1 + vec3(0.0, 0.14, 0.0);"
        "vec3 h1 = vec3(0.025, WINDOW.y, 0.025), h2 = vec3(0.020, 0.020, WINDOW.z);"
        "if (min(sdBox(o - b1, h1), sdBox(o - b2, h2)) < 0.001) return vec3(0.5, 0.0, 0.0);"
        "float t = 0.0; bool out_ = false;"
        "for (int i = 0; i < 900; i++) { vec3 p = o + t * d;"
        " float room = max(-sdBox(p - ROOM_AT, ROOM), -sdBox(p - WINDOW_AT, WINDOW + vec3(0.01, "
        "0.0, 0.0)));"
        " float bars = min(sdBox(p - b1, h1), sdBox(p - b2, h2)); float s = min(room, bars);"
        " if (p.x < OUTSIDE) { out_ = true; break; } if (s < 1e-5) break; t += max(s, 1e-5); }"
        "float w = wallReached(Ray(o, d)).t;"
        "return vec3(0.5 + (out_ ? (w >= ROOM_FAR ? 0.0 : 0.4) : clamp(w - t, -0.4, 0.4)), "
        "out_, 0.0);");
    int bad = 0, left = 0;
    for (int i = 0; i < CHAPTER_WIDTH * CHAPTER_HEIGHT; i++) {
        bad += fabs((double)values[4 * i] - 0.5) > 2e-3;
        left += values[4 * i + 1] > 0.5f;
    }
    free(values);
    print_message("# %d rays leave; %d of %d rays end elsewhere\n", left, bad,
                  CHAPTER_WIDTH * CHAPTER_HEIGHT);
    assert_true(left > 5000 && bad < CHAPTER_WIDTH * CHAPTER_HEIGHT / 2000);
}

// No part of the things is outside the box in which the march looks for them.
TEST(the_box_contains_the_things)
{
    float *values = chapter_numbers(
        "24_bounces", "vec3 r = vec3(pixelRandom(0), pixelRandom(1), pixelRandom(2));"
                      "vec3 p = vec3(-0.6, 0.0, -1.6) + vec3(2.5, 1.6, 1.5) * r;"
                      "bool inside = all(greaterThan(p, THINGS_LOW)) && all(lessThan(p, "
                      "THINGS_HIGH));"
                      "return inside ? vec3(1.0) : vec3(0.5 + 0.3 * sceneDistance(p), 0.0, 0.0);");
    double least = 1.0;
    int count = 0;
    for (int i = 0; i < CHAPTER_WIDTH * CHAPTER_HEIGHT; i++)
        if (values[4 * i + 1] <= 0.0f) {
            least = fmin(least, ((double)values[4 * i] - 0.5) / 0.3);
            count++;
        }
    free(values);
    print_message("# outside the box: %d points, the nearest %.4f from the things\n", count, least);
    assert_true(count > 50000 && least > 0.0);
}

TESTS(gpu_setup, gpu_teardown)
