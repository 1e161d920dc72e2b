// parameter.c - tests how the values of parameters are set, changed, kept across a reload, and
// printed.
#include "lib/test.h"

#include <locale.h>

#include "lib/parameter.h"
#include "lib/scratch.h"
#include "lib/system.h"

// ---- Setting ----

static const char sample[] = "uniform float height; // 1 in [-2, 4] step 0.1, metres: x\n"
                             "uniform int steps; // 8 in [1, 512]: x\n"
                             "uniform bool shown; // false: x\n"
                             "uniform vec3 colour; // 1, 0.9, 0.5 in [0, 1]: x\n"
                             "uniform float small; // 0.001 in [1e-6, 0.1] step *2: x\n"
                             "uniform int more; // 1 in [1, 99] step *1.1: x\n";

static void assert_assigned(const struct parameters *parameters, const char *assignment,
                            const char *expected)
{
    char name[64], value[128];
    snprintf(name, sizeof name, "%.*s", (int)strcspn(assignment, "="), assignment);
    assert_true(parameters_assign(parameters, assignment));
    parameter_value_text(parameters_find(parameters, name), value, sizeof value);
    assert_string_equal(value, expected);
}

TEST(test_assignments_set_values)
{
    struct parameters read = parameter_text(sample);
    assert_assigned(&read, "height=-2", "-2");
    assert_assigned(&read, "height=.5", "0.5");
    assert_assigned(&read, "height=3e-1", "0.3");
    assert_assigned(&read, "height=+4.", "4");
    assert_assigned(&read, "small=1e-6", "1e-6");
    assert_assigned(&read, "small=0.1", "0.1");
    assert_assigned(&read, "steps=512", "512");
    assert_assigned(&read, "steps=2.0", "2");
    assert_assigned(&read, "shown=true", "true");
    assert_assigned(&read, "shown=0", "false");
    assert_assigned(&read, "shown=1", "true");
    assert_assigned(&read, "shown=false", "false");
    assert_assigned(&read, "colour=0,0.25,1", "0,0.25,1");
    assert_assigned(&read, "colour=1, 0.9 ,0.5", "1,0.9,0.5");
    parameters_free(&read);
}

TEST(test_wrong_assignments_are_refused)
{
    static const char *const refused[][2] = {
        {"nothing=1", "height, steps, shown, colour, small, more"},
        {"heigh=1", "unknown parameter"},
        {"height", "NAME=VALUE"},
        {"=1", "NAME=VALUE"},
        {"", "NAME=VALUE"},
        {"height=", "one number"},
        {"height=1x", "one number"},
        {"height=1,2", "one number: write 1.2"},
        {"height=-0,5", "one number: write -0.5"},
        {"height=1 2", "one number"},
        {"height=inf", "one number"},
        {"height=nan", "one number"},
        {"height=-nan", "one number"},
        {"height=1e999", "one number"},
        {"height=0x1", "one number"},
        {"height=true", "one number"},
        {"height=4.001", "[-2, 4] metres"},
        {"height=-3", "[-2, 4] metres"},
        {"steps=1.5", "one whole number"},
        {"steps=0", "[1, 512]"},
        {"steps=99999999999999999999", "[1, 512]"},
        {"shown=2", "true or false"},
        {"shown=True", "true or false"},
        {"shown=", "true or false"},
        {"colour=1", "three numbers"},
        {"colour=1,1", "three numbers"},
        {"colour=1,1,1,1", "three numbers"},
        {"colour=1,1,1,", "three numbers"},
        {"colour=1,,1", "three numbers"},
        {"colour=0,0,1.5", "[0, 1]"},
    };
    struct parameters read = parameter_text(sample);
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        char where[128];
        snprintf(where, sizeof where, "--set %s: ", refused[i][0]);
        capture_begin();
        bool done = parameters_assign(&read, refused[i][0]);
        const char *said = capture_end();
        if (done)
            fail_msg("not refused: %s", refused[i][0]);
        parameter_said(said, where, refused[i][1]);
    }
    for (int i = 0; i < read.count; i++)
        assert_memory_equal(read.item[i].value, read.item[i].initial, sizeof read.item[i].value);
    parameters_free(&read);
    struct parameters none = {0};
    capture_begin();
    assert_false(parameters_assign(&none, "a=1"));
    parameter_said(capture_end(), "--set a=1", "has no parameters");
}

TEST(test_key_presses_change_values)
{
    struct parameters read = parameter_text(sample);
    struct parameter *p = parameters_find(&read, "height");
    for (int i = 0; i < 10; i++)
        parameter_change(p, -1);
    // The values must be exact. A plain sum of steps of 0.1 would drift, and miss 0 and 0.3.
    assert_true(p->value[0] == 0.0);
    parameter_change(p, 3);
    assert_true(p->value[0] == 0.3);
    parameter_change(p, -3);
    assert_true(p->value[0] == 0.0);
    parameter_change(p, 1000);
    parameter_number(p->value[0], 4.0);
    parameter_change(p, -1000);
    parameter_number(p->value[0], -2.0);
    parameter_reset(p);
    parameter_number(p->value[0], 1.0);
    p = parameters_find(&read, "small");
    parameter_change(p, 3);
    parameter_number(p->value[0], 0.008);
    parameter_change(p, -3);
    parameter_number(p->value[0], 0.001);
    parameter_change(p, -50);
    parameter_number(p->value[0], 1e-6);
    p = parameters_find(&read, "shown");
    parameter_change(p, 10);
    parameter_number(p->value[0], 1.0);
    parameter_change(p, 0);
    parameter_number(p->value[0], 1.0);
    parameter_change(p, -1);
    parameter_number(p->value[0], 0.0);
    p = parameters_find(&read, "colour");
    parameter_change(p, -1);
    parameter_number(p->value[0], 0.99);
    parameter_number(p->value[2], 0.49);
    // 1 times 1.1 is rounded to 1, but a key press must still change the value.
    p = parameters_find(&read, "more");
    parameter_change(p, 1);
    parameter_number(p->value[0], 2.0);
    parameters_free(&read);
}

TEST(test_a_value_edited_in_the_file_is_used)
{
    struct parameters old = parameter_text("uniform float height; // 2 in [0, 9]: x\n"
                                           "uniform vec3 colour; // 0.1, 0.2, 0.3 in [0, 1]: x\n");
    struct parameters new = parameter_text("uniform float height; // 4 in [0, 9]: x\n"
                                           "uniform vec3 colour; // 0.1, 0.9, 0.3 in [0, 1]: x\n");
    assert_true(parameters_assign(&old, "height=3"));
    assert_true(parameters_assign(&old, "colour=1,1,1"));
    parameters_keep(&new, &old);
    parameter_number(parameters_find(&new, "height")->value[0], 4.0);
    const double *colour = parameters_find(&new, "colour")->value;
    parameter_number(colour[0], 1.0);
    parameter_number(colour[1], 0.9);
    parameter_number(colour[2], 1.0);
    parameters_free(&old);
    parameters_free(&new);
}

TEST(test_reload_keeps_values)
{
    struct parameters old = parameter_text(sample);
    struct parameters new =
        parameter_text("uniform float colour; // 1 in [0, 1]: another type\n"
                       "uniform float height; // 1 in [-1, 2]: a smaller range\n"
                       "uniform float steps; // 2 in [0, 9]: another type\n"
                       "uniform bool shown; // false: x\n"
                       "uniform int fresh; // 3 in [0, 9]: x\n");
    assert_true(parameters_assign(&old, "height=3"));
    assert_true(parameters_assign(&old, "shown=true"));
    assert_true(parameters_assign(&old, "steps=5"));
    parameters_keep(&new, &old);
    parameter_number(parameters_find(&new, "height")->value[0], 2.0);
    parameter_number(parameters_find(&new, "height")->initial[0], 1.0);
    parameter_number(parameters_find(&new, "shown")->value[0], 1.0);
    parameter_number(parameters_find(&new, "colour")->value[0], 1.0);
    parameter_number(parameters_find(&new, "steps")->value[0], 2.0);
    parameter_number(parameters_find(&new, "fresh")->value[0], 3.0);
    parameters_free(&old);
    parameters_free(&new);
}

// ---- Printing ----

static void assert_printed(const struct parameters *parameters, const char *expected)
{
    char printed[4096];
    FILE *file = system_open_scratch();
    parameters_print(parameters, file);
    rewind(file);
    size_t size = fread(printed, 1, sizeof printed - 1, file);
    printed[size] = '\0';
    fclose(file);
    assert_string_equal(printed, expected);
}

TEST(test_the_table_lists_all_parameters)
{
    struct parameters read =
        parameter_text("uniform float tilt; // 1e-3 in [1e-6, 100000], \u00b0: m \u00e9\n"
                       "uniform bool shown; // true: whether\n"
                       "uniform vec2 v; // 1, 0.25 in [0, 1], linear RGB: n\n");
    assert_printed(&read, "name   value   range           unit        meaning\n"
                          "tilt   0.001   [1e-6, 100000]  \u00b0           m \u00e9\n"
                          "shown  true    true or false   -           whether\n"
                          "v      1,0.25  [0, 1]          linear RGB  n\n");
    parameters_free(&read);
    assert_printed(&read, "This shader has no parameters.\n");
}

// In French and German, the decimal separator is a comma, but shaders and command lines still use a
// point.
TEST(test_another_locale_changes_nothing)
{
    static const char *const locales[] = {"fr_FR.UTF-8", "de_DE.UTF-8", "fr_FR", "de_DE"};
    const char *found = NULL;
    for (size_t i = 0; i < sizeof locales / sizeof *locales && found == NULL; i++)
        found = setlocale(LC_NUMERIC, locales[i]);
    if (found == NULL)
        skip();
    struct parameters read = parameter_text(sample);
    assert_assigned(&read, "height=.25", "0.25");
    assert_assigned(&read, "colour=0.5,0.25,1", "0.5,0.25,1");
    parameters_free(&read);
    setlocale(LC_NUMERIC, "C");
}

TESTS(NULL, NULL)
