// numbers.c - tests how numbers are read from the words of a command line, and how numbers are
// written: in short form, in the file names of a sequence, and in the tables of a probe and of
// --benchmark.
#include "lib/test.h"
#include "number.h"
#include "picture/benchmark.h"
#include "picture/probe.h"
#include "command/sequence.h"
#include "lib/scratch.h"
#include "lib/system.h"

// ---- Words ----

TEST(a_number_is_the_whole_word)
{
    static const char *const good[] = {"1.5", "+1.5", "15e-1", ".15E1", "0.15e+01", "1.50"};
    static const char *const bad[] = {"",   " 1.5", "1.5 ", "1.5s",  "1,5", "0x1",  "inf",  "nan",
                                      "1e", ".",    "e5",   "1e999", "--1", "1.5.", "1 .5", "+"};
    double value;
    for (size_t i = 0; i < sizeof good / sizeof *good; i++)
        if (!number_read(good[i], &value) || value != 1.5)
            fail_msg("'%s' is not read as 1.5", good[i]);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        if (number_read(bad[i], &value))
            fail_msg("'%s' is accepted as a number", bad[i]);
    assert_int_equal(number_begin("2.5m", &value), 3);
    assert_int_equal(number_begin("2e", &value), 1);
}

TEST(a_whole_number_has_its_limits)
{
    int value = 0;
    assert_true(number_read_int("-3", -3, 7, &value) && value == -3);
    assert_true(number_read_int("+7", -3, 7, &value) && value == 7);
    static const char *const bad[] = {"-4", "8",  "",    "3.0",
                                      "3 ", " 3", "0x3", "99999999999999999999"};
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        if (number_read_int(bad[i], -3, 7, &value))
            fail_msg("'%s' is accepted as a whole number from -3 to 7", bad[i]);
}

TEST(a_number_is_written_short)
{
    static const struct {
        double value;
        const char *text;
    } numbers_of[] = {{0.0, "0"},
                      {-0.0, "0"},
                      {42.0, "42"},
                      {0.1 + 0.2, "0.3"},
                      {1e-6, "1e-6"},
                      {1e10, "1e10"},
                      {1e20, "1e20"},
                      {-2.5e-7, "-2.5e-7"},
                      {9999999999.0, "9999999999"},
                      {250.125, "250.125"},
                      {1.0 / 3.0, "0.33333333"}};
    for (size_t i = 0; i < sizeof numbers_of / sizeof *numbers_of; i++) {
        char text[32];
        double back;
        number_text(numbers_of[i].value, text, sizeof text);
        assert_string_equal(text, numbers_of[i].text);
        assert_true(number_read(text, &back) && (float)back == (float)numbers_of[i].value);
    }
}

TEST(a_sequence_numbers_its_files)
{
    static const char *const good[] = {"%d", "a-%04d.png", "x/%09d"};
    static const char *const bad[] = {"",     "a.png", "%",  "%4d", "%00d", "%010d",
                                      "%d%d", "%d%",   "%s", "%%d", "%d-%%"};
    for (size_t i = 0; i < sizeof good / sizeof *good; i++)
        if (!sequence_is_name(good[i]))
            fail_msg("'%s' is refused as a name", good[i]);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        if (sequence_is_name(bad[i]))
            fail_msg("'%s' is accepted as a name", bad[i]);
    char path[16];
    assert_true(sequence_path("a-%04d.png", 7, path, sizeof path));
    assert_string_equal(path, "a-0007.png");
    assert_true(sequence_path("%d.png", 12345, path, sizeof path));
    assert_string_equal(path, "12345.png");
    assert_true(sequence_path("123456789%02d.png", 7, path, sizeof path));
    capture_begin();
    assert_false(sequence_path("1234567890%02d.png", 7, path, sizeof path));
    assert_non_null(strstr(capture_end(), "the name is too long"));
}

// ---- Tables ----

static void assert_spread(const double *values, int count, double least, double middle, double most)
{
    double copy[8];
    memcpy(copy, values, (size_t)count * sizeof *values);
    struct benchmark_spread spread = benchmark_spread_of(copy, count);
    if (spread.minimum != least || spread.median != middle || spread.maximum != most)
        fail_msg("minimum, median and maximum of %d numbers are %g, %g, %g, not %g, %g, %g", count,
                 spread.minimum, spread.median, spread.maximum, least, middle, most);
}

TEST(a_median_is_in_the_middle)
{
    const double values[] = {5.0, 40.0, 1.0, 3.0, -2.0, 100.0, 6.0};
    assert_spread(values, 1, 5.0, 5.0, 5.0);
    assert_spread(values, 2, 5.0, 22.5, 40.0);
    assert_spread(values, 3, 1.0, 5.0, 40.0);
    assert_spread(values, 4, 1.0, 4.0, 40.0);
    assert_spread(values, 5, -2.0, 3.0, 40.0);
    assert_spread(values, 7, -2.0, 5.0, 100.0);
}

static const struct benchmark numbers = {
    .shader = "a \"b\\\n",
    .backend = "none",
    .frames = 7,
    .inputs = {.width = 30, .height = 20, .time = 1.5, .samples = 3},
    .compile = {{0.5, 0.25, 0.0}},
    .first = {{0.125, 0.0625, 0.0}},
    .median = {{0.002, 0.003, 0.0}},
    .minimum = {{0.001, 0.0015, 0.0}},
    .maximum = {{0.004, 0.006, 0.0}},
    .has_evaluations = true,
    .mean = 12.5,
    .percentile = 40.0,
    .most = 99.0,
    .cover = {.rays = 11, .march = 9.0, .bound = 6.0, .ratio = 1.5, .ray_ratio = 1.25},
};

// Read the text that was printed to a file, and close the file. Returns a text that is valid until
// the next call.
static const char *printed(FILE *file)
{
    static char text[8192];
    rewind(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    assert_int_equal(fclose(file), 0);
    return text;
}

TEST(a_probe_has_a_row_for_each_step)
{
    static const struct probe probe = {
        .step = {{.t = 0.0f, .distance = 1.5f, .position = {1, 2, 3}},
                 {.t = 1.5f, .distance = -0.25f, .position = {4, 5, 6}}},
        .steps = 2,
        .all_steps = 71,
        .evaluations = 346,
        .end = PROBE_GAVE_UP,
        .recorded = true,
        .colour = {7, 0, 255}};
    static struct probe other; // too large for the stack
    other = probe;
    FILE *file = system_open_scratch();
    probe_print(&probe, file);
    assert_string_equal(printed(file),
                        "step,t,distance,x,y,z\n0,0,1.5,1,2,3\n1,1.5,-0.25,4,5,6\n"
                        "# miss: the steps ran out; steps: 2; steps of further "
                        "rays: 69; evaluations of the scene: 346; colour: 7, 0, 255\n");
    other.steps = 0;
    other.all_steps = 0;
    file = system_open_scratch();
    probe_print(&other, file);
    assert_string_equal(printed(file),
                        "step,t,distance,x,y,z\n# miss: the steps ran out; steps: 0; "
                        "evaluations of the scene: 346; colour: 7, 0, 255\n");
    // A hit of which no step was near enough was found by a formula.
    const char *formula = "hit: found by a formula";
    other.end = PROBE_HIT;
    assert_string_equal(probe_outcome(&other), formula);
    other.steps = 2;
    assert_string_equal(probe_outcome(&other), "hit"); // the threshold is unknown
    for (int k = 0; k < 2; k++)
        other.step[k].threshold = 0.001f;
    assert_string_equal(probe_outcome(&other), "hit");
    other.step[1].distance = 0.0009f;
    assert_string_equal(probe_outcome(&other), "hit");
    other.step[1].distance = 0.002f;
    assert_string_equal(probe_outcome(&other), formula);
    other.steps = PROBE_STEPS + 1; // the last step is not in the table
    assert_string_equal(probe_outcome(&other), "hit");
    other.end = PROBE_GAVE_UP;
    other.steps = 0;
    other.recorded = false;
    file = system_open_scratch();
    probe_print(&other, file);
    assert_string_equal(printed(file), "# no march is recorded; colour: 7, 0, 255\n");
}

static const char *benchmark_text(bool json)
{
    FILE *file = system_open_scratch();
    benchmark_print(&numbers, json, file);
    return printed(file);
}

static void assert_says(const char *text, const char *wanted)
{
    if (strstr(text, wanted) == NULL)
        fail_msg("no '%s' in\n%s", wanted, text);
}

TEST(every_number_has_the_right_name)
{
    const char *text = benchmark_text(false);
    assert_says(text, "picture        30x20, time 1.5 s, samples per pixel: 9, frames: 7\n");
    assert_says(text, "cold compile      500.000    250.000\n");
    assert_says(text, "first frame       125.000     62.500\n");
    assert_says(text, "frame, median       2.000      3.000\n");
    assert_says(text, "minimum             1.000      1.500\n");
    assert_says(text, "maximum             4.000      6.000\n");
    assert_says(text, "mean 12.50, 99 % of the pixels at most 40, maximum 99\n");
    assert_says(text, "9.00 evaluations per ray, lower bound 6.00: march / bound 1.50, for one ray "
                      "at least 1.25; rays: 11\n");
    text = benchmark_text(true);
    assert_says(text, "  \"shader\": \"a \\\"b\\\\\\u000a\",\n");
    assert_says(text, "  \"compile_cpu_ms\": 500.0000,\n  \"compile_wall_ms\": 250.0000,\n"
                      "  \"compile_gpu_ms\": null,\n");
    assert_says(text, "  \"frame_median_cpu_ms\": 2.0000,\n");
    assert_says(text, "  \"frame_minimum_wall_ms\": 1.5000,\n");
    assert_says(text, "  \"frame_maximum_wall_ms\": 6.0000,\n");
    assert_says(text, "  \"evaluations_p99\": 40,\n  \"evaluations_maximum\": 99,\n");
    assert_says(text, "  \"march_over_bound_minimum\": 1.2500\n}\n");
}

TESTS(NULL, NULL)
