#include "shader/parameter.h"

#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "number.h"
#include "report.h"

#define BLANKS    " \t\v\f\r"
#define EXAMPLE   "uniform float NAME; // 1 in [0, 10] step 0.5, unit: meaning"
#define EXAMPLE2  "uniform sampler2D NAME; // \"stone.png\" sRGB repeat: meaning"
#define EXAMPLE3  "uniform sampler3D NAME; // \"noise.png\" linear repeat 64: meaning"
#define NAME_SIZE 64 // of a name or a type

// A uniform and the comment behind it, on one line.
struct annotation {
    const char *what, *example; // for messages: "parameter", and how one is written
    const struct shader_source *source;
    bool quiet;                                        // nothing is reported
    int line;                                          // of the text, from 0
    const struct glsl_token *uniform, *type, *comment; // comment: or NULL
    char name[NAME_SIZE];
    char *words;   // of the comment, owned; "" for none
    const char *c; // the rest of them
    struct parameter parameter;
    struct sampler sampler;
};

static bool refuse(const struct annotation *a, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

// Report a malformed annotation; always false.
static bool refuse(const struct annotation *a, const char *format, ...)
{
    char why[512];
    va_list arguments;
    if (a->quiet)
        return false;
    va_start(arguments, format);
    vsnprintf(why, sizeof why, format, arguments);
    va_end(arguments);
    return shader_refuse(a->source, a->line, "%s %s: %s", a->what, a->name, why);
}

static void skip_blanks(struct annotation *a)
{
    a->c += strspn(a->c, BLANKS);
}

// Skip a character, or a whole word, and the blanks around it, if it is next.
static bool accept(struct annotation *a, char c)
{
    skip_blanks(a);
    if (*a->c != c)
        return false;
    a->c++;
    skip_blanks(a);
    return true;
}

static bool accept_word(struct annotation *a, const char *word)
{
    size_t length = strlen(word);
    skip_blanks(a);
    if (strncmp(a->c, word, length) != 0 || glsl_is_word(a->c[length]))
        return false;
    a->c += length;
    skip_blanks(a);
    return true;
}

// Copy the next bytes of the comment without the blanks around them. Returns false, reported: none,
// or too many.
//   part  what they are
static bool copy(struct annotation *a, const char *part, char *to, size_t size, size_t length)
{
    const char *from = a->c + strspn(a->c, BLANKS);
    const char *end = a->c + length;
    while (end > from && strchr(BLANKS, end[-1]) != NULL)
        end--;
    if (end <= from)
        return refuse(a, "no %s: write as in \"%s\"", part, a->example);
    if ((size_t)(end - from) >= size)
        return refuse(a, "the %s is too long: %d bytes at most", part, (int)size - 1);
    memcpy(to, from, (size_t)(end - from));
    to[end - from] = '\0';
    a->c += length;
    return true;
}

// Read "uniform TYPE NAME;", alone in front of its comment. Returns false, reported.
static bool read_declaration(struct annotation *a)
{
    const struct glsl *code = &a->source->code;
    const struct glsl_token *word[4] = {0}; // type, name, semicolon, and one too many
    const struct glsl_token *uniform = a->uniform, *t = uniform + 1;
    int count = 0;
    for (; t != a->comment && t->kind != GLSL_END && t->line == uniform->line && count < 4; t++) {
        if (t->kind < GLSL_COMMENT && !(count == 0 && glsl_is_precision(code, t)))
            word[count++] = t;
        else
            continue;
        while (a->quiet && count == 2 && t[1].sign != ';' && t[1].line == uniform->line &&
               t[1].kind != GLSL_END && t + 1 != a->comment)
            t++; // a default value
    }
    bool good = count > 1 && word[0]->sign == '\0' && word[1]->sign == '\0' &&
                word[0]->length < NAME_SIZE && word[1]->length < NAME_SIZE;
    if (!good)
        return !a->quiet &&
               shader_refuse(a->source, a->line,
                             "not a %s's declaration: write as in \"%s\", with a name of at most "
                             "%d letters",
                             a->what, a->example, NAME_SIZE - 1);
    a->type = word[0];
    snprintf(a->name, sizeof a->name, "%.*s", GLSL_TEXT(code, word[1]));
    return (count == 3 && word[2]->sign == ';') ||
           refuse(a,
                  "must be declared alone on its line, with nothing between its name "
                  "and the semicolon: write as in \"%s\"",
                  a->example);
}

// The first line of a comment, without what begins it. The caller frees it.
static char *words_of(const struct glsl *code, const struct glsl_token *comment)
{
    static const char *const spaces[] = {"\xC2\xA0", "\xE2\x80\xAF"};
    const char *begin = code->text + comment->begin + 2;
    char *words = memory_text("%.*s", (int)strcspn(begin, "\n"), begin);
    bool quoted = false; // a file's name stays as it is
    for (char *c = words; *c != '\0'; c++) {
        quoted ^= *c == '"';
        for (int i = 0; i < 2 && !quoted; i++)
            if (strncmp(c, spaces[i], strlen(spaces[i])) == 0)
                memset(c, ' ', strlen(spaces[i]));
        bool wide = *c == '\xC2' && (unsigned char)c[1] >= 0x80 && (unsigned char)c[1] < 0xA0;
        if (wide || ((unsigned char)*c < ' ' && strchr(BLANKS, *c) == NULL) || *c == 0x7F)
            memset(c, '?', wide ? 2 : 1);
    }
    return words;
}

// Find the comment in the line of a uniform. A no-break space, which a French keyboard types, is a
// blank, but not in quotes; a control character becomes a question mark. Free words.
static void begin(struct annotation *a, const struct shader_source *source,
                  const struct glsl_token *uniform, const char *what, const char *example)
{
    const struct glsl_token *t = uniform;
    while (t->kind != GLSL_END && t->kind != GLSL_COMMENT && t->line == uniform->line)
        t++;
    bool found = t->kind == GLSL_COMMENT && t->line == uniform->line;
    *a = (struct annotation){.what = what,
                             .example = example,
                             .source = source,
                             // An author elsewhere may mean something else.
                             .quiet = source->dialect != DIALECT_COURSE,
                             .line = uniform->line,
                             .uniform = uniform,
                             .comment = found ? t : NULL,
                             .words = found ? words_of(&source->code, t) : memory_text("%s", "")};
    a->c = a->words;
}

//   single  no comma may follow but one that begins a word
static bool read_any_number(struct annotation *a, const char *what, bool single, double *value)
{
    a->c += strspn(a->c, BLANKS);
    size_t length = number_begin(a->c, value);
    if (length == 0)
        return refuse(a, "%s must be a number, not '%.20s'", what, a->c);
    const char *comma = a->c + length;
    if (single && comma[0] == ',' && comma[1] >= '0' && comma[1] <= '9')
        return refuse(a, "%s has a comma: write %.*s.%.*s", what, (int)length, a->c,
                      (int)strspn(comma + 1, "0123456789"), comma + 1);
    a->c += length;
    if (!isfinite((float)*value))
        return refuse(a, "%s is too large for a float", what);
    return true;
}

// Read a number that the parameter's type can hold.
static bool read_number(struct annotation *a, const char *what, bool single, double *value)
{
    if (!read_any_number(a, what, single, value))
        return false;
    if (a->parameter.type == PARAMETER_INT && (*value != floor(*value) || fabs(*value) > INT_MAX))
        return refuse(a, "%s must be a whole number, because the uniform is an int", what);
    return true;
}

// ---- The parts of a comment ----

// True for a comment that declares a parameter, by the rule of parameter.h.
static bool begins_with_value(const char *comment)
{
    double ignored;
    const char *c = comment + strspn(comment, BLANKS);
    size_t length = number_begin(c + (*c == '('), &ignored);
    if (*c == '(') // "(0.6, 0.1)" is a value, "(2) is" is not
        return length > 0 && c[1 + length] == ',';
    if (strncmp(c, "true", 4) == 0)
        length = 4;
    else if (strncmp(c, "false", 5) == 0)
        length = 5;
    return length > 0 && strchr(BLANKS ",:", c[length]) != NULL; // the text's end included
}

static bool read_bool_value(struct annotation *a)
{
    struct parameter *p = &a->parameter;
    bool yes = accept_word(a, "true");
    if (!yes && !accept_word(a, "false"))
        return refuse(a, "the value of a bool is true or false: write \"// true: meaning\"");
    if (*a->c != ':')
        return refuse(a,
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
    bool closed = !accept(a, '(');
    do {
        double value;
        if (!read_number(a, "the value", p->components == 1, &value))
            return false;
        if (count < 4)
            p->value[count] = value;
        count++;
    } while (accept(a, ','));
    if (!closed && !accept(a, ')'))
        return refuse(a, "the values are not closed: write (x, y)");
    if (count != 1 && count != p->components)
        return refuse(a, "%d values for %d component%s: give %s", count, p->components,
                      p->components == 1 ? "" : "s",
                      p->components == 1 ? "one" : "one each, or one for all");
    for (int i = count; i < p->components; i++)
        p->value[i] = p->value[0];
    return true;
}

static bool read_range(struct annotation *a)
{
    struct parameter *p = &a->parameter;
    return ((accept_word(a, "in") && accept(a, '[')) ||
            refuse(a, "no range after the value: write as in \"" EXAMPLE
                      "\", or begin the comment with another word")) &&
           read_number(a, "the minimum", false, &p->minimum) &&
           (accept(a, ',') || refuse(a, "the range needs a comma: write [minimum, maximum]")) &&
           read_number(a, "the maximum", true, &p->maximum) &&
           (accept(a, ']') || refuse(a, "the range is not closed: write [minimum, maximum]")) &&
           (p->minimum < p->maximum ||
            refuse(a, "the range is empty: the minimum must be below the maximum"));
}

static bool read_step(struct annotation *a)
{
    struct parameter *p = &a->parameter;
    for (int i = 0; i < p->components; i++)
        if (p->value[i] < p->minimum || p->value[i] > p->maximum)
            return refuse(a, "the value lies outside its range");
    p->step = p->type == PARAMETER_INT ? 1.0 : (p->maximum - p->minimum) / 100.0;
    if (!accept_word(a, "step"))
        return true;
    p->multiplies = accept(a, '*');
    if (p->multiplies ? !read_any_number(a, "the factor", true, &p->step)
                      : !read_number(a, "the step", true, &p->step))
        return false;
    if (p->multiplies && (p->step <= 1.0 || p->minimum <= 0.0))
        return refuse(a, "a step that multiplies must be above 1, in a range above 0");
    return p->step > 0.0 || refuse(a, "the step must be above 0");
}

// Read the word "handle" and its plane, if they are next.
static bool read_handle(struct annotation *a)
{
    struct parameter *p = &a->parameter;
    if (!accept_word(a, "handle"))
        return true;
    if (p->components != 2 && p->components != 3)
        return refuse(a, "only a vec2 or a vec3 can be a handle");
    bool xz = accept_word(a, "xz");
    bool xy = !xz && accept_word(a, "xy");
    p->handle = xz ? HANDLE_XZ : xy || p->components == 2 ? HANDLE_XY : HANDLE_SCREEN;
    return true;
}

static bool read_words(struct annotation *a)
{
    struct parameter *p = &a->parameter;
    bool unit = p->handle != HANDLE_NONE || accept(a, ',');
    if (unit && !read_handle(a))
        return false;
    if (unit && (p->handle == HANDLE_NONE || *a->c != ':') &&
        !copy(a, "unit", p->unit, sizeof p->unit, strcspn(a->c, ":")))
        return false;
    if (*a->c != '\0' && *a->c != ':')
        return refuse(a, "'%.20s' is not understood: write as in \"" EXAMPLE "\"", a->c);
    accept(a, ':');
    if (a->quiet && *a->c == '\0') {
        snprintf(p->meaning, sizeof p->meaning, "%s", p->name);
        return true;
    }
    return copy(a, "meaning", p->meaning, sizeof p->meaning, strlen(a->c));
}

// ---- Parameters ----

static bool read_type(struct annotation *a)
{
    static const struct {
        const char *name;
        enum parameter_type type;
        int components;
    } types[] = {{"float", PARAMETER_FLOAT, 1}, {"vec2", PARAMETER_FLOAT, 2},
                 {"vec3", PARAMETER_FLOAT, 3},  {"vec4", PARAMETER_FLOAT, 4},
                 {"int", PARAMETER_INT, 1},     {"bool", PARAMETER_BOOL, 1}};
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        if (glsl_is(&a->source->code, a->type, types[i].name)) {
            a->parameter.type = types[i].type;
            a->parameter.components = types[i].components;
            return true;
        }
    return refuse(a, "a %.*s cannot be a parameter: use float, vec2, vec3, vec4, int or bool",
                  GLSL_TEXT(&a->source->code, a->type));
}

static bool read_parameter(struct annotation *a)
{
    struct parameter *p = &a->parameter;
    if (!read_declaration(a) || !read_type(a))
        return false;
    memcpy(p->name, a->name, sizeof p->name);
    bool number = p->type != PARAMETER_BOOL;
    if (number ? !read_values(a) || !read_handle(a) ||
                     !(p->handle != HANDLE_NONE || read_range(a)) || !read_step(a)
               : !read_bool_value(a))
        return false;
    memcpy(p->initial, p->value, sizeof p->initial);
    return read_words(a);
}

// Read the parameter that a uniform declares. Returns false for a malformed one.
//   found  receives whether its comment declares one
static bool read_uniform(struct annotation *a, const struct shader_source *source,
                         const struct glsl_token *uniform, bool *found)
{
    begin(a, source, uniform, "parameter", EXAMPLE);
    a->parameter.minimum = -10.0; // of a handle without a range
    a->parameter.maximum = 10.0;
    *found = begins_with_value(a->c);
    bool done = !*found || read_parameter(a);
    free(a->words);
    return done;
}

bool parameter_declared(const struct shader_source *source, const struct glsl_token *name)
{
    const struct glsl *code = &source->code;
    int low = 0, high = code->count;
    while (low < high) { // find the name among all tokens
        int middle = (low + high) / 2;
        if (code->item[middle].begin < name->begin)
            low = middle + 1;
        else
            high = middle;
    }
    while (low > 0 && code->item[low].line == name->line &&
           !glsl_is(code, &code->item[low], "uniform"))
        low--;
    struct annotation a;
    bool found = false;
    return glsl_is(code, &code->item[low], "uniform") && code->item[low].line == name->line &&
           read_uniform(&a, source, &code->item[low], &found) && found;
}

static bool add_parameter(struct parameters *parameters, const struct annotation *a)
{
    if (parameters_find(parameters, a->name) != NULL)
        return a->quiet || // the first one counts
               refuse(a, "is declared twice: remove one declaration");
    parameters->item = memory_row(parameters->item, parameters->count, sizeof *parameters->item);
    parameters->item[parameters->count++] = a->parameter;
    return true;
}

// ---- Samplers ----

// Read one of two words.
//   what  what the first and the second one are for
static bool read_choice(struct annotation *a, const char *first, const char *second,
                        const char *what, bool *is_first)
{
    *is_first = accept_word(a, first);
    if (*is_first || accept_word(a, second))
        return true;
    size_t length = strcspn(a->c, BLANKS ":");
    return length == 0 ? refuse(a, "%s or %s is missing: %s", first, second, what)
                       : refuse(a, "'%.*s' is not understood: write %s or %s: %s",
                                (int)(length < 20 ? length : 20), a->c, first, second, what);
}

static bool read_slices(struct annotation *a, struct sampler *sampler, bool volume)
{
    double value = 0.0;
    size_t length = number_begin(a->c, &value);
    a->c += length;
    if (!volume)
        return length == 0 || refuse(a, "a sampler2D has no slices: a volume is a "
                                        "sampler3D");
    if (length == 0)
        return refuse(a, "a volume needs the number of its slices: write as in \"%s\"", a->example);
    if (!(value >= 1.0 && value <= SAMPLER_SLICES && value == (double)(int)value))
        return refuse(a, "the number of slices must be a whole number from 1 to %d",
                      SAMPLER_SLICES);
    sampler->slices = (int)value;
    return true;
}

static bool read_picture(struct annotation *a, bool volume, char file[256])
{
    struct sampler *sampler = &a->sampler;
    if (!accept(a, '"'))
        return refuse(a, "no picture is named: write as in \"%s\"", a->example);
    size_t length = strcspn(a->c, "\"");
    if (a->c[length] == '\0')
        return refuse(a, "the file's name is not closed: write as in \"%s\"", a->example);
    return copy(a, "file", file, 256, length) && accept(a, '"') &&
           read_choice(a, "sRGB", "linear", "a colour is sRGB, a number linear", &sampler->srgb) &&
           read_choice(a, "repeat", "clamp", "a picture repeats, or its edge continues",
                       &sampler->repeat) &&
           read_slices(a, sampler, volume) &&
           (accept(a, ':') || *a->c == '\0' ||
            refuse(a, "'%.20s' is not understood: write as in \"%s\"", a->c, a->example)) &&
           copy(a, "meaning", sampler->meaning, sizeof sampler->meaning, strlen(a->c));
}

// The FILE of the last --texture NAME=FILE with this name, or NULL.
static const char *other_file(const struct shader_source *source, const char *name)
{
    const struct shader_request *request = &source->request;
    size_t length = strlen(name);
    for (int i = request->texture_count - 1; i >= 0; i--)
        if (strncmp(request->textures[i], name, length) == 0 && request->textures[i][length] == '=')
            return request->textures[i] + length + 1;
    return NULL;
}

static bool find_file(struct annotation *a, struct shader_source *source, const char *file)
{
    char why[TEXT_FILE_WHY];
    const char *other = other_file(source, a->name);
    a->sampler.file = other != NULL
                          ? shader_take_texture(source, other, why)
                          : shader_find_texture(source, source->lines[a->line].file, file, why);
    return a->sampler.file >= 0 || refuse(a, "%s: %s", other != NULL ? other : file, why);
}

static bool add_sampler(struct samplers *samplers, const struct sampler *sampler)
{
    samplers->item = memory_row(samplers->item, samplers->count, sizeof *samplers->item);
    samplers->item[samplers->count++] = *sampler;
    return true;
}

// The type of a uniform if it is a sampler of any kind, or NULL.
static const struct glsl_token *sampler_type(const struct glsl *code,
                                             const struct glsl_token *uniform)
{
    const struct glsl_token *t = uniform + 1;
    while (t->kind >= GLSL_COMMENT || glsl_is_precision(code, t))
        t++;
    char type[NAME_SIZE] = "";
    if (t->kind == GLSL_WORD && t->length < NAME_SIZE)
        snprintf(type, sizeof type, "%.*s", GLSL_TEXT(code, t));
    return strstr(type, "sampler") != NULL ? t : NULL;
}

static bool read_sampler(struct samplers *samplers, struct shader_source *source,
                         const struct glsl_token *uniform, const struct glsl_token *type)
{
    // Tables of the slice, of the coarse pass and of letters, which the harness fills in.
    static const char *const own[] = {"iMarch", "iCoarse", "iSigns", NULL};
    const struct glsl *code = &source->code;
    bool volume = glsl_is(code, type, "sampler3D"), twice = false;
    struct annotation a;
    char file[256];
    if (glsl_is_any(code, type + 1, own))
        return true;
    begin(&a, source, uniform, "sampler", volume ? EXAMPLE3 : EXAMPLE2);
    a.sampler.line = a.line;
    bool done = read_declaration(&a) &&
                (volume || glsl_is(code, type, "sampler2D") ||
                 refuse(&a,
                        "the type %.*s cannot be filled in: use sampler2D, or sampler3D for a "
                        "volume",
                        GLSL_TEXT(code, type))) &&
                read_picture(&a, volume, file);
    memcpy(a.sampler.name, a.name, sizeof a.name);
    for (int i = 0; i < samplers->count; i++)
        twice |= strcmp(samplers->item[i].name, a.name) == 0;
    done = done && (!twice || refuse(&a, "is declared twice: remove one declaration")) &&
           find_file(&a, source, file) && add_sampler(samplers, &a.sampler);
    free(a.words);
    return done;
}

// Add the pictures of --channel, and those that the text names. As in Shadertoy, a picture repeats
// unless the text says otherwise.
static bool add_channels(struct samplers *samplers, struct shader_source *source)
{
    const char *const *channels = source->request.channels;
    char why[TEXT_FILE_WHY];
    for (int i = 0; i < 4; i++) {
        bool given = channels != NULL && channels[i] != NULL;
        if (!given && source->channel[i] <= 0)
            continue;
        struct sampler sampler = {.line = -1, .repeat = true};
        snprintf(sampler.name, sizeof sampler.name, "iChannel%d", i);
        sampler.file = given ? shader_take_texture(source, channels[i], why) : source->channel[i];
        if (sampler.file < 0)
            return report("--channel %d=%s: %s", i, channels[i], why);
        add_sampler(samplers, &sampler);
    }
    return true;
}

// Refuse a type that declares a sampler in a structure or a macro, which no picture can fill in. A
// parameter of a function is another's sampler.
static bool check_hidden(const struct shader_source *source, const struct glsl_token *type)
{
    static const char *const types[] = {"sampler2D", "sampler3D", NULL};
    static const char *const parameter[] = {"in", "const", "precision", NULL};
    const struct glsl *code = &source->code;
    const struct glsl_token *t = type - 1;
    if (!type->live || !glsl_is_any(code, type, types))
        return true;
    while (t >= code->item && (t->kind >= GLSL_COMMENT || glsl_is_precision(code, t)))
        t--;
    return (t >= code->item && (glsl_is_sign(t, "(,") || glsl_is_any(code, t, parameter) ||
                                (!type->directive && glsl_is(code, t, "uniform")))) ||
           shader_refuse(source, type->line,
                         "a %.*s must be a uniform of its own, in no structure or macro: write as "
                         "in \"%s\"",
                         GLSL_TEXT(code, type),
                         glsl_is(code, type, "sampler3D") ? EXAMPLE3 : EXAMPLE2);
}

// ---- The text ----

bool parameters_read(struct parameters *parameters, struct shader_source *source)
{
    const struct glsl *code = &source->code;
    bool course = source->dialect == DIALECT_COURSE;
    int line = -1; // of the last word
    *parameters = (struct parameters){0};
    bool done = course || add_channels(&parameters->samplers, source);
    for (const struct glsl_token *t = code->item; done && t->kind != GLSL_END; t++) {
        struct annotation a;
        bool uniform = glsl_is(code, t, "uniform"), found;
        // In another tool's file, the library of the course keeps its parameters.
        if (uniform && t->line > line && (course || (t->live && source->lines[t->line].file == 0)))
            done = read_uniform(&a, source, t, &found) ? !found || add_parameter(parameters, &a)
                                                       : !course;
        const struct glsl_token *type =
            course && uniform && t->live && !t->directive ? sampler_type(code, t) : NULL;
        done = done && (type == NULL || read_sampler(&parameters->samplers, source, t, type)) &&
               (!course || check_hidden(source, t));
        line = t->kind < GLSL_COMMENT ? t->line : line;
    }
    if (!done)
        parameters_free(parameters);
    return done;
}
