#include "shader/glsl.h"

#include <string.h>

const struct glsl_token *glsl_find(const struct glsl *code, const char *word)
{
    const struct glsl_token *token = code->item;
    while (token->kind != GLSL_END && !(token->live && glsl_is(token, word)))
        token++;
    return token->kind != GLSL_END ? token : NULL;
}

const struct glsl_token *glsl_find_next(const struct glsl *code, const struct glsl_token *after,
                                        const char *word)
{
    const struct glsl_name *name = glsl_name(code, word);
    int from = after != NULL ? (int)(after - code->statement) + 1 : 0;
    for (int i = from; name != NULL && i <= name->last; i++)
        if (code->statement[i].kind == GLSL_WORD && &code->name[code->statement[i].name] == name)
            return &code->statement[i];
    return NULL;
}

const struct glsl_token *glsl_find_definition(const struct glsl *code, const char *word)
{
    const struct glsl_token *at = NULL;
    do
        at = glsl_find_next(code, at, word);
    while (at != NULL && (at->macro || at[1].sign != '(' || glsl_next(code, at + 1)->sign != '{'));
    return at;
}

// A word before the name is usually a type, in which case the mention is a declaration, but an
// expression may follow one of the words in statements.
const struct glsl_token *glsl_find_call(const struct glsl *code, const char *word)
{
    static const char *const statements[] = {"return", "else", "do", NULL};
    const struct glsl_token *at = NULL;
    do
        at = glsl_find_next(code, at, word);
    while (at != NULL &&
           (at[1].sign != '(' || (at[-1].kind == GLSL_WORD && !glsl_is_any(at - 1, statements))));
    return at;
}
