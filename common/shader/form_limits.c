#include "shader/form_limits.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "report.h"

#define ARRAY_LIMIT  65536   // elements
#define GROWTH_LIMIT 1000000 // words that macros add
#define DEPTH_LIMIT  1000    // of macros in macros, and of brackets in sizes

enum { PARAMETERS = 8 }; // of a macro that are told apart

// How many words a macro becomes: some, and for each parameter as many as are handed in, so often.
struct cost {
    double words, times[PARAMETERS];
    bool takes; // parameters
};

// What is known of a name.
struct fact {
    double value;    // of a constant or a macro, where known
    double elements; // of a structure, all arrays counted
    int declared;    // how often it stands behind a type, or in a #define
    bool known, under_way;
    struct cost *cost; // of a macro; owned
};

struct limits {
    const struct shader_source *source;
    const struct glsl *code;
    struct fact *fact; // by name
    bool failed;       // for want of memory
};

// A walk over the tokens of an expression or a macro.
struct reader {
    struct limits *limits;
    const struct glsl_token *t;
    bool directive;                 // they stand in one
    const struct glsl_token *first; // of the macro's parameters, or NULL
    int parameters, depth;
};

static void skip_comments(struct reader *reader)
{
    while (reader->t->kind >= GLSL_COMMENT)
        reader->t++;
}

static bool ends(struct reader *reader)
{
    skip_comments(reader);
    return reader->t->kind == GLSL_END || reader->t->kind == GLSL_HASH ||
           reader->t->directive != reader->directive;
}

// The first token of a macro's definition behind its parameters; those go into reader.
static struct reader open_macro(struct limits *limits, int name, int depth)
{
    const struct glsl_token *t = &limits->code->item[limits->code->name[name].definition] + 2;
    struct reader reader = {.limits = limits, .t = t + 1, .directive = true, .depth = depth + 1};
    if (t[1].sign != '(' || t[1].begin != t->begin + t->length)
        return reader;
    reader.first = t + 2;
    for (reader.t++; !ends(&reader) && reader.t->sign != ')'; reader.t++)
        reader.parameters += reader.t->kind == GLSL_WORD;
    reader.t += reader.t->sign == ')';
    return reader;
}

// ---- Sizes of arrays ----

static bool read_sum(struct reader *reader, double *value);

// A number, a name, or an expression in brackets.
static bool read_operand(struct reader *reader, double *value)
{
    struct limits *limits = reader->limits;
    const struct glsl *code = limits->code;
    if (ends(reader) || ++reader->depth > DEPTH_LIMIT)
        return false;
    const struct glsl_token *t = reader->t++;
    struct fact *fact = t->kind == GLSL_WORD ? &limits->fact[t->name] : NULL;
    bool done = false;
    if (t->kind == GLSL_NUMBER) {
        *value = strtod(code->text + t->begin, NULL);
        done = true;
    } else if (t->sign == '-') {
        done = read_operand(reader, value);
        *value = -*value;
    } else if (t->sign == '(' || glsl_is(code, t, "int") || glsl_is(code, t, "uint")) {
        reader->t += t->sign != '(' && !ends(reader) && reader->t->sign == '(';
        done = read_sum(reader, value) && !ends(reader) && reader->t->sign == ')';
        reader->t += done;
    } else if (fact != NULL && fact->declared == 1 && !fact->under_way) {
        const struct glsl_name *name = &code->name[t->name];
        struct reader macro = {0};
        fact->under_way = true;
        if (!fact->known && name->definition >= 0 && name->defined == GLSL_ALWAYS) {
            macro = open_macro(limits, t->name, reader->depth);
            fact->known = macro.first == NULL && read_sum(&macro, &fact->value) && ends(&macro);
        }
        fact->under_way = false;
        done = fact->known;
        *value = fact->value;
    }
    reader->depth--;
    return done;
}

static bool read_product(struct reader *reader, double *value)
{
    double next;
    if (!read_operand(reader, value))
        return false;
    while (!ends(reader) && (reader->t->sign == '*' || reader->t->sign == '/')) {
        char sign = reader->t->sign;
        reader->t++;
        if (!read_operand(reader, &next) || (sign == '/' && next == 0.0))
            return false;
        *value = sign == '*' ? *value * next : trunc(*value / next);
    }
    return true;
}

static bool read_sum(struct reader *reader, double *value)
{
    double next;
    if (!read_product(reader, value))
        return false;
    while (!ends(reader) && (reader->t->sign == '+' || reader->t->sign == '-')) {
        char sign = reader->t->sign;
        reader->t++;
        if (!read_product(reader, &next))
            return false;
        *value += sign == '+' ? next : -next;
    }
    return true;
}

// The number of elements between two brackets; 1 where it cannot be told.
static double size_of(struct limits *limits, const struct glsl_token *bracket)
{
    struct reader reader = {.limits = limits, .t = bracket + 1};
    double value;
    return read_sum(&reader, &value) && reader.t == glsl_partner(limits->code, bracket) ? value
                                                                                        : 1.0;
}

// Note the constants that a declaration names: "const int N = 4, M = 2 * N;".
static void note_constants(struct limits *limits, const struct glsl_token *t)
{
    static const char *const types[] = {"int", "uint", NULL};
    for (t++; glsl_is_precision(limits->code, t);)
        t++;
    if (!glsl_is_any(limits->code, t, types))
        return;
    do {
        struct reader reader = {.limits = limits, .t = t + 3};
        if (t[1].kind != GLSL_WORD || t[2].sign != '=')
            return;
        struct fact *fact = &limits->fact[t[1].name];
        fact->known = read_sum(&reader, &fact->value);
        t = glsl_skip(limits->code, t + 3, ",;");
    } while (t->sign == ',');
}

static bool refuse_array(const struct limits *limits, const struct glsl_token *bracket, double size)
{
    const struct glsl_token *number = bracket + 1;
    char text[32];
    snprintf(text, sizeof text, "%.15g", size);
    if (number->kind == GLSL_NUMBER && number->length > 15)
        snprintf(text, sizeof text, "%.*s", number->length < 20 ? number->length : 20,
                 limits->code->text + number->begin);
    return shader_refuse(limits->source, bracket->line,
                         "an array of %s elements: a graphics processor has no room for it: %d at "
                         "most",
                         text, ARRAY_LIMIT);
}

static bool check_arrays(struct limits *limits)
{
    const struct glsl *code = limits->code;
    const struct glsl_token *structure = NULL; // the name of the one whose members are read
    double type = 1.0, size = 1.0;             // elements of the type, and of a name's arrays
    for (const struct glsl_token *t = code->statement; t->kind != GLSL_END; t++) {
        if (glsl_is(code, t, "const"))
            note_constants(limits, t);
        if (t->kind == GLSL_WORD && t[1].kind == GLSL_WORD) {
            type = limits->fact[t->name].elements > 0.0 ? limits->fact[t->name].elements : 1.0;
            if (glsl_is(code, t, "struct") && t[2].sign == '{')
                structure = t + 1;
        }
        if (t->sign == '[') {
            size *= size_of(limits, t);
            if (size * type > ARRAY_LIMIT)
                return refuse_array(limits, t, size * type);
            t = glsl_partner(code, t);
        } else if (t->kind != GLSL_WORD) {
            bool member = structure != NULL && (t->sign == ',' || t->sign == ';');
            if (member)
                limits->fact[structure->name].elements += size * type;
            size = 1.0;
            if (t->sign != ',')
                type = 1.0;
            if (t->sign == '}' && structure != NULL) {
                type = limits->fact[structure->name].elements;
                structure = NULL;
            }
        }
        if (t->kind == GLSL_END)
            break;
    }
    return true;
}

// ---- Macros ----

static struct cost cost_of(struct reader *reader, bool argument);

static void add(struct cost *to, double times, const struct cost *cost)
{
    to->words += times * cost->words;
    for (int i = 0; i < PARAMETERS; i++)
        to->times[i] += times * cost->times[i];
}

// What a macro becomes, computed once; NULL while that is under way.
static const struct cost *macro_cost(struct limits *limits, int name, int depth)
{
    struct fact *fact = &limits->fact[name];
    if (fact->cost != NULL || fact->under_way || depth > DEPTH_LIMIT)
        return fact->cost;
    struct reader reader = open_macro(limits, name, depth);
    fact->under_way = true;
    struct cost cost = cost_of(&reader, false);
    cost.takes = reader.first != NULL;
    fact->under_way = false;
    fact->cost = malloc(sizeof cost);
    limits->failed |= fact->cost == NULL;
    if (fact->cost != NULL)
        *fact->cost = cost;
    return fact->cost;
}

// Add what a word becomes, with what it takes in brackets.
static void add_word(struct reader *reader, struct cost *to)
{
    static const struct cost one = {.words = 1.0};
    struct limits *limits = reader->limits;
    const struct glsl_token *word = reader->t++;
    const struct glsl_token *parameter = reader->first;
    for (int i = 0; i < reader->parameters; i++, parameter++) {
        while (parameter->kind != GLSL_WORD)
            parameter++;
        if (parameter->name == word->name) {
            to->times[i < PARAMETERS ? i : PARAMETERS - 1] += 1.0;
            return;
        }
    }
    bool macro = limits->code->name[word->name].definition >= 0;
    const struct cost *cost = macro ? macro_cost(limits, word->name, reader->depth) : &one;
    to->words += cost != NULL ? cost->words : 1.0;
    if (cost == NULL || !cost->takes || ends(reader) || reader->t->sign != '(' ||
        reader->depth >= DEPTH_LIMIT)
        return;
    reader->depth++;
    int i = 0;
    do {
        reader->t++;
        struct cost argument = cost_of(reader, true);
        add(to, cost->times[i], &argument);
        i += i < PARAMETERS - 1;
    } while (!ends(reader) && reader->t->sign == ',');
    reader->t += !ends(reader);
    reader->depth--;
}

// What the tokens up to the end become, or up to the end of an argument.
static struct cost cost_of(struct reader *reader, bool argument)
{
    struct cost cost = {0};
    int open = 0;
    while (!ends(reader)) {
        char sign = reader->t->sign;
        if (argument && open == 0 && (sign == ',' || sign == ')'))
            break;
        open += (sign == '(') - (sign == ')');
        if (reader->t->kind == GLSL_WORD) {
            add_word(reader, &cost);
        } else {
            cost.words += 1.0;
            reader->t++;
        }
    }
    return cost;
}

static bool check_macros(struct limits *limits)
{
    const struct glsl *code = limits->code;
    double words = 0.0;
    for (int i = code->count - 1; i >= 0; i--) // what is defined last is mostly made of the others
        if (code->item[i].kind == GLSL_HASH && code->item[i].live &&
            glsl_is(code, &code->item[i + 1], "define") && code->item[i + 2].kind == GLSL_WORD)
            macro_cost(limits, code->item[i + 2].name, 0);
    // The row of everything, but definitions and what asks only whether there is one.
    static const char *const expanded[] = {"if", "elif", NULL};
    struct reader reader = {.limits = limits, .t = code->item};
    for (bool counts = true; reader.t->kind != GLSL_END && !limits->failed;) {
        const struct glsl_token *t = reader.t;
        struct cost cost = {0};
        if (t->kind == GLSL_HASH || !t->directive)
            counts = t->live && (!t->directive || glsl_is_any(code, t + 1, expanded));
        reader.directive = t->directive;
        if (counts && t->kind == GLSL_WORD && code->name[t->name].definition >= 0)
            add_word(&reader, &cost);
        else
            reader.t++;
        words += cost.words;
        if (words > GROWTH_LIMIT)
            return shader_refuse(limits->source, t->line,
                                 "with the macro %.*s the text grows by more than a million words: "
                                 "no driver has room for it",
                                 t->length < 64 ? t->length : 64, code->text + t->begin);
    }
    return true;
}

// Count how often each name is declared, and see whether there is anything but comments.
static bool note_names(struct limits *limits)
{
    static const char *const statements[] = {"return", "else", "case", NULL};
    const struct glsl *code = limits->code;
    bool any = false;
    for (const struct glsl_token *t = code->item; t->kind != GLSL_END; t++) {
        any |= t->live && t->kind < GLSL_COMMENT;
        if (t->kind == GLSL_HASH && t->live && glsl_is(code, t + 1, "define") &&
            t[2].kind == GLSL_WORD)
            limits->fact[t[2].name].declared++;
    }
    for (const struct glsl_token *t = code->statement; t->kind != GLSL_END; t++)
        if (t->kind == GLSL_WORD && t[-1].kind == GLSL_WORD &&
            !glsl_is_any(code, t - 1, statements))
            limits->fact[t->name].declared++;
    return any;
}

bool form_check_limits(const struct shader_source *source)
{
    const struct glsl *code = &source->code;
    struct limits limits = {source, code, calloc((size_t)code->name_count + 1, sizeof *limits.fact),
                            false};
    bool done = limits.fact != NULL && note_names(&limits);
    if (limits.fact != NULL && !done)
        report("%s: holds nothing but comments: a shader is code", source->files[0]);
    done = done && check_arrays(&limits) && check_macros(&limits);
    for (int i = 0; i < code->name_count && limits.fact != NULL; i++)
        free(limits.fact[i].cost);
    if (limits.fact == NULL || (done && limits.failed))
        report("%s: not enough memory", source->files[0]);
    free(limits.fact);
    return done && !limits.failed;
}
