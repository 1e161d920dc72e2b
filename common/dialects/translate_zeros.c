#include "dialects/translate.h"

#include <stdlib.h>
#include <string.h>

#include "memory.h"

#define SIZE_LIMIT (256 * 1024) // bytes; once more are inserted, arrays and structures get no zeros

enum { VALUE_SIZE = 4096 }; // bytes of a value, including the final '\0'

struct zeros {
    const struct glsl *code;
    struct edits *edits;
    char **structure; // for each name: the zero of the structure with that name; may be NULL
};

static bool is_plain(const struct glsl_token *t)
{
    return t->kind == GLSL_WORD && !t->macro;
}

// The value of an array's size: a number, a macro for one, or a constant that is declared with one,
// as in "const int COUNT = 3;". Returns 0 for any other size.
static long size_of(const struct glsl *code, const struct glsl_token *t)
{
    if (t->kind == GLSL_WORD && t->macro)
        return code->name[t->name].word != NULL ? strtol(code->name[t->name].word, NULL, 10) : 0;
    const struct glsl_token *first = t->kind == GLSL_WORD ? glsl_find_next(code, NULL, t->text) : t;
    bool constant = t->kind == GLSL_WORD && glsl_is(first - 1, "int") && first[1].sign == '=' &&
                    glsl_is(first - 2, "const") && glsl_is_sign(first + 3, ",;");
    first += constant ? 2 : 0;
    return first->kind == GLSL_NUMBER ? strtol(first->text, NULL, 10) : 0;
}

// Write the zero of a type: "float(0)", or the zero of a structure, or, for an array,
// "float[2](float(0),float(0))". Returns false if the type has none.
//   size  the token after the name, which may be a bracket
static bool zero_of(const struct zeros *all, const struct glsl_token *type,
                    const struct glsl_token *size, char text[VALUE_SIZE])
{
    char one[VALUE_SIZE], base;
    if (!type->macro && glsl_type(type->text, &base) > 0)
        snprintf(one, sizeof one, "%s(0)", type->text);
    else if (is_plain(type) && all->structure[type->name] != NULL && all->edits->size < SIZE_LIMIT)
        snprintf(one, sizeof one, "%s", all->structure[type->name]);
    else
        return false;
    if (size->sign != '[') {
        strcpy(text, one);
        return true;
    }
    bool plain = size[2].sign == ']' && size[3].sign != '[';
    long count = plain ? size_of(all->code, size + 1) : 0;
    if (count < 1 || count > 255 || all->edits->size > SIZE_LIMIT ||
        count * (long)(strlen(one) + 1) + type->length > VALUE_SIZE / 2)
        return false;
    int used = snprintf(text, VALUE_SIZE, "%s[%ld](", type->text, count);
    for (long i = 0; i < count; i++)
        used += snprintf(text + used, (size_t)(VALUE_SIZE - used), "%s%c", one,
                         i + 1 < count ? ',' : ')');
    return true;
}

// Find the zero of a structure. A structure has a zero only if the declarations of its members
// consist of types, names and sizes, with no directive among them.
static void learn(struct zeros *all, const struct glsl_token *name)
{
    const struct glsl *code = all->code;
    const struct glsl_token *end = glsl_partner(code, name + 1), *type = NULL;
    char member[VALUE_SIZE], value[VALUE_SIZE];
    int used = snprintf(value, sizeof value, "%s", name->text);
    bool done = used < 256 && name->certain && end > name + 2 && !end->parted &&
                all->structure[name->name] == NULL;
    for (const struct glsl_token *t = name + 2, *after; done && t < end; t = after + 1) {
        while (type == NULL && glsl_is_precision(t))
            t++;
        type = type != NULL ? type : t++;
        after = t[1].sign == '[' ? glsl_next(code, t + 1) : t + 1;
        done = is_plain(t) && !type->parted && !t->parted && !after->parted &&
               glsl_is_sign(after, ",;") && zero_of(all, type, t + 1, member) &&
               (size_t)used + strlen(member) < VALUE_SIZE - 2;
        used += done ? snprintf(value + used, sizeof value - (size_t)used, "%c%s",
                                t > name + 4 ? ',' : '(', member)
                     : 0;
        type = after->sign == ',' ? type : NULL;
    }
    free(all->structure[name->name]); // if two structures have the same name, neither gets a zero
    all->structure[name->name] = done ? memory_text("%s)", value) : NULL;
}

static void zero_variable(const struct zeros *all, const struct declared *at)
{
    char text[VALUE_SIZE];
    if (at->value == NULL && glsl_is_sign(at->end, ",;") && is_plain(at->name) &&
        !at->end->parted && !at->name[1].parted && at->type[1].sign != '[' &&
        zero_of(all, at->type, at->name + 1, text))
        edits_add(all->edits, at->end[-1].begin + at->end[-1].length, 0, "=%s", text);
}

// Set the out parameters of a function to 0 at its beginning, and return 0 at its end if a path may
// reach the end of a function that returns a value elsewhere.
//   brace  the { of the function's body
static void zero_function(const struct zeros *all, const struct glsl_token *brace)
{
    const struct glsl *code = all->code;
    const struct glsl_token *end = glsl_partner(code, brace), *list = glsl_partner(code, brace - 1),
                            *last = brace + 1;
    char text[VALUE_SIZE];
    bool returns = false;
    for (const struct glsl_token *t = list; t < brace; t++) {
        const struct glsl_token *type = t + 1 + (glsl_is(t, "out") && glsl_is_precision(t + 1));
        if (glsl_is(t, "out") && is_plain(type + 1) && glsl_is_sign(type + 2, ",)[") &&
            zero_of(all, type, type + 2, text))
            edits_add(all->edits, brace->begin + 1, 0, "%s=%s;", type[1].text, text);
    }
    for (const struct glsl_token *t = brace + 1; t < end; t++) {
        returns |= glsl_is(t, "return");
        bool ends = t->depth == brace->depth + 1 && glsl_is_sign(t, ";}");
        last = ends && t + 1 < end ? t + 1 : last;
    }
    if (returns && (end->parted || !glsl_is(last, "return")) && end->kind != GLSL_END &&
        is_plain(list - 1) && zero_of(all, list - 2, list, text))
        edits_add(all->edits, end->begin, 0, "return %s;", text);
}

void translate_zeros(const struct glsl *code, struct edits *edits, FILE *begin)
{
    struct zeros all = {code, edits, memory_zeros((size_t)code->name_count, sizeof(char *))};
    const struct glsl_token *main = glsl_find_definition(code, "main");
    for (const struct glsl_token *t = code->statement; t->kind != GLSL_END; t++)
        if (glsl_is(t, "struct") && is_plain(t + 1) && t[2].sign == '{')
            learn(&all, t + 1);
        else if (t->sign == '{' && t->depth == 0 && t[-1].sign == ')')
            zero_function(&all, t);
    struct declared at = {.code = code};
    char text[VALUE_SIZE];
    while (declared_next(&at))
        if (at.kind == DECLARED_VARIABLE)
            zero_variable(&all, &at);
        else if (at.kind == DECLARED_OUT && main != NULL && at.name < main && at.name->certain &&
                 is_plain(at.name) && glsl_is_sign(at.name + 1, ",;") &&
                 zero_of(&all, at.type, at.name + 1, text))
            fprintf(begin, "%s=%s;", at.word, text);
    for (int i = 0; i < code->name_count; i++)
        free(all.structure[i]);
    free(all.structure);
}
