// resolution.c - tests how the resolution of a window's picture is chosen, with simulated frame
// times.
#include "lib/test.h"
#include "window/resolution.h"

enum { FRAMES = 60 };
static const double pixels = 960.0 * 540.0;

// A machine takes the time fixed for each frame, cost for each pixel, and beside for enlarging the
// frame, all in seconds.
struct machine {
    double fixed, cost, beside;
};

static double frame_seconds(const struct machine *machine, int level)
{
    return machine->fixed + machine->cost * pixels / pow(2.0, 0.5 * level);
}

static int draw_frame(struct resolution *resolution, const struct machine *machine, double off)
{
    int level = resolution_choose(resolution, pixels);
    double here = pixels / pow(2.0, 0.5 * level);
    resolution_learn(resolution, off * frame_seconds(machine, level), here);
    if (level > 0)
        resolution_learn_enlarging(resolution, off * machine->beside, pixels);
    return level;
}

// A random number in [-1, 1), from a sequence that is the same in every run.
static double chance(void)
{
    static uint32_t state = 1;
    state = state * 1664525u + 1013904223u;
    return (double)(state >> 8) / (double)(1u << 23) - 1.0;
}

TEST(sides_follow_the_level)
{
    assert_int_equal(resolution_side(0, 961), 961);
    assert_int_equal(resolution_side(4, 961), 481);
    assert_int_equal(resolution_side(8, 960), 240);
    assert_int_equal(resolution_side(RESOLUTION_COARSEST, 1), 1);
    for (int level = 0; level < RESOLUTION_COARSEST; level++) {
        double more = resolution_divisor(level + 1) / resolution_divisor(level);
        assert_true(fabs(more - 1.189207115) < 1e-6);
    }
    assert_true(fabs(resolution_divisor(RESOLUTION_COARSEST) - 256.0) < 1e-12);
}

// If the time of a frame is constant at each level, the level moves in only one direction and then
// stays. A frame then takes at most RESOLUTION_SLOW, unless the level is the coarsest, and the
// next finer level is predicted to take at least RESOLUTION_QUICK.
TEST(the_level_settles)
{
    for (double full = 1e-3; full < 20.0; full *= 1.07)
        for (int begin = 0; begin <= RESOLUTION_COARSEST; begin += 3)
            for (int i = 0; i < 9; i++) {
                struct machine machine = {0.01 * (i % 3), full / pixels, 0.012 * (double)(i / 3)};
                struct resolution resolution = {.level = begin};
                resolution_guess(&resolution, 0.0, 3.0 * machine.cost * (chance() + 1.0));
                draw_frame(&resolution, &machine, 1.0);
                int last = draw_frame(&resolution, &machine, 1.0), way = 0;
                for (int frame = 0; frame < FRAMES; frame++) {
                    int level = draw_frame(&resolution, &machine, 1.0);
                    int step = (level > last) - (level < last);
                    assert_true(step * way >= 0);
                    way = step != 0 ? step : way;
                    assert_true(frame < 20 || step == 0);
                    last = level;
                }
                double seconds = frame_seconds(&machine, last) + (last > 0 ? machine.beside : 0.0);
                assert_true(seconds <= RESOLUTION_SLOW || last == RESOLUTION_COARSEST);
                double finer =
                    sqrt(2.0) * frame_seconds(&machine, last) + (last > 1 ? machine.beside : 0.0);
                assert_true(last == 0 || finer >= RESOLUTION_QUICK * (1.0 - 1e-9));
            }
}

// If each frame takes long however few pixels it has, a coarser picture would be no quicker, so the
// level is that of the cost of the pixels alone.
TEST(a_fixed_cost_makes_no_picture_coarser)
{
    for (double full = 1e-3; full < 20.0; full *= 1.5) {
        int level[2];
        for (int i = 0; i < 2; i++) {
            struct machine machine = {0.3 * i, full / pixels, 0.0};
            struct resolution resolution = {0};
            resolution_guess(&resolution, machine.fixed, machine.cost);
            for (int frame = 0; frame < 5; frame++)
                level[i] = draw_frame(&resolution, &machine, 1.0);
        }
        assert_int_equal(level[1], level[0]);
    }
}

// Times that vary by up to 14 % change the level by at most one, and only in one direction.
TEST(varying_times_cause_no_flicker)
{
    for (double full = 0.02; full < 5.0; full *= 1.03) {
        struct machine machine = {0.0, full / pixels, 0.01};
        struct resolution resolution = {0};
        resolution_guess(&resolution, 0.0, machine.cost);
        int low = RESOLUTION_COARSEST, high = 0, way = 0, last = -1;
        for (int frame = 0; frame < 400; frame++) {
            int level = draw_frame(&resolution, &machine, 1.0 + 0.14 * chance());
            int step = last < 0 ? 0 : (level > last) - (level < last);
            assert_true(step * way >= 0);
            way = step != 0 ? step : way;
            low = frame < 3 || level > low ? low : level;
            high = frame < 3 || level < high ? high : level;
            last = level;
        }
        assert_true(high - low <= 1);
    }
}

// If every third frame takes ten times as long, or no time, the level does not change.
TEST(a_single_slow_frame_changes_nothing)
{
    struct machine machine = {0.0, 0.4 / pixels, 0.01};
    struct resolution resolution = {0};
    resolution_guess(&resolution, 0.0, machine.cost);
    draw_frame(&resolution, &machine, 1.0);
    draw_frame(&resolution, &machine, 1.0);
    int level = draw_frame(&resolution, &machine, 1.0);
    assert_in_range(level, 1, RESOLUTION_COARSEST - 1);
    for (int frame = 0; frame < FRAMES; frame++) {
        double off = frame % 3 != 0 ? 1.0 : frame % 2 == 0 ? 10.0 : 0.0;
        assert_int_equal(draw_frame(&resolution, &machine, off), level);
    }
}

// The level follows a lasting change after the second frame of the change. A wrong guess is
// corrected after the first frame.
TEST(a_change_that_lasts_is_followed)
{
    struct machine quick = {0.0, 0.03 / pixels, 0.01}, slow = {0.0, 1.2 / pixels, 0.01};
    double beside = 0.01 / pixels;
    struct resolution resolution = {.enlarging = {beside, beside, beside}};
    resolution_guess(&resolution, 0.0, slow.cost);
    int coarse = draw_frame(&resolution, &quick, 1.0);
    assert_true(coarse > 6);
    for (int frame = 0; frame < 5; frame++)
        assert_int_equal(draw_frame(&resolution, &quick, 1.0), 0);
    assert_int_equal(draw_frame(&resolution, &slow, 1.0), 0);
    assert_int_equal(draw_frame(&resolution, &slow, 1.0), 0);
    for (int frame = 0; frame < 5; frame++)
        assert_int_equal(draw_frame(&resolution, &slow, 1.0), coarse);
}

TESTS(NULL, NULL)
