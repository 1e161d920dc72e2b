// parameter_read.c - tests annotated uniforms: which comments declare a parameter, and which are
// refused, with the right line and reason.
#include "lib/test.h"
#include "lib/parameter.h"
#include "lib/scratch.h"

static struct parameters read_one(const char *line)
{
    struct parameters parameters = parameter_text(line);
    if (parameters.count != 1)
        fail_msg("%d parameters in: %s", parameters.count, line);
    return parameters;
}

static void assert_refused(const char *line, const char *why)
{
    struct parameters parameters;
    char text[1024];
    snprintf(text, sizeof text, "\n\n%s\n", line);
    struct shader_source source = parameter_source(text, DIALECT_COURSE);
    capture_begin();
    bool done = parameters_read(&parameters, &source);
    const char *said = capture_end();
    if (done)
        fail_msg("not refused: %s", line);
    parameter_said(said, "my.frag:3: ", why);
    assert_null(parameters.item);
}

// ---- Reading ----

TEST(test_all_parts_are_read)
{
    struct parameters read =
        read_one("uniform float sunElevation;   // 40 in [-90, 90] step 1, degrees: "
                 "height of the sun: above the horizon\n");
    const struct parameter *p = read.item;
    assert_string_equal(p->name, "sunElevation");
    assert_int_equal(p->type, PARAMETER_FLOAT);
    assert_int_equal(p->components, 1);
    parameter_number(p->value[0], 40.0);
    parameter_number(p->initial[0], 40.0);
    parameter_number(p->minimum, -90.0);
    parameter_number(p->maximum, 90.0);
    parameter_number(p->step, 1.0);
    assert_false(p->multiplies);
    assert_string_equal(p->unit, "degrees");
    assert_string_equal(p->meaning, "height of the sun: above the horizon");
    parameters_free(&read);
    assert_null(read.item);
}

TEST(test_handles_are_read)
{
    struct parameters read = parameter_text(
        "uniform vec2 aim;   // (0.6, 0.1) handle scene units: where the ray points\n"
        "uniform vec3 ball;  // (1, 2, -3) handle: the ball\n"
        "uniform vec3 lamp;  // 1, 2, 0 in [-5, 5] step 0.1, handle xz scene units: the lamp\n"
        "uniform vec2 plain; // 1, 2 in [0, 5], handles: two of them\n"
        "uniform vec2 none;  // (2) is a comment\n");
    assert_int_equal(read.count, 4);
    const struct parameter *p = read.item;
    static const enum parameter_handle handles[] = {HANDLE_XY, HANDLE_SCREEN, HANDLE_XZ,
                                                    HANDLE_NONE};
    static const char *const units[] = {"scene units", "", "scene units", "handles"};
    static const double ends[][2] = {{-10.0, 10.0}, {-10.0, 10.0}, {-5.0, 5.0}, {0.0, 5.0}};
    for (int i = 0; i < read.count; i++) {
        assert_int_equal(p[i].handle, handles[i]);
        assert_string_equal(p[i].unit, units[i]);
        parameter_number(p[i].minimum, ends[i][0]);
        parameter_number(p[i].maximum, ends[i][1]);
    }
    parameter_number(p[0].value[1], 0.1);
    parameter_number(p[1].value[2], -3.0);
    parameters_free(&read);
    assert_refused("uniform vec2 a; // (1, 2 handle: a", "the values need a closing parenthesis");
    assert_refused("uniform float a; // 1 handle: a", "only a vec2 or a vec3 can be a handle");
    assert_refused("uniform vec4 a; // 1 in [0, 2], handle: a", "only a vec2 or a vec3");
    assert_refused("uniform vec2 a; // (11, 2) handle: a", "outside its range");
}

TEST(test_types_and_default_steps_are_read)
{
    struct parameters read = parameter_text(
        "uniform int   maxSteps;     // 128 in [1, 512]: steps\n"
        "uniform float normalStep;   // 0.001 in [1e-6, 0.1] step *2, scene units: step\n"
        "uniform bool  biased;       // true: show 0.5 N + 0.5\n"
        "uniform bool  plain;//false:x\n"
        "\tuniform  vec3 lightColour ; // 1.0, 0.9, 0.5 in [0, 1], linear RGB: light\n"
        "uniform highp vec2 both;    // .5 in [-3., +3E0]: both\n"
        "uniform /* four */ vec4 four; /* // 9 */ // 1,2,3,4 in[1,5]step*1.5,a b:c\n");
    assert_int_equal(read.count, 7);
    const struct parameter *p = read.item;
    assert_int_equal(p[0].type, PARAMETER_INT);
    parameter_number(p[0].step, 1.0);
    assert_true(p[1].multiplies);
    parameter_number(p[1].step, 2.0);
    parameter_number(p[1].minimum, 1e-6);
    assert_int_equal(p[2].type, PARAMETER_BOOL);
    parameter_number(p[2].value[0], 1.0);
    parameter_number(p[3].initial[0], 0.0);
    parameter_number(p[3].maximum, 1.0);
    assert_int_equal(p[4].components, 3);
    parameter_number(p[4].value[1], 0.9);
    parameter_number(p[4].step, 0.01);
    assert_string_equal(p[4].unit, "linear RGB");
    assert_int_equal(p[5].components, 2);
    parameter_number(p[5].value[1], 0.5);
    parameter_number(p[5].minimum, -3.0);
    parameter_number(p[5].step, 0.06);
    assert_string_equal(p[5].unit, "");
    parameter_number(p[6].value[3], 4.0);
    parameter_number(p[6].step, 1.5);
    assert_string_equal(p[6].unit, "a b");
    assert_string_equal(p[6].meaning, "c");
    parameters_free(&read);
}

// No-break spaces, which a French keyboard types, count as blanks. Control characters, which a
// terminal would obey, become '?'.
TEST(test_no_break_spaces_are_blanks_and_controls_are_replaced)
{
    struct parameters read = parameter_text("uniform float a; //\xC2\xA0"
                                            "1 in\xE2\x80\xAF[0,\xC2\xA0"
                                            "2] step\xC2\xA0"
                                            "0.5\xC2\xA0:\xC2\xA0the\x1B[2J width\xC2\x9B\n");
    assert_int_equal(read.count, 1);
    parameter_number(read.item->step, 0.5);
    assert_string_equal(read.item->meaning, "the?[2J width??");
    parameters_free(&read);
}

TEST(test_decimal_commas_are_refused_with_a_hint)
{
    assert_refused("uniform float a; // 0,5 in [0, 1]: a", "the value has a comma: write 0.5");
    assert_refused("uniform float a; // 0.5 in [0, 1,5]: a", "the maximum has a comma: write 1.5");
    assert_refused("uniform float a; // 0.5 in [0, 1] step 0,1: a",
                   "the step has a comma: write 0.1");
    assert_refused("uniform float a; // 1 in [1, 2] step *1,5: a",
                   "the factor has a comma: write 1.5");
}

TEST(test_other_comments_declare_nothing)
{
    struct parameters read = parameter_text("uniform float a;\n"
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
        fail_msg("%s is read as a parameter", read.item[0].name);
    parameters_free(&read);
}

TEST(test_other_dialects_ignore_malformed_comments)
{
    struct parameters parameters;
    struct shader_source source = parameter_source("uniform float a; // 1 in\n", DIALECT_WHOLE);
    assert_true(parameters_read(&parameters, &source));
    assert_int_equal(parameters.count, 0);
    parameters_free(&parameters);
}

TEST(test_malformed_values_are_refused)
{
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

TEST(test_malformed_ranges_steps_units_and_meanings_are_refused)
{
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
    assert_refused("uniform float a; // 1 in [0, 2]", "meaning is missing");
    assert_refused("uniform float a; // 1 in [0, 2]:", "meaning is missing");
    assert_refused("uniform float a; // 1 in [0, 2], unit", "meaning is missing");
    assert_refused("uniform float a; // 1 in [0, 2], : x", "unit is missing");
    assert_refused("uniform float a; // 1 in [0, 2] metres: x", "not understood");
    assert_refused("uniform float a; // 1 in [0, 2], "
                   "0123456789012345678901234567890123456789012345678: x",
                   "unit is too long");
}

TEST(test_malformed_declarations_are_refused)
{
    assert_refused("uniform uint a; // 1 in [0, 2]: x", "a uint cannot be a parameter");
    assert_refused("uniform mat3 a; // 1 in [0, 2]: x", "a mat3 cannot be a parameter");
    assert_refused("uniform float a, b; // 1 in [0, 2]: x", "alone on its line");
    assert_refused("uniform float a[2]; // 1 in [0, 2]: x", "alone on its line");
    assert_refused("uniform float a = 1.0; // 1 in [0, 2]: x", "alone on its line");
    assert_refused("uniform float // 1 in [0, 2]: x", "not a parameter's declaration");
    assert_refused("uniform float a; float b; // 1 in [0, 2]: x", "alone on its line");
    char line[512];
    snprintf(line, sizeof line, "uniform float %070d; // 1 in [0, 2]: x", 0);
    assert_refused(line, "63 characters");
    snprintf(line, sizeof line, "uniform float a; // 1 in [0, 2]: %0200d", 0);
    assert_refused(line, "meaning is too long");
    struct parameters parameters;
    struct shader_source source = parameter_source("uniform float a; // 1 in [0, 2]: x\n"
                                                   "uniform int a; // 1 in [0, 2]: x\n",
                                                   DIALECT_COURSE);
    capture_begin();
    assert_false(parameters_read(&parameters, &source));
    parameter_said(capture_end(), "my.frag:2: parameter a: ", "declared twice");
}

TESTS(NULL, NULL)
