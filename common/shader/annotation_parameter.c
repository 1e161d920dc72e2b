#include "shader/annotation.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "number.h"

#define EXAMPLE "uniform float NAME; // 1 in [0, 10] step 0.5, unit: meaning"

// ---- Numbers ----

// Read a number that a float can represent.
//   single  a comma with a digit after it is a decimal comma, and is refused
static bool read_any_number(struct annotation *a, const char *what, bool single, double *value)
{
    a->c += strspn(a->c, BLANKS);
    size_t length = number_begin(a->c, value);
    if (length == 0)
        return annotation_refuse(a, "%s must be a number, not '%.20s'", what, a->c);
    const char *comma = a->c + length;
    if (single && comma[0] == ',' && comma[1] >= '0' && comma[1] <= '9')
        return annotation_refuse(a, "%s has a comma: write %.*s.%.*s", what, (int)length, a->c,
                                 (int)strspn(comma + 1, "0123456789"), comma + 1);
    a->c += length;
    if (!isfinite((float)*value))
        return annotation_refuse(a, "%s is too large for a float", what);
    return true;
}

// Read a number that the parameter's type can represent.
static bool read_number(struct annotation *a, const char *what, bool single, double *value)
{
    if (!read_any_number(a, what, single, value))
        return false;
    if (a->parameter.type == PARAMETER_INT && (*value != floor(*value) || fabs(*value) > INT_MAX))
        return annotation_refuse(a, "%s must be a whole number, because the uniform is an int",
                                 what);
    return true;
}

// ---- The parts of a comment ----

// True for a comment that declares a parameter, according to the rule in parameter.h.
static bool begins_with_value(const char *comment)
{
    double ignored;
    const char *c = comment + strspn(comment, BLANKS);
    size_t length = number_begin(c + (*c == '('), &ignored);
    if (*c == '(') // "(0.6, 0.1)" begins with a value, but "(2) is" does not
        return length > 0 && c[1 + length] == ',';
    if (strncmp(c, "true", 4) == 0)
        length = 4;
    else if (strncmp(c, "false", 5) == 0)
        length = 5;
    return length > 0 && strchr(BLANKS ",:", c[length]) != NULL; // strchr finds '\0' too
}

static bool read_bool_value(struct annotation *a)
{
    struct parameter *p = &a->parameter;
    bool yes = annotation_accept_word(a, "true");
    if (!yes && !annotation_accept_word(a, "false"))
        return annotation_refuse(
            a, "the value of a bool is true or false: write \"// true: meaning\"");
    if (*a->c != ':')
        return annotation_refuse(
            a,
            "a bool has no range and no unit: write \"// %s: meaning\", or begin "
            "the comment with another word",
            yes ? "true" : "false");
    p->value[0] = yes ? 1.0 : 0.0;
    p->minimum = 0.0;
    p->maximum = 1.0;
    p->step = 1.0;
    return true;
}

static bool read_values(struct annotation *a)
{
    struct parameter *p = &a->parameter;
    int count = 0;
    bool closed = !annotation_accept(a, '(');
    do {
        double value;
        if (!read_number(a, "the value", p->components == 1, &value))
            return false;
        if (count < 4)
            p->value[count] = value;
        count++;
    } while (annotation_accept(a, ','));
    if (!closed && !annotation_accept(a, ')'))
        return annotation_refuse(a, "the values need a closing parenthesis: write (x, y)");
    if (count != 1 && count != p->components)
        return annotation_refuse(a, "%d values for %d component%s: give %s", count, p->components,
                                 p->components == 1 ? "" : "s",
                                 p->components == 1 ? "one" : "one each, or one for all");
    for (int i = count; i < p->components; i++)
        p->value[i] = p->value[0];
    return true;
}

static bool read_range(struct annotation *a)
{
    struct parameter *p = &a->parameter;
    return ((annotation_accept_word(a, "in") && annotation_accept(a, '[')) ||
            annotation_refuse(a, "no range after the value: write it as in \"" EXAMPLE
                                 "\", or begin the comment with another word")) &&
           read_number(a, "the minimum", false, &p->minimum) &&
           (annotation_accept(a, ',') ||
            annotation_refuse(a, "the range needs a comma: write [minimum, maximum]")) &&
           read_number(a, "the maximum", true, &p->maximum) &&
           (annotation_accept(a, ']') ||
            annotation_refuse(a, "the range is not closed: write [minimum, maximum]")) &&
           (p->minimum < p->maximum ||
            annotation_refuse(a, "the range is empty: the minimum must be below the maximum"));
}

static bool read_step(struct annotation *a)
{
    struct parameter *p = &a->parameter;
    for (int i = 0; i < p->components; i++)
        if (p->value[i] < p->minimum || p->value[i] > p->maximum)
            return annotation_refuse(a, "the value lies outside its range");
    p->step = p->type == PARAMETER_INT ? 1.0 : (p->maximum - p->minimum) / 100.0;
    if (!annotation_accept_word(a, "step"))
        return true;
    p->multiplies = annotation_accept(a, '*');
    if (p->multiplies ? !read_any_number(a, "the factor", true, &p->step)
                      : !read_number(a, "the step", true, &p->step))
        return false;
    if (p->multiplies && (p->step <= 1.0 || p->minimum <= 0.0))
        return annotation_refuse(a,
                                 "a step that multiplies must be above 1, and its range above 0");
    return p->step > 0.0 || annotation_refuse(a, "the step must be above 0");
}

// If the word "handle" comes next, read it and the plane that may follow it.
static bool read_handle(struct annotation *a)
{
    struct parameter *p = &a->parameter;
    if (!annotation_accept_word(a, "handle"))
        return true;
    if (p->components != 2 && p->components != 3)
        return annotation_refuse(a, "only a vec2 or a vec3 can be a handle");
    bool xz = annotation_accept_word(a, "xz");
    bool xy = !xz && annotation_accept_word(a, "xy");
    p->handle = xz ? HANDLE_XZ : xy || p->components == 2 ? HANDLE_XY : HANDLE_SCREEN;
    return true;
}

static bool read_words(struct annotation *a)
{
    struct parameter *p = &a->parameter;
    bool unit = p->handle != HANDLE_NONE || annotation_accept(a, ',');
    if (unit && !read_handle(a))
        return false;
    if (unit && (p->handle == HANDLE_NONE || *a->c != ':') &&
        !annotation_copy(a, "unit", p->unit, sizeof p->unit, strcspn(a->c, ":")))
        return false;
    if (*a->c != '\0' && *a->c != ':')
        return annotation_refuse(a, "'%.20s' is not understood: write it as in \"" EXAMPLE "\"",
                                 a->c);
    annotation_accept(a, ':');
    if (a->quiet && *a->c == '\0') {
        snprintf(p->meaning, sizeof p->meaning, "%s", p->name);
        return true;
    }
    return annotation_copy(a, "meaning", p->meaning, sizeof p->meaning, strlen(a->c));
}

// ---- Parameters ----

static bool read_type(struct annotation *a)
{
    struct parameter *p = &a->parameter;
    char base = '\0';
    p->components = glsl_type(a->type->text, &base);
    p->type = base == 'b' ? PARAMETER_BOOL : base == 'i' ? PARAMETER_INT : PARAMETER_FLOAT;
    return base == 'f' || (p->type != PARAMETER_FLOAT && p->components == 1) ||
           annotation_refuse(a,
                             "a %s cannot be a parameter: use float, vec2, vec3, vec4, int or bool",
                             a->type->text);
}

// Read everything that a number has, from its value to its step. A handle needs no range.
static bool read_number_value(struct annotation *a)
{
    return read_values(a) && read_handle(a) &&
           (a->parameter.handle != HANDLE_NONE || read_range(a)) && read_step(a);
}

static bool read_parameter(struct annotation *a)
{
    struct parameter *p = &a->parameter;
    if (!annotation_declaration(a) || !read_type(a))
        return false;
    memcpy(p->name, a->name, sizeof p->name);
    if (p->type == PARAMETER_BOOL ? !read_bool_value(a) : !read_number_value(a))
        return false;
    memcpy(p->initial, p->value, sizeof p->initial);
    return read_words(a);
}

// Read the parameter that a uniform declares, if any. Returns false if the parameter is malformed.
//   found  receives whether the uniform's comment declares a parameter
static bool read_uniform(struct annotation *a, const struct shader_source *source,
                         const struct glsl_token *uniform, bool *found)
{
    annotation_begin(a, source, uniform, "parameter", EXAMPLE);
    a->parameter.minimum = -10.0; // the default range of a handle
    a->parameter.maximum = 10.0;
    *found = begins_with_value(a->c);
    bool done = !*found || read_parameter(a);
    free(a->words);
    return done;
}

bool parameter_declared(const struct shader_source *source, const struct glsl_token *name)
{
    const struct glsl_token *t = &source->code.item[name->item];
    struct annotation a;
    bool found = false;
    while (t > source->code.item && t->line == name->line && !glsl_is(t, "uniform"))
        t--;
    return t->line == name->line && glsl_is(t, "uniform") && read_uniform(&a, source, t, &found) &&
           found;
}

static bool add_parameter(struct parameters *parameters, const struct annotation *a)
{
    if (parameters_find(parameters, a->name) != NULL)
        return a->quiet || // the first declaration counts
               annotation_refuse(a, "is declared twice: remove one declaration");
    parameters->item = memory_row(parameters->item, parameters->count, sizeof *parameters->item);
    parameters->item[parameters->count++] = a->parameter;
    return true;
}

bool parameters_read(struct parameters *parameters, struct shader_source *source)
{
    const struct glsl *code = &source->code;
    bool course = source->dialect == DIALECT_COURSE;
    int line = -1; // line of the last token that is not a comment
    *parameters = (struct parameters){0};
    bool done = samplers_read(&parameters->samplers, source);
    for (const struct glsl_token *t = code->item; done && t->kind != GLSL_END; t++) {
        struct annotation a;
        bool uniform = glsl_is(t, "uniform"), found;
        // In another dialect, only the shader's own file can have parameters, not the files that it
        // includes.
        if (uniform && t->line > line && (course || (t->live && source->lines[t->line].file == 0)))
            done = read_uniform(&a, source, t, &found) ? !found || add_parameter(parameters, &a)
                                                       : !course;
        line = t->kind < GLSL_COMMENT ? t->line : line;
    }
    if (!done)
        parameters_free(parameters);
    return done;
}
