#include "shader/glsl.h"

#include <string.h>

bool glsl_is_word(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

bool glsl_is_sign(const struct glsl_token *token, const char *signs)
{
    return token->sign != '\0' && strchr(signs, token->sign) != NULL;
}

bool glsl_is(const struct glsl_token *token, const char *word)
{
    // Most words differ in length, which is faster to compare than their text.
    return (size_t)token->length == strlen(word) && !token->macro && strcmp(token->text, word) == 0;
}

int glsl_type(const char *type, char *base)
{
    static const char *const words[] = {"float", "int",  "uint", "bool", "vec",
                                        "ivec",  "uvec", "bvec", "mat"};
    size_t length = strcspn(type, "234[");
    for (int i = 0; i < 9; i++) {
        const char *end = type + length + (i > 3 && type[length] != '\0');
        if (strlen(words[i]) != length || strncmp(type, words[i], length) != 0 ||
            (*end != '\0' && *end != '[') || (i > 3 && end == type + length))
            continue;
        *base = "fiubfiubm"[i];
        return i > 3 ? type[length] - '0' : 1;
    }
    return 0;
}

bool glsl_means(const struct glsl *code, const struct glsl_token *token, const char *word)
{
    const char *macro = token->macro ? code->name[token->name].word : NULL;
    return macro != NULL ? strcmp(macro, word) == 0 : glsl_is(token, word);
}

const struct glsl_token *glsl_code(const struct glsl_token *token)
{
    while (token->kind >= GLSL_COMMENT)
        token++;
    return token;
}

bool glsl_is_any(const struct glsl_token *token, const char *const words[])
{
    while (*words != NULL && !glsl_is(token, *words))
        words++;
    return *words != NULL;
}

bool glsl_is_precision(const struct glsl_token *token)
{
    return glsl_is_any(token, (const char *const[]){"lowp", "mediump", "highp", NULL});
}

const struct glsl_token *glsl_partner(const struct glsl *code, const struct glsl_token *bracket)
{
    return &code->statement[bracket->partner];
}

const struct glsl_token *glsl_next(const struct glsl *code, const struct glsl_token *token)
{
    if (glsl_is_sign(token, "([{"))
        token = glsl_partner(code, token);
    return token->kind == GLSL_END ? token : token + 1;
}

const struct glsl_token *glsl_skip(const struct glsl *code, const struct glsl_token *token,
                                   const char *signs)
{
    while (token->kind != GLSL_END && !glsl_is_sign(token, signs))
        token = glsl_next(code, token);
    return token;
}
