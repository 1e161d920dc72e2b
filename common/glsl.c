#include "glsl.h"

#include <stddef.h>
#include <string.h>

// The end of the line comment that begins at c: its newline, or the end of the text.
static char *line_comment_end(char *c)
{
    for (; *c != '\0'; c++) {
        if (*c == '\n')
            return c;
        if (c[0] == '\\' && c[1] == '\n')
            c++;
    }
    return c;
}

static void blank(char *begin, const char *end)
{
    for (char *c = begin; c < end; c++)
        if (*c != '\n')
            *c = ' ';
}

char *glsl_blank_comments(char *text, bool keep_line_comments)
{
    char *open = NULL;
    for (char *c = text; *c != '\0';) {
        char *end = c + 1;
        if (c[0] == '/' && c[1] == '/') {
            end = line_comment_end(c);
            if (!keep_line_comments)
                blank(c, end);
        } else if (c[0] == '/' && c[1] == '*') {
            char *close = strstr(c + 2, "*/");
            open = close == NULL ? c : NULL;
            end = close == NULL ? c + strlen(c) : close + 2;
            blank(c, end);
        }
        c = end;
    }
    return open;
}

bool glsl_is_word(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

// As glsl_find_word, looking from a place inside the code.
static const char *find_word_from(const char *code, const char *from, const char *word)
{
    size_t length = strlen(word);
    for (const char *c = strstr(from, word); c != NULL; c = strstr(c + 1, word))
        if ((c == code || !glsl_is_word(c[-1])) && !glsl_is_word(c[length]))
            return c;
    return NULL;
}

const char *glsl_find_word(const char *code, const char *word)
{
    return find_word_from(code, code, word);
}

static const char *skip_blanks(const char *c)
{
    return c + strspn(c, " \t\n\v\f");
}

bool glsl_defines(const char *code, const char *name)
{
    for (const char *c = glsl_find_word(code, name); c != NULL;
         c = find_word_from(code, c + 1, name)) {
        const char *next = skip_blanks(c + strlen(name));
        const char *close = *next == '(' ? strchr(next, ')') : NULL;
        if (close != NULL && *skip_blanks(close + 1) == '{')
            return true;
    }
    return false;
}

// A type before the name makes it a declaration; after these words stands an expression.
static bool after_type(const char *code, const char *name)
{
    static const char *const statements[] = {"return", "else", "do"};
    const char *end = name;
    while (end > code && strchr(" \t\n\v\f", end[-1]) != NULL)
        end--;
    const char *begin = end;
    while (begin > code && glsl_is_word(begin[-1]))
        begin--;
    size_t length = (size_t)(end - begin);
    for (size_t i = 0; i < sizeof statements / sizeof *statements; i++)
        if (strlen(statements[i]) == length && strncmp(begin, statements[i], length) == 0)
            return false;
    return length > 0;
}

const char *glsl_find_call(const char *code, const char *name)
{
    for (const char *c = glsl_find_word(code, name); c != NULL;
         c = find_word_from(code, c + 1, name))
        if (*skip_blanks(c + strlen(name)) == '(' && !after_type(code, c))
            return c;
    return NULL;
}
