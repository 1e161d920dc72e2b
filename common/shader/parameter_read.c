#include "shader/parameter.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "shader/annotation.h"
#include "shader/glsl.h"
#include "memory.h"
#include "number.h"

#define BLANKS  ANNOTATION_BLANKS
#define EXAMPLE "uniform float NAME; // 1 in [0, 10] step 0.5, unit: meaning"

// One annotated uniform being read.
struct reading {
    struct annotation a;
    struct parameter parameter;
};

// Report a malformed annotation; always false.
#define refuse(reading, ...) annotation_refuse(&(reading)->a, __VA_ARGS__)

//   single  no comma may follow but one that begins a word
static bool read_any_number(struct reading *reading, const char *what, bool single, double *value)
{
    reading->a.c += strspn(reading->a.c, BLANKS);
    size_t length = number_begin(reading->a.c, value);
    if (length == 0)
        return refuse(reading, "%s must be a number, not '%.20s'", what, reading->a.c);
    const char *comma = reading->a.c + length;
    if (single && comma[0] == ',' && comma[1] >= '0' && comma[1] <= '9')
        return refuse(reading, "%s has a comma: write %.*s.%.*s", what, (int)length, reading->a.c,
                      (int)strspn(comma + 1, "0123456789"), comma + 1);
    reading->a.c += length;
    if (!isfinite((float)*value))
        return refuse(reading, "%s is too large for a float", what);
    return true;
}

// Read a number that the parameter's type can hold.
static bool read_number(struct reading *reading, const char *what, bool single, double *value)
{
    if (!read_any_number(reading, what, single, value))
        return false;
    if (reading->parameter.type == PARAMETER_INT &&
        (*value != floor(*value) || fabs(*value) > INT_MAX))
        return refuse(reading, "%s must be a whole number, for the uniform is an int", what);
    return true;
}

// ---- The parts of a comment ----

// The rule of parameter.h.
static bool begins_with_value(const char *comment)
{
    double ignored;
    const char *c = comment + strspn(comment, BLANKS);
    size_t length = number_begin(c, &ignored);
    if (strncmp(c, "true", 4) == 0)
        length = 4;
    else if (strncmp(c, "false", 5) == 0)
        length = 5;
    return length > 0 && strchr(BLANKS ",:", c[length]) != NULL; // the text's end included
}

static bool read_bool_value(struct reading *reading)
{
    struct parameter *p = &reading->parameter;
    bool yes = annotation_accept_word(&reading->a, "true");
    if (!yes && !annotation_accept_word(&reading->a, "false"))
        return refuse(reading, "the value of a bool is true or false: write \"// true: meaning\"");
    if (*reading->a.c != ':')
        return refuse(reading,
                      "a bool has no range and no unit: write \"// %s: meaning\", or begin "
                      "the comment with another word",
                      yes ? "true" : "false");
    p->value[0] = yes ? 1.0 : 0.0;
    p->maximum = 1.0;
    p->step = 1.0;
    return true;
}

static bool read_values(struct reading *reading)
{
    struct parameter *p = &reading->parameter;
    int count = 0;
    do {
        double value;
        if (!read_number(reading, "the value", p->components == 1, &value))
            return false;
        if (count < 4)
            p->value[count] = value;
        count++;
    } while (annotation_accept(&reading->a, ','));
    if (count != 1 && count != p->components)
        return refuse(reading, "%d values for %d component%s: give %s", count, p->components,
                      p->components == 1 ? "" : "s",
                      p->components == 1 ? "one" : "one each, or one for all");
    for (int i = count; i < p->components; i++)
        p->value[i] = p->value[0];
    return true;
}

static bool read_range(struct reading *reading)
{
    struct parameter *p = &reading->parameter;
    if (!annotation_accept_word(&reading->a, "in") || !annotation_accept(&reading->a, '['))
        return refuse(reading, "no range after the value: write as in \"" EXAMPLE
                               "\", or begin the comment with another word");
    if (!read_number(reading, "the minimum", false, &p->minimum))
        return false;
    if (!annotation_accept(&reading->a, ','))
        return refuse(reading, "the range needs a comma: write [minimum, maximum]");
    if (!read_number(reading, "the maximum", true, &p->maximum))
        return false;
    if (!annotation_accept(&reading->a, ']'))
        return refuse(reading, "the range is not closed: write [minimum, maximum]");
    if (p->minimum >= p->maximum)
        return refuse(reading, "the range is empty: the minimum must be below the maximum");
    for (int i = 0; i < p->components; i++)
        if (p->value[i] < p->minimum || p->value[i] > p->maximum)
            return refuse(reading, "the value lies outside its range");
    return true;
}

static bool read_step(struct reading *reading)
{
    struct parameter *p = &reading->parameter;
    p->step = p->type == PARAMETER_INT ? 1.0 : (p->maximum - p->minimum) / 100.0;
    if (!annotation_accept_word(&reading->a, "step"))
        return true;
    p->multiplies = annotation_accept(&reading->a, '*');
    if (p->multiplies ? !read_any_number(reading, "the factor", true, &p->step)
                      : !read_number(reading, "the step", true, &p->step))
        return false;
    if (p->multiplies && (p->step <= 1.0 || p->minimum <= 0.0))
        return refuse(reading, "a step that multiplies must be above 1, in a range above 0");
    return p->step > 0.0 || refuse(reading, "the step must be above 0");
}

static bool read_words(struct reading *reading)
{
    struct parameter *p = &reading->parameter;
    if (annotation_accept(&reading->a, ',') &&
        !annotation_copy(&reading->a, "unit", p->unit, sizeof p->unit, strcspn(reading->a.c, ":")))
        return false;
    if (*reading->a.c != '\0' && *reading->a.c != ':')
        return refuse(reading, "'%.20s' is not understood: write as in \"" EXAMPLE "\"",
                      reading->a.c);
    annotation_accept(&reading->a, ':');
    return annotation_copy(&reading->a, "meaning", p->meaning, sizeof p->meaning,
                           strlen(reading->a.c));
}

// ---- The declaration ----

static bool read_type(struct reading *reading, const char *type)
{
    static const struct {
        const char *name;
        enum parameter_type type;
        int components;
    } types[] = {{"float", PARAMETER_FLOAT, 1}, {"vec2", PARAMETER_FLOAT, 2},
                 {"vec3", PARAMETER_FLOAT, 3},  {"vec4", PARAMETER_FLOAT, 4},
                 {"int", PARAMETER_INT, 1},     {"bool", PARAMETER_BOOL, 1}};
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        if (strcmp(type, types[i].name) == 0) {
            reading->parameter.type = types[i].type;
            reading->parameter.components = types[i].components;
            return true;
        }
    return refuse(reading, "a %s cannot be a parameter: use float, vec2, vec3, vec4, int or bool",
                  type);
}

static bool read_declaration(struct reading *reading, const struct glsl_token *uniform)
{
    char type[ANNOTATION_NAME];
    if (!annotation_declaration(&reading->a, uniform))
        return false;
    snprintf(type, sizeof type, "%.*s", GLSL_TEXT(&reading->a.source->code, reading->a.type));
    memcpy(reading->parameter.name, reading->a.name, sizeof reading->a.name);
    return read_type(reading, type);
}

static bool read_annotation(struct reading *reading)
{
    struct parameter *p = &reading->parameter;
    bool number = p->type != PARAMETER_BOOL;
    if (number ? !read_values(reading) || !read_range(reading) || !read_step(reading)
               : !read_bool_value(reading))
        return false;
    memcpy(p->initial, p->value, sizeof p->initial);
    return read_words(reading);
}

// ---- The text ----

static bool add(struct parameters *parameters, const struct reading *reading)
{
    if (parameters_find(parameters, reading->parameter.name) != NULL)
        return refuse(reading, "is declared twice: take one declaration out");
    parameters->item = memory_row(parameters->item, parameters->count, sizeof *parameters->item);
    parameters->item[parameters->count++] = reading->parameter;
    return true;
}

// Read the parameter that a uniform declares, unless its comment begins otherwise.
static bool read_uniform(struct parameters *parameters, const struct shader_source *source,
                         const struct glsl_token *uniform)
{
    struct reading reading = {.parameter.type = PARAMETER_FLOAT};
    annotation_begin(&reading.a, source, uniform);
    reading.a.what = "parameter";
    reading.a.example = EXAMPLE;
    bool done =
        !begins_with_value(reading.a.c) || (read_declaration(&reading, uniform) &&
                                            read_annotation(&reading) && add(parameters, &reading));
    free(reading.a.words);
    return done;
}

bool parameters_read(struct parameters *parameters, struct shader_source *source)
{
    const struct glsl *code = &source->code;
    bool course = source->form == SHADER_COURSE, done = true;
    int line = -1; // of the last word
    *parameters = (struct parameters){0};
    for (const struct glsl_token *t = code->item; course && done && t->kind != GLSL_END; t++) {
        if (t->line > line && glsl_is(code, t, "uniform"))
            done = read_uniform(parameters, source, t);
        line = t->kind < GLSL_COMMENT ? t->line : line;
    }
    done = done && samplers_read(&parameters->samplers, source);
    if (!done)
        parameters_free(parameters);
    return done;
}
