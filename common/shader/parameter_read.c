#include "shader/parameter.h"

#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "shader/glsl.h"
#include "memory.h"
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
    return report("%s:%d: parameter %s: %s", reading->file, reading->line, reading->parameter.name,
                  why);
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

//   single  no comma may follow but one that begins a word
static bool read_any_number(struct reading *reading, const char *what, bool single, double *value)
{
    skip_blanks(reading);
    size_t length = number_begin(reading->c, value);
    if (length == 0)
        return refuse(reading, "%s must be a number, not '%.20s'", what, reading->c);
    const char *comma = reading->c + length;
    if (single && comma[0] == ',' && comma[1] >= '0' && comma[1] <= '9')
        return refuse(reading, "%s has a comma: write %.*s.%.*s", what, (int)length, reading->c,
                      (int)strspn(comma + 1, "0123456789"), comma + 1);
    reading->c += length;
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
        if (!read_number(reading, "the value", p->components == 1, &value))
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
    if (!read_number(reading, "the minimum", false, &p->minimum))
        return false;
    if (!accept(reading, ','))
        return refuse(reading, "the range needs a comma: write [minimum, maximum]");
    if (!read_number(reading, "the maximum", true, &p->maximum))
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
    if (p->multiplies ? !read_any_number(reading, "the factor", true, &p->step)
                      : !read_number(reading, "the step", true, &p->step))
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

// Read "uniform TYPE NAME;" up to the comment, or the end of the line.
static bool read_declaration(struct reading *reading, const struct glsl *code,
                             const struct glsl_token *uniform, const struct glsl_token *comment)
{
    const struct glsl_token *word[4] = {0}; // type, name, semicolon, and what is too much
    int count = 0;
    for (const struct glsl_token *t = uniform + 1; t < comment && count < 4; t++)
        if (t->kind < GLSL_COMMENT && !(count == 0 && glsl_is_precision(code, t)))
            word[count++] = t;
    bool good = count > 1 && word[0]->sign == '\0' && word[1]->sign == '\0' &&
                word[0]->length < (int)sizeof reading->parameter.name &&
                word[1]->length < (int)sizeof reading->parameter.name;
    if (!good)
        return report("%s:%d: not a parameter's declaration: write as in \"" EXAMPLE
                      "\", with a name of at most %d letters",
                      reading->file, reading->line, (int)sizeof reading->parameter.name - 1);
    char type[sizeof reading->parameter.name];
    snprintf(type, sizeof type, "%.*s", GLSL_TEXT(code, word[0]));
    snprintf(reading->parameter.name, sizeof type, "%.*s", GLSL_TEXT(code, word[1]));
    if (count != 3 || word[2]->sign != ';')
        return refuse(reading, "must be declared alone on its line, with nothing between its name "
                               "and the semicolon: write as in \"" EXAMPLE "\"");
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

// What a comment says, on its first line: a space that cannot break is a blank, as a French
// keyboard types it, and a control character a question mark. The caller frees it.
static char *words_of(const struct glsl *code, const struct glsl_token *comment)
{
    static const char *const spaces[] = {"\xC2\xA0", "\xE2\x80\xAF"};
    const char *begin = code->text + comment->begin + 2;
    char *words = memory_text("%.*s", (int)strcspn(begin, "\n"), begin);
    for (int i = 0; i < 2; i++)
        for (char *c = words; (c = strstr(c, spaces[i])) != NULL;)
            memset(c, ' ', strlen(spaces[i]));
    for (char *c = words; *c != '\0'; c++) {
        bool wide = *c == '\xC2' && (unsigned char)c[1] >= 0x80 && (unsigned char)c[1] < 0xA0;
        if (wide || ((unsigned char)*c < ' ' && strchr(BLANKS, *c) == NULL) || *c == 0x7F)
            memset(c, '?', wide ? 2 : 1);
    }
    return words;
}

// Read the parameter that a uniform declares, unless its comment begins otherwise.
static bool read_uniform(struct parameters *parameters, const struct shader_source *source,
                         const struct glsl_token *uniform)
{
    const struct glsl *code = &source->code;
    const struct shader_line *from = &source->lines[uniform->line];
    const struct glsl_token *comment = uniform;
    while (comment->kind != GLSL_END && comment->kind != GLSL_COMMENT &&
           comment->line == uniform->line)
        comment++;
    if (comment->kind != GLSL_COMMENT || comment->line != uniform->line)
        return true;
    struct reading reading = {.file = source->files[from->file], .line = from->line};
    char *words = words_of(code, comment);
    reading.c = words;
    bool done =
        !begins_with_value(words) || (read_declaration(&reading, code, uniform, comment) &&
                                      read_annotation(&reading) && add(parameters, &reading));
    free(words);
    return done;
}

bool parameters_read(struct parameters *parameters, const struct shader_source *source)
{
    const struct glsl *code = &source->code;
    int line = -1; // of the last word
    *parameters = (struct parameters){0};
    for (const struct glsl_token *t = code->item;
         source->form == SHADER_COURSE && t->kind != GLSL_END; t++) {
        if (t->line > line && glsl_is(code, t, "uniform") && !read_uniform(parameters, source, t)) {
            parameters_free(parameters);
            return false;
        }
        line = t->kind < GLSL_COMMENT ? t->line : line;
    }
    return true;
}
