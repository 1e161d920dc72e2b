#include "dialects/translate.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"

struct floats {
    const struct glsl *code;
    struct edits edits;
    bool *whole; // for each name: true for an int, an int vector, or a function that returns either
    bool *takes; // for each name: true for a function that takes an int or an int vector
};

// True for a type whose base, as glsl_type returns it, is among the given letters.
static bool is_type(const struct glsl_token *t, const char *bases)
{
    char base;
    return !t->macro && glsl_type(t->text, &base) > 0 && strchr(bases, base) != NULL;
}

// Find out which names are integers, and which functions take integers.
static void learn(struct floats *f)
{
    static const char *const functions[] = {"texelFetch", "textureSize", "layout", NULL};
    const struct glsl *code = f->code;
    const struct glsl_token *function = NULL; // last function before t; its parameters may follow
    for (const struct glsl_token *t = code->statement; t->kind != GLSL_END; t++) {
        if (t->depth == 0 && t->kind == GLSL_WORD && t[1].sign == '(')
            function = t;
        if (glsl_is_any(t, functions))
            f->takes[t->name] = true;
        if (!is_type(t, "iu"))
            continue;
        f->whole[t->name] = true;
        if (t->depth == 1 && function != NULL && t < glsl_next(code, function + 1))
            f->takes[function->name] = true;
        const struct glsl_token *name = t[1].sign == '[' ? glsl_next(code, t + 1) : t + 1;
        while (name->kind == GLSL_WORD && !is_type(name, "fmiu")) {
            f->whole[name->name] = true;
            const struct glsl_token *end = glsl_skip(code, name + 1, ",;)}");
            name = end->sign == ',' ? end + 1 : end;
        }
    }
}

// Add a decimal point to each integer from one token up to another, outside the brackets between
// them.
static void add_points(struct floats *f, const struct glsl_token *from, const struct glsl_token *to)
{
    for (const struct glsl_token *t = from; t < to; t = glsl_next(f->code, t)) {
        if (t->kind == GLSL_NUMBER && strspn(t->text, "0123456789") == (size_t)t->length)
            edits_add(&f->edits, t->begin + t->length, 0, ".");
    }
}

// True for a statement that declares, sets or returns an integer, and for a case label.
static bool is_whole_statement(const struct floats *f, const struct glsl_token *t, bool returns)
{
    bool whole = glsl_is(t, "case") || (returns && glsl_is(t, "return"));
    for (; !whole && t->kind != GLSL_END && !glsl_is_sign(t, "=;{}("); t = glsl_next(f->code, t))
        whole = t->kind == GLSL_WORD && f->whole[t->name];
    return whole;
}

// Convert the text between two tokens. Returns true if a part of it has an integer type.
//   whole    all of the text has an integer type
//   splits   a comma separates expressions
//   states   the text consists of statements
//   returns  the function around the text returns an integer
static bool convert(struct floats *f, const struct glsl_token *from, const struct glsl_token *to,
                    bool whole, bool splits, bool states, bool returns)
{
    static const char *const same[] = {"min", "max", "abs", "sign", "clamp", NULL};
    static const char *const heads[] = {"for", "if", "while", NULL};
    const struct glsl *code = f->code;
    const struct glsl_token *begin = from;
    bool any = false, group = whole,
         statement = whole || (states && is_whole_statement(f, from, returns));
    for (const struct glsl_token *t = from; t < to; t = glsl_next(code, t)) {
        bool pair = glsl_is_sign(t, "&|") && t[1].sign == t->sign;
        bool ends = glsl_is_sign(t, ";{}");
        if (t->kind == GLSL_WORD)
            group |= f->whole[t->name];
        if (glsl_is_sign(t, "([{")) {
            const struct glsl_token *word = t - 1, *close = glsl_partner(code, t);
            bool call = t->sign == '(' && word->kind == GLSL_WORD;
            bool own = call && glsl_is_any(word, heads);
            bool type = call && is_type(word, "fm");
            bool hands =
                t->depth == 0 && t->sign == '{' ? is_whole_statement(f, begin, false) : returns;
            bool loop = call && glsl_is(word, "for");
            bool inner = convert(f, t + 1, close < to ? close : to,
                                 t->sign == '[' || (call && f->takes[word->name]),
                                 t->sign == '{' || own || type, t->sign == '{' || loop, hands);
            group |= inner && t->sign == '(' && (!call || glsl_is_any(word, same));
        }
        if (ends || pair || glsl_is_sign(t, "?:") || (splits && t->sign == ',')) {
            if (!group && !statement)
                add_points(f, begin, t);
            any |= group;
            begin = glsl_next(code, t);
            group = whole;
            if (ends)
                statement = whole || (states && is_whole_statement(f, begin, returns));
        }
    }
    if (!group && !statement)
        add_points(f, begin, to);
    return any || group;
}

char *translate_floats(const char *text)
{
    struct glsl code;
    glsl_read(&code, text);
    struct floats f = {.code = &code,
                       .whole = memory_zeros((size_t)code.name_count, sizeof *f.whole),
                       .takes = memory_zeros((size_t)code.name_count, sizeof *f.takes)};
    learn(&f);
    convert(&f, code.statement, code.statement + code.statement_count, false, true, true, false);
    char *result = edits_apply(&f.edits, text);
    free(f.whole);
    free(f.takes);
    glsl_free(&code);
    return result;
}
