#include "dialects/declared.h"

#include <stdio.h>
#include <string.h>

static enum declared_kind kind_of(const struct glsl *code, const struct glsl_token *t)
{
    return glsl_means(code, t, "in") || glsl_is(t, "varying")       ? DECLARED_IN
           : glsl_means(code, t, "out")                             ? DECLARED_OUT
           : glsl_means(code, t, "uniform") || glsl_is(t, "buffer") ? DECLARED_UNIFORM
                                                                    : DECLARED_VARIABLE;
}

// Store a name if a declaration of this kind can declare it. Returns false otherwise.
static bool take_name(struct declared *at, const struct glsl_token *name)
{
    const struct glsl_token *t = name + 1;
    while (t->sign == '[')
        t = glsl_next(at->code, t);
    if (name->kind != GLSL_WORD || (at->kind == DECLARED_VARIABLE && !glsl_is_sign(t, ",;=")))
        return false;
    at->name = name;
    at->value = t->sign == '=' && at->kind != DECLARED_BLOCK ? t : NULL;
    at->end = at->kind == DECLARED_BLOCK ? name + 1 : glsl_skip(at->code, t, ",;)}");
    at->word = name->text;
    return true;
}

// Read a declaration up to its first name. Returns false if there is no declaration.
static bool take_declaration(struct declared *at, const struct glsl_token *t)
{
    static const char *const qualifiers[] = {"flat",     "smooth",    "noperspective", "const",
                                             "centroid", "invariant", "coherent",      "volatile",
                                             "restrict", "readonly",  "writeonly",     NULL},
                             *const others[] = {"return", "else", "do", "struct", NULL};
    const struct glsl *code = at->code;
    at->begin = t;
    at->layout = NULL;
    at->kind = DECLARED_VARIABLE;
    at->storage = NULL;
    for (;; t++)
        if (glsl_is(t, "layout") && t[1].sign == '(') {
            at->layout = t;
            t = glsl_partner(code, t + 1);
        } else if (at->kind == DECLARED_VARIABLE && kind_of(code, t) != DECLARED_VARIABLE) {
            at->kind = kind_of(code, t);
        } else if (!glsl_is_any(t, qualifiers) && !glsl_is_precision(t)) {
            break;
        }
    bool structure = glsl_is(t, "struct") && at->kind == DECLARED_VARIABLE &&
                     t[1].kind == GLSL_WORD && t[2].sign == '{';
    if ((at->kind != DECLARED_VARIABLE && at->begin->depth > 0) || t->kind != GLSL_WORD ||
        (!structure && glsl_is_any(t, others)))
        return false;
    at->type = t + structure;
    t = structure ? glsl_next(code, t + 2) : t + 1;
    if (at->kind != DECLARED_VARIABLE && t->sign == '{')
        at->kind = DECLARED_BLOCK;
    at->first = at->kind == DECLARED_BLOCK ? at->type : t->sign == '[' ? glsl_next(code, t) : t;
    return take_name(at, at->first);
}

// True for braces around members, even if a macro hides the word struct or the block's qualifier.
static bool holds_members(const struct glsl *code, const struct glsl_token *brace)
{
    const struct glsl_token *end = glsl_next(code, brace);
    return (brace[-1].kind == GLSL_WORD && brace[-2].kind == GLSL_WORD) ||
           (brace->depth == 0 && glsl_is_sign(end + (end->kind == GLSL_WORD), ";,[="));
}

bool declared_next(struct declared *at)
{
    const struct glsl *code = at->code;
    const struct glsl_token *t = at->end;
    if (at->kind != DECLARED_NONE && t->sign == ',' && take_name(at, t + 1))
        return true;
    for (t = t != NULL ? t : code->statement - 1;
         t == code->statement - 1 || t->kind != GLSL_END;) {
        bool loop = t->sign == '(' && glsl_is(t - 1, "for");
        bool begins = t < code->statement || loop || glsl_is_sign(t, ";{}");
        t = t->sign == '{' && holds_members(code, t) ? glsl_next(code, t) - 1 : t;
        if (begins && take_declaration(at, t + 1))
            return true;
        t++;
    }
    at->kind = DECLARED_NONE;
    at->end = t;
    return false;
}

bool declared_is_first(const struct declared *at)
{
    const struct glsl *code = at->code;
    const struct glsl_token *end = at->layout != NULL ? glsl_partner(code, at->layout + 1) : NULL;
    for (const struct glsl_token *t = at->layout; end != NULL && t < end; t++)
        if (glsl_is(t, "location"))
            return t[1].sign == '=' && glsl_is(t + 2, "0");
    return false;
}

bool declared_is_array(const struct declared *at)
{
    return at->type[1].sign == '[' || at->name[1].sign == '[';
}

static bool is_mentioned(const struct glsl *code, const struct glsl_token *name)
{
    return code->name[name->name].count > 1;
}

bool declared_is_read(const struct declared *at)
{
    const struct glsl_token *t = at->end, *end = at->name + 1;
    if (at->kind == DECLARED_BLOCK)
        end = glsl_partner(at->code, t);
    if (end->sign != '}')
        return is_mentioned(at->code, at->name);
    if (end[1].kind == GLSL_WORD)
        return is_mentioned(at->code, end + 1);
    for (; t < end; t++)
        if (t->kind == GLSL_WORD && t[1].kind != GLSL_WORD && is_mentioned(at->code, t))
            return true;
    return false;
}

void declared_store(struct declared *at, struct edits *edits, const char *storage)
{
    static const char *const words[] = {[DECLARED_IN] = "in",
                                        [DECLARED_OUT] = "out",
                                        [DECLARED_UNIFORM] = "uniform",
                                        [DECLARED_BLOCK] = "uniform"};
    const struct glsl_token *last = at->type - 1, *size = at->type + 1;
    if (at->name == at->first) {
        bool same = at->begin == last && glsl_is(last, words[at->kind]) && glsl_is(last, storage);
        if (!same)
            edits_add(edits, at->begin->begin, last->begin + last->length - at->begin->begin, "%s",
                      storage);
    } else if (at->storage == NULL || strcmp(at->storage, storage) != 0) {
        int length = size->sign == '[' && size[2].sign == ']' ? size[2].begin + 1 - size->begin : 0;
        edits_add(edits, at->name[-1].begin, 1, "; %s %s%.*s ", storage, at->type->text, length,
                  at->code->text + size->begin);
    }
    at->storage = storage;
}

bool declared_anywhere(const struct glsl *code, const char *word)
{
    const struct glsl_token *t = NULL;
    while ((t = glsl_find_next(code, t, word)) != NULL)
        if (t->depth == 0 && (t[-1].kind == GLSL_WORD || glsl_is_sign(t - 1, "],}")))
            return true;
    bool uniform = false; // a macro may contain the whole declaration
    for (t = code->item; t->kind != GLSL_END; t++) {
        uniform =
            t->live && t->directive && t->kind != GLSL_HASH && (uniform || glsl_is(t, "uniform"));
        if (uniform && glsl_is(t, word))
            return true;
    }
    return false;
}

// ---- Outputs ----

struct outputs declared_outputs(const struct glsl *code, bool uncertain)
{
    struct declared at = {.code = code};
    struct outputs outputs = {0};
    while (declared_next(&at)) {
        if (at.kind != DECLARED_OUT || !(at.name->certain || uncertain))
            continue;
        bool zero = declared_is_first(&at), first = zero || outputs.count == 0;
        if (outputs.count++ > 0 && (first || outputs.count == 2))
            outputs.second = first ? outputs.shown : at;
        if (first)
            outputs.shown = at;
        outputs.placed |= zero;
    }
    return outputs;
}

struct declared declared_output(const struct glsl *code)
{
    struct outputs outputs = declared_outputs(code, false);
    return outputs.count > 0 ? outputs.shown : declared_outputs(code, true).shown;
}
