// test_parameter.c - annotated uniforms: what declares a parameter, what is refused and in which
// line, and how values are set, changed, kept and printed.
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
// cmocka needs the four above.
#include <cmocka.h>

#include <locale.h>
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../common/number.h"
#include "../common/shader/parameter.h"
#include "support_scratch.h"

#define LINES 64

// ---- Sources without files ----

static struct shader_source source_of(const char *text, enum shader_form form)
{
    static char name[] = "my.frag";
    static char *files[] = {name};
    static struct shader_line lines[LINES];
    static char copy[8192];
    static struct glsl code;
    snprintf(copy, sizeof copy, "%s", text);
    glsl_free(&code);
    glsl_read(&code, copy);
    int count = line_count(copy);
    assert_true(count <= LINES);
    for (int i = 0; i < count; i++)
        lines[i] = (struct shader_line){0, i + 1};
    return (struct shader_source){.form = form,
                                  .text = copy,
                                  .code = code,
                                  .lines = lines,
                                  .line_count = count,
                                  .files = files,
                                  .file_count = 1};
}

static struct parameters read_text(const char *text)
{
    struct parameters parameters;
    struct shader_source source = source_of(text, SHADER_COURSE);
    capture_begin();
    bool done = parameters_read(&parameters, &source);
    const char *said = capture_end();
    if (!done || said[0] != '\0')
        fail_msg("%s: %s", text, said);
    return parameters;
}

static struct parameters read_one(const char *line)
{
    struct parameters parameters = read_text(line);
    if (parameters.count != 1)
        fail_msg("%d parameters in: %s", parameters.count, line);
    return parameters;
}

// Said must be one line with each of two phrases.
static void assert_said(const char *said, const char *where, const char *why)
{
    if (line_count(said) != 1 || strstr(said, where) == NULL || strstr(said, why) == NULL)
        fail_msg("not one line with '%s' and '%s': %s", where, why, said);
}

static void assert_refused(const char *line, const char *why)
{
    struct parameters parameters;
    char text[1024];
    snprintf(text, sizeof text, "\n\n%s\n", line);
    struct shader_source source = source_of(text, SHADER_COURSE);
    capture_begin();
    bool done = parameters_read(&parameters, &source);
    const char *said = capture_end();
    if (done)
        fail_msg("not refused: %s", line);
    assert_said(said, "my.frag:3: ", why);
    assert_null(parameters.item);
}

static void assert_number(double value, double expected)
{
    if (!(fabs(value - expected) <= 1e-12 * fabs(expected)))
        fail_msg("%.17g is not %.17g", value, expected);
}

// ---- Reading ----

static void test_all_parts(void **state)
{
    (void)state;
    struct parameters read =
        read_one("uniform float sunElevation;   // 40 in [-90, 90] step 1, degrees: "
                 "height of the sun: above the horizon\n");
    const struct parameter *p = read.item;
    assert_string_equal(p->name, "sunElevation");
    assert_int_equal(p->type, PARAMETER_FLOAT);
    assert_int_equal(p->components, 1);
    assert_number(p->value[0], 40.0);
    assert_number(p->initial[0], 40.0);
    assert_number(p->minimum, -90.0);
    assert_number(p->maximum, 90.0);
    assert_number(p->step, 1.0);
    assert_false(p->multiplies);
    assert_string_equal(p->unit, "degrees");
    assert_string_equal(p->meaning, "height of the sun: above the horizon");
    parameters_free(&read);
    assert_null(read.item);
}

static void test_types_and_default_steps(void **state)
{
    (void)state;
    struct parameters read =
        read_text("uniform int   maxSteps;     // 128 in [1, 512]: steps\n"
                  "uniform float normalStep;   // 0.001 in [1e-6, 0.1] step *2, scene units: step\n"
                  "uniform bool  biased;       // true: show 0.5 N + 0.5\n"
                  "uniform bool  plain;//false:x\n"
                  "\tuniform  vec3 lightColour ; // 1.0, 0.9, 0.5 in [0, 1], linear RGB: light\n"
                  "uniform highp vec2 both;    // .5 in [-3., +3E0]: both\n"
                  "uniform /* four */ vec4 four; /* // 9 */ // 1,2,3,4 in[1,5]step*1.5,a b:c\n");
    assert_int_equal(read.count, 7);
    const struct parameter *p = read.item;
    assert_int_equal(p[0].type, PARAMETER_INT);
    assert_number(p[0].step, 1.0);
    assert_true(p[1].multiplies);
    assert_number(p[1].step, 2.0);
    assert_number(p[1].minimum, 1e-6);
    assert_int_equal(p[2].type, PARAMETER_BOOL);
    assert_number(p[2].value[0], 1.0);
    assert_number(p[3].initial[0], 0.0);
    assert_number(p[3].maximum, 1.0);
    assert_int_equal(p[4].components, 3);
    assert_number(p[4].value[1], 0.9);
    assert_number(p[4].step, 0.01);
    assert_string_equal(p[4].unit, "linear RGB");
    assert_int_equal(p[5].components, 2);
    assert_number(p[5].value[1], 0.5);
    assert_number(p[5].minimum, -3.0);
    assert_number(p[5].step, 0.06);
    assert_string_equal(p[5].unit, "");
    assert_number(p[6].value[3], 4.0);
    assert_number(p[6].step, 1.5);
    assert_string_equal(p[6].unit, "a b");
    assert_string_equal(p[6].meaning, "c");
    parameters_free(&read);
}

// A French keyboard types a space that cannot break; a terminal would obey an escape.
static void test_blanks_and_controls(void **state)
{
    (void)state;
    struct parameters read = read_text("uniform float a; //\xC2\xA0"
                                       "1 in\xE2\x80\xAF[0,\xC2\xA0"
                                       "2] step\xC2\xA0"
                                       "0.5\xC2\xA0:\xC2\xA0the\x1B[2J width\xC2\x9B\n");
    assert_int_equal(read.count, 1);
    assert_number(read.item->step, 0.5);
    assert_string_equal(read.item->meaning, "the?[2J width??");
    parameters_free(&read);
}

static void test_decimal_commas(void **state)
{
    (void)state;
    assert_refused("uniform float a; // 0,5 in [0, 1]: a", "the value has a comma: write 0.5");
    assert_refused("uniform float a; // 0.5 in [0, 1,5]: a", "the maximum has a comma: write 1.5");
    assert_refused("uniform float a; // 0.5 in [0, 1] step 0,1: a",
                   "the step has a comma: write 0.1");
    assert_refused("uniform float a; // 1 in [1, 2] step *1,5: a",
                   "the factor has a comma: write 1.5");
}

static void test_other_comments_declare_nothing(void **state)
{
    (void)state;
    struct parameters read = read_text("uniform float a;\n"
                                       "uniform vec2 b; // 2D position\n"
                                       "uniform float c; // the value 3 in [0, 4]: x\n"
                                       "uniform float d; // truth: x\n"
                                       "uniform float e; // -90..90 degrees\n"
                                       "uniform float f; // inf in [0, 1]: x\n"
                                       "uniform float g; // 1/2 of it\n"
                                       "uniform bool h; // falsehood\n"
                                       "uniform float i; /* 1 in [0, 2]: block */\n"
                                       "// uniform float j; // 1 in [0, 2]: x\n"
                                       "/* uniform float k; // 1 in [0, 2]: x\n"
                                       "uniform float l; // 1 in [0, 2]: x\n"
                                       "*/ // goes on \\\n"
                                       "uniform float m; // 1 in [0, 2]: x\n"
                                       "uniforms float n; // 1 in [0, 2]: x\n"
                                       "float o; // 1 in [0, 2]: x\n"
                                       "uniform float p, q; // two of them\n"
                                       "uniform float s; // 3px: x\n");
    if (read.count != 0)
        fail_msg("%s is not a parameter", read.item[0].name);
    parameters_free(&read);
}

static void test_only_the_course_form_has_parameters(void **state)
{
    (void)state;
    struct parameters parameters;
    struct shader_source source = source_of("uniform float a; // 1 in\n", SHADER_WHOLE);
    assert_true(parameters_read(&parameters, &source));
    assert_int_equal(parameters.count, 0);
    parameters_free(&parameters);
}

static void test_malformed_values(void **state)
{
    (void)state;
    assert_refused("uniform float a; // 1", "no range");
    assert_refused("uniform float a; // 1: meaning", "no range");
    assert_refused("uniform float a; // 2 times the radius", "no range");
    assert_refused("uniform float a; // 1 [0, 2]: x", "no range");
    assert_refused("uniform float a; // 3 in [0, 2]: x", "outside its range");
    assert_refused("uniform vec2 a; // 1, 3 in [0, 2]: x", "outside its range");
    assert_refused("uniform vec3 a; // 1, 1 in [0, 2]: x", "2 values for 3 components");
    assert_refused("uniform float a; // 1, 1 in [0, 2]: x", "2 values for 1 component:");
    assert_refused("uniform vec4 a; // 1, 1, 1, 1, 1 in [0, 2]: x", "5 values for 4");
    assert_refused("uniform float a; // 1, degrees: x", "must be a number");
    assert_refused("uniform float a; // true: x", "must be a number");
    assert_refused("uniform float a; // 1e999 in [0, 2]: x", "too large");
    assert_refused("uniform float a; // 1 in [0, 1e39]: x", "too large");
    assert_refused("uniform int a; // 1.5 in [0, 2]: x", "whole");
    assert_refused("uniform int a; // 1 in [0, 2.5]: x", "whole");
    assert_refused("uniform int a; // 1 in [0, 9999999999]: x", "whole");
    assert_refused("uniform int a; // 1 in [0, 2] step 0.5: x", "whole");
    assert_refused("uniform bool a; // 1: x", "true or false");
    assert_refused("uniform bool a; // true in [0, 1]: x", "no range");
    assert_refused("uniform bool a; // true, unit: x", "no unit");
    assert_refused("uniform bool a; // true", "write");
}

static void test_malformed_rest(void **state)
{
    (void)state;
    assert_refused("uniform float a; // 1 in [0 2]: x", "comma");
    assert_refused("uniform float a; // 1 in [0, 2: x", "not closed");
    assert_refused("uniform float a; // 1 in [a, 2]: x", "minimum must be a number");
    assert_refused("uniform float a; // 1 in [0, nan]: x", "maximum must be a number");
    assert_refused("uniform float a; // 1 in [2, 0]: x", "range is empty");
    assert_refused("uniform float a; // 1 in [1, 1]: x", "range is empty");
    assert_refused("uniform float a; // 1 in [0, 2] step 0: x", "above 0");
    assert_refused("uniform float a; // 1 in [0, 2] step -1: x", "above 0");
    assert_refused("uniform float a; // 1 in [0, 2] step: x", "step must be a number");
    assert_refused("uniform float a; // 1 in [0, 2] step *2: x", "multiplies");
    assert_refused("uniform float a; // 1 in [0.5, 2] step *1: x", "multiplies");
    assert_refused("uniform float a; // 1 in [0, 2]", "no meaning");
    assert_refused("uniform float a; // 1 in [0, 2]:", "no meaning");
    assert_refused("uniform float a; // 1 in [0, 2], unit", "no meaning");
    assert_refused("uniform float a; // 1 in [0, 2], : x", "no unit");
    assert_refused("uniform float a; // 1 in [0, 2] metres: x", "not understood");
    assert_refused("uniform float a; // 1 in [0, 2], "
                   "0123456789012345678901234567890123456789012345678: x",
                   "unit is too long");
}

static void test_malformed_declarations(void **state)
{
    (void)state;
    assert_refused("uniform uint a; // 1 in [0, 2]: x", "a uint cannot be a parameter");
    assert_refused("uniform mat3 a; // 1 in [0, 2]: x", "a mat3 cannot be a parameter");
    assert_refused("uniform float a, b; // 1 in [0, 2]: x", "alone on its line");
    assert_refused("uniform float a[2]; // 1 in [0, 2]: x", "alone on its line");
    assert_refused("uniform float a = 1.0; // 1 in [0, 2]: x", "alone on its line");
    assert_refused("uniform float // 1 in [0, 2]: x", "not a parameter's declaration");
    assert_refused("uniform float a; float b; // 1 in [0, 2]: x", "alone on its line");
    char line[512];
    snprintf(line, sizeof line, "uniform float %070d; // 1 in [0, 2]: x", 0);
    assert_refused(line, "63 letters");
    snprintf(line, sizeof line, "uniform float a; // 1 in [0, 2]: %0200d", 0);
    assert_refused(line, "meaning is too long");
    struct parameters parameters;
    struct shader_source source = source_of("uniform float a; // 1 in [0, 2]: x\n"
                                            "uniform int a; // 1 in [0, 2]: x\n",
                                            SHADER_COURSE);
    capture_begin();
    assert_false(parameters_read(&parameters, &source));
    assert_said(capture_end(), "my.frag:2: parameter a: ", "declared twice");
}

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

static void test_assignments(void **state)
{
    (void)state;
    struct parameters read = read_text(sample);
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

static void test_refused_assignments(void **state)
{
    (void)state;
    static const char *const refused[][2] = {
        {"nothing=1", "height, steps, shown, colour, small, more"},
        {"heigh=1", "no parameter"},
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
    struct parameters read = read_text(sample);
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++) {
        char where[128];
        snprintf(where, sizeof where, "--set %s: ", refused[i][0]);
        capture_begin();
        bool done = parameters_assign(&read, refused[i][0]);
        const char *said = capture_end();
        if (done)
            fail_msg("not refused: %s", refused[i][0]);
        assert_said(said, where, refused[i][1]);
    }
    for (int i = 0; i < read.count; i++)
        assert_memory_equal(read.item[i].value, read.item[i].initial, sizeof read.item[i].value);
    parameters_free(&read);
    struct parameters none = {0};
    capture_begin();
    assert_false(parameters_assign(&none, "a=1"));
    assert_said(capture_end(), "--set a=1", "has no parameters");
}

static void test_key_presses(void **state)
{
    (void)state;
    struct parameters read = read_text(sample);
    struct parameter *p = parameters_find(&read, "height");
    for (int i = 0; i < 10; i++)
        parameter_change(p, -1);
    // To the bit: a sum of steps of 0.1 that drifts misses 0 and 0.3.
    assert_true(p->value[0] == 0.0);
    parameter_change(p, 3);
    assert_true(p->value[0] == 0.3);
    parameter_change(p, -3);
    assert_true(p->value[0] == 0.0);
    parameter_change(p, 1000);
    assert_number(p->value[0], 4.0);
    parameter_change(p, -1000);
    assert_number(p->value[0], -2.0);
    parameter_reset(p);
    assert_number(p->value[0], 1.0);
    p = parameters_find(&read, "small");
    parameter_change(p, 3);
    assert_number(p->value[0], 0.008);
    parameter_change(p, -3);
    assert_number(p->value[0], 0.001);
    parameter_change(p, -50);
    assert_number(p->value[0], 1e-6);
    p = parameters_find(&read, "shown");
    parameter_change(p, 10);
    assert_number(p->value[0], 1.0);
    parameter_change(p, 0);
    assert_number(p->value[0], 1.0);
    parameter_change(p, -1);
    assert_number(p->value[0], 0.0);
    p = parameters_find(&read, "colour");
    parameter_change(p, -1);
    assert_number(p->value[0], 0.99);
    assert_number(p->value[2], 0.49);
    // A factor of 1.1 rounds 1 to 1: a press must move it all the same.
    p = parameters_find(&read, "more");
    parameter_change(p, 1);
    assert_number(p->value[0], 2.0);
    parameters_free(&read);
}

static void test_a_value_edited_in_the_file_is_taken(void **state)
{
    (void)state;
    struct parameters old = read_text("uniform float height; // 2 in [0, 9]: x\n"
                                      "uniform vec3 colour; // 0.1, 0.2, 0.3 in [0, 1]: x\n");
    struct parameters new = read_text("uniform float height; // 4 in [0, 9]: x\n"
                                      "uniform vec3 colour; // 0.1, 0.9, 0.3 in [0, 1]: x\n");
    assert_true(parameters_assign(&old, "height=3"));
    assert_true(parameters_assign(&old, "colour=1,1,1"));
    parameters_keep(&new, &old);
    assert_number(parameters_find(&new, "height")->value[0], 4.0);
    const double *colour = parameters_find(&new, "colour")->value;
    assert_number(colour[0], 1.0);
    assert_number(colour[1], 0.9);
    assert_number(colour[2], 1.0);
    parameters_free(&old);
    parameters_free(&new);
}

static void test_reload_keeps_values(void **state)
{
    (void)state;
    struct parameters old = read_text(sample);
    struct parameters new = read_text("uniform float colour; // 1 in [0, 1]: another type\n"
                                      "uniform float height; // 1 in [-1, 2]: a smaller range\n"
                                      "uniform float steps; // 2 in [0, 9]: another type\n"
                                      "uniform bool shown; // false: x\n"
                                      "uniform int fresh; // 3 in [0, 9]: x\n");
    assert_true(parameters_assign(&old, "height=3"));
    assert_true(parameters_assign(&old, "shown=true"));
    assert_true(parameters_assign(&old, "steps=5"));
    parameters_keep(&new, &old);
    assert_number(parameters_find(&new, "height")->value[0], 2.0);
    assert_number(parameters_find(&new, "height")->initial[0], 1.0);
    assert_number(parameters_find(&new, "shown")->value[0], 1.0);
    assert_number(parameters_find(&new, "colour")->value[0], 1.0);
    assert_number(parameters_find(&new, "steps")->value[0], 2.0);
    assert_number(parameters_find(&new, "fresh")->value[0], 3.0);
    parameters_free(&old);
    parameters_free(&new);
}

// ---- Printing ----

static void assert_printed(const struct parameters *parameters, const char *expected)
{
    char printed[4096];
    FILE *file = tmpfile();
    assert_non_null(file);
    parameters_print(parameters, file);
    rewind(file);
    size_t size = fread(printed, 1, sizeof printed - 1, file);
    printed[size] = '\0';
    fclose(file);
    assert_string_equal(printed, expected);
}

static void test_table(void **state)
{
    (void)state;
    struct parameters read =
        read_text("uniform float tilt; // 1e-3 in [1e-6, 100000], \u00b0: m \u00e9\n"
                  "uniform bool shown; // true: whether\n"
                  "uniform vec2 v; // 1, 0.25 in [0, 1], linear RGB: n\n");
    assert_printed(&read, "name   value   range           unit        meaning\n"
                          "tilt   0.001   [1e-6, 100000]  \u00b0           m \u00e9\n"
                          "shown  true    true or false   -           whether\n"
                          "v      1,0.25  [0, 1]          linear RGB  n\n");
    parameters_free(&read);
    assert_printed(&read, "This shader has no parameters.\n");
}

static void test_numbers_as_text(void **state)
{
    (void)state;
    static const struct {
        double value;
        const char *text;
    } numbers[] = {{0.1 + 0.2, "0.3"},           {-0.0, "0"},
                   {2147483647.0, "2147483647"}, {1e-7, "1e-7"},
                   {-1.5e-10, "-1.5e-10"},       {1e20, "1e20"},
                   {250.125, "250.125"},         {1.0 / 3.0, "0.33333333"}};
    char written[32];
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        double back;
        number_text(numbers[i].value, written, sizeof written);
        assert_string_equal(written, numbers[i].text);
        assert_true(number_read(written, &back));
        assert_true((float)back == (float)numbers[i].value);
    }
}

// In French a comma stands before the decimals; a shader and a command line have a point all the
// same.
static void test_another_locale(void **state)
{
    (void)state;
    static const char *const locales[] = {"fr_FR.UTF-8", "de_DE.UTF-8", "fr_FR", "de_DE"};
    const char *found = NULL;
    for (size_t i = 0; i < sizeof locales / sizeof *locales && found == NULL; i++)
        found = setlocale(LC_NUMERIC, locales[i]);
    if (found == NULL)
        skip();
    struct parameters read = read_text(sample);
    assert_assigned(&read, "height=.25", "0.25");
    assert_assigned(&read, "colour=0.5,0.25,1", "0.5,0.25,1");
    parameters_free(&read);
    setlocale(LC_NUMERIC, "C");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_all_parts),
        cmocka_unit_test(test_types_and_default_steps),
        cmocka_unit_test(test_blanks_and_controls),
        cmocka_unit_test(test_decimal_commas),
        cmocka_unit_test(test_other_comments_declare_nothing),
        cmocka_unit_test(test_only_the_course_form_has_parameters),
        cmocka_unit_test(test_malformed_values),
        cmocka_unit_test(test_malformed_rest),
        cmocka_unit_test(test_malformed_declarations),
        cmocka_unit_test(test_assignments),
        cmocka_unit_test(test_refused_assignments),
        cmocka_unit_test(test_key_presses),
        cmocka_unit_test(test_a_value_edited_in_the_file_is_taken),
        cmocka_unit_test(test_reload_keeps_values),
        cmocka_unit_test(test_table),
        cmocka_unit_test(test_numbers_as_text),
        cmocka_unit_test(test_another_locale),
    };
    return cmocka_run_group_tests_name("parameter", tests, NULL, NULL);
}
