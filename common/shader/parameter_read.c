#include "shader/parameter.h"

#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "shader/glsl.h"
#include "number.h"
#include "report.h"

#define BLANKS  " \t\v\f\r"
#define EXAMPLE "uniform float NAME; // 1 in [0, 10] step 0.5, unit: meaning"

// One annotated uniform being read.
struct reading {
    const char *file;
    int line;
    const char *c; // what is left of the comment
    struct parameter parameter;
};

// Report a malformed annotation; always false.
__attribute__((format(printf, 2, 3))) static bool refuse(const struct reading *reading,
                                                         const char *format, ...)
{
    char why[512];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(why, sizeof why, format, arguments);
    va_end(arguments);
    report("%s:%d: parameter %s: %s", reading->file, reading->line, reading->parameter.name, why);
    return false;
}

static void skip_blanks(struct reading *reading)
{
    reading->c += strspn(reading->c, BLANKS);
}

// Pass over a character and the blanks around it, if it is next.
static bool accept(struct reading *reading, char c)
{
    skip_blanks(reading);
    if (*reading->c != c)
        return false;
    reading->c++;
    skip_blanks(reading);
    return true;
}

// Pass over a whole word and the blanks around it, if it is next.
static bool accept_word(struct reading *reading, const char *word)
{
    size_t length = strlen(word);
    skip_blanks(reading);
    if (strncmp(reading->c, word, length) != 0 || glsl_is_word(reading->c[length]))
        return false;
    reading->c += length;
    skip_blanks(reading);
    return true;
}

static bool read_any_number(struct reading *reading, const char *what, double *value)
{
    skip_blanks(reading);
    size_t length = number_begin(reading->c, value);
    if (length == 0)
        return refuse(reading, "%s must be a number, not '%.20s'", what, reading->c);
    reading->c += length;
    if (!isfinite((float)*value))
        return refuse(reading, "%s is too large for a float", what);
    return true;
}

// Read a number that the parameter's type can hold.
static bool read_number(struct reading *reading, const char *what, double *value)
{
    if (!read_any_number(reading, what, value))
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
    bool yes = accept_word(reading, "true");
    if (!yes && !accept_word(reading, "false"))
        return refuse(reading, "the value of a bool is true or false: write \"// true: meaning\"");
    if (*reading->c != ':')
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
        if (!read_number(reading, "the value", &value))
            return false;
        if (count < 4)
            p->value[count] = value;
        count++;
    } while (accept(reading, ','));
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
    if (!accept_word(reading, "in") || !accept(reading, '['))
        return refuse(reading, "no range after the value: write as in \"" EXAMPLE
                               "\", or begin the comment with another word");
    if (!read_number(reading, "the minimum", &p->minimum))
        return false;
    if (!accept(reading, ','))
        return refuse(reading, "the range needs a comma: write [minimum, maximum]");
    if (!read_number(reading, "the maximum", &p->maximum))
        return false;
    if (!accept(reading, ']'))
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
    if (!accept_word(reading, "step"))
        return true;
    p->multiplies = accept(reading, '*');
    if (p->multiplies ? !read_any_number(reading, "the factor", &p->step)
                      : !read_number(reading, "the step", &p->step))
        return false;
    if (p->multiplies && (p->step <= 1.0 || p->minimum <= 0.0))
        return refuse(reading, "a step that multiplies must be above 1, in a range above 0");
    return p->step > 0.0 || refuse(reading, "the step must be above 0");
}

// Copy a part of the comment without the blanks around it.
static bool copy(struct reading *reading, const char *what, char *to, size_t size, size_t length)
{
    const char *from = reading->c + strspn(reading->c, BLANKS);
    const char *end = reading->c + length;
    while (end > from && strchr(BLANKS, end[-1]) != NULL)
        end--;
    if (end <= from)
        return refuse(reading, "no %s: write as in \"" EXAMPLE "\"", what);
    if ((size_t)(end - from) >= size)
        return refuse(reading, "the %s is too long: %d bytes at most", what, (int)size - 1);
    memcpy(to, from, (size_t)(end - from));
    to[end - from] = '\0';
    reading->c += length;
    return true;
}

static bool read_words(struct reading *reading)
{
    struct parameter *p = &reading->parameter;
    if (accept(reading, ',') &&
        !copy(reading, "unit", p->unit, sizeof p->unit, strcspn(reading->c, ":")))
        return false;
    skip_blanks(reading);
    if (*reading->c != '\0' && *reading->c != ':')
        return refuse(reading, "'%.20s' is not understood: write as in \"" EXAMPLE "\"",
                      reading->c);
    accept(reading, ':');
    return copy(reading, "meaning", p->meaning, sizeof p->meaning, strlen(reading->c));
}

// ---- The declaration ----

// Read one word; false when there is none or it does not fit.
static bool take_word(const char **c, char *word, size_t size)
{
    size_t length = 0;
    *c += strspn(*c, BLANKS);
    while (glsl_is_word((*c)[length]))
        length++;
    if (length == 0 || length >= size)
        return false;
    memcpy(word, *c, length);
    word[length] = '\0';
    *c += length;
    return true;
}

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

// Read "uniform TYPE NAME;", the line without comments.
static bool read_declaration(struct reading *reading, const char *code)
{
    char type[sizeof reading->parameter.name] = "", *name = reading->parameter.name;
    bool good = take_word(&code, type, sizeof type) && // uniform
                take_word(&code, type, sizeof type);
    if (good &&
        (strcmp(type, "highp") == 0 || strcmp(type, "mediump") == 0 || strcmp(type, "lowp") == 0))
        good = take_word(&code, type, sizeof type);
    if (!good || !take_word(&code, name, sizeof reading->parameter.name)) {
        report("%s:%d: not a parameter's declaration: write as in \"" EXAMPLE
               "\", with a name of at most %d letters",
               reading->file, reading->line, (int)sizeof reading->parameter.name - 1);
        return false;
    }
    code += strspn(code, BLANKS);
    if (*code != ';' || code[1 + strspn(code + 1, BLANKS)] != '\0')
        return refuse(reading, "must be declared alone on its line, with nothing between its name "
                               "and the semicolon: write as in \"" EXAMPLE "\"");
    return read_type(reading, type);
}

static bool read_parameter(struct reading *reading, const char *code, const char *comment)
{
    struct parameter *p = &reading->parameter;
    reading->c = comment;
    if (!read_declaration(reading, code))
        return false;
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
    size_t count = (size_t)parameters->count + 1;
    struct parameter *item = realloc(parameters->item, count * sizeof *item);
    if (item == NULL)
        return refuse(reading, "not enough memory");
    parameters->item = item;
    parameters->item[parameters->count++] = reading->parameter;
    return true;
}

// Read the parameters of a text.
//   code   the text without comments
//   notes  the text without block comments; both are cut into lines here
static bool read_lines(struct parameters *parameters, const struct shader_source *source,
                       char *code, char *notes)
{
    for (int i = 0; i < source->line_count; i++) {
        size_t length = strcspn(code, "\n");
        code[length] = notes[length] = '\0';
        const char *word = code + strspn(code, BLANKS);
        const char *comment = strstr(notes, "//");
        if (strncmp(word, "uniform", 7) == 0 && !glsl_is_word(word[7]) && comment != NULL &&
            begins_with_value(comment + 2)) {
            struct reading reading = {.file = source->files[source->lines[i].file],
                                      .line = source->lines[i].line};
            if (!read_parameter(&reading, code, comment + 2) || !add(parameters, &reading))
                return false;
        }
        code += length + 1;
        notes += length + 1;
    }
    return true;
}

bool parameters_read(struct parameters *parameters, const struct shader_source *source)
{
    *parameters = (struct parameters){0};
    if (source->form != SHADER_COURSE)
        return true;
    char *code = strdup(source->text), *notes = strdup(source->text);
    bool done = code != NULL && notes != NULL;
    if (done) {
        glsl_blank_comments(code, false);
        glsl_blank_comments(notes, true);
        done = read_lines(parameters, source, code, notes);
    } else
        report("%s: not enough memory", source->files[0]);
    free(code);
    free(notes);
    if (!done)
        parameters_free(parameters);
    return done;
}
