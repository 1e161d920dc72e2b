#include "shader/annotation.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"

bool annotation_refuse(const struct annotation *a, const char *format, ...)
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

bool annotation_accept(struct annotation *a, char c)
{
    skip_blanks(a);
    if (*a->c != c)
        return false;
    a->c++;
    skip_blanks(a);
    return true;
}

bool annotation_accept_word(struct annotation *a, const char *word)
{
    size_t length = strlen(word);
    skip_blanks(a);
    if (strncmp(a->c, word, length) != 0 || glsl_is_word(a->c[length]))
        return false;
    a->c += length;
    skip_blanks(a);
    return true;
}

bool annotation_copy(struct annotation *a, const char *part, char *to, size_t size, size_t length)
{
    const char *from = a->c + strspn(a->c, BLANKS);
    const char *end = a->c + length;
    while (end > from && strchr(BLANKS, end[-1]) != NULL)
        end--;
    if (end <= from)
        return annotation_refuse(a, "the %s is missing: write it as in \"%s\"", part, a->example);
    if ((size_t)(end - from) >= size)
        return annotation_refuse(a, "the %s is too long: %d bytes at most", part, (int)size - 1);
    memcpy(to, from, (size_t)(end - from));
    to[end - from] = '\0';
    a->c += length;
    return true;
}

bool annotation_declaration(struct annotation *a)
{
    const struct glsl_token *word[4] = {0}; // type, name, semicolon, and one token too many
    const struct glsl_token *uniform = a->uniform, *t = uniform + 1;
    int count = 0;
    for (; t != a->comment && t->kind != GLSL_END && t->line == uniform->line && count < 4; t++) {
        if (t->kind < GLSL_COMMENT && !(count == 0 && glsl_is_precision(t)))
            word[count++] = t;
        else
            continue;
        while (a->quiet && count == 2 && t[1].sign != ';' && t[1].line == uniform->line &&
               t[1].kind != GLSL_END && t + 1 != a->comment)
            t++; // skip a default value
    }
    bool good = count > 1 && word[0]->sign == '\0' && word[1]->sign == '\0' &&
                word[0]->length < ANNOTATION_NAME && word[1]->length < ANNOTATION_NAME;
    if (!good)
        return !a->quiet &&
               shader_refuse(a->source, a->line,
                             "not a %s's declaration: write it as in \"%s\", with a name of at "
                             "most %d characters",
                             a->what, a->example, ANNOTATION_NAME - 1);
    a->type = word[0];
    snprintf(a->name, sizeof a->name, "%s", word[1]->text);
    return (count == 3 && word[2]->sign == ';') ||
           annotation_refuse(a,
                             "must be declared alone on its line, with nothing between its name "
                             "and the semicolon: write it as in \"%s\"",
                             a->example);
}

// The first line of a comment, without its first two characters. The caller frees it.
static char *words_of(const struct glsl *code, const struct glsl_token *comment)
{
    static const char *const spaces[] = {"\xC2\xA0", "\xE2\x80\xAF"};
    const char *begin = code->text + comment->begin + 2;
    char *words = memory_text("%.*s", (int)strcspn(begin, "\n"), begin);
    bool quoted = false; // no-break spaces in a file's name are kept
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

void annotation_begin(struct annotation *a, const struct shader_source *source,
                      const struct glsl_token *uniform, const char *what, const char *example)
{
    const struct glsl_token *t = uniform;
    while (t->kind != GLSL_END && t->kind != GLSL_COMMENT && t->line == uniform->line)
        t++;
    bool found = t->kind == GLSL_COMMENT && t->line == uniform->line;
    *a = (struct annotation){.what = what,
                             .example = example,
                             .source = source,
                             // In a file for another tool, the comment may mean something else.
                             .quiet = source->dialect != DIALECT_COURSE,
                             .line = uniform->line,
                             .uniform = uniform,
                             .comment = found ? t : NULL,
                             .words = found ? words_of(&source->code, t) : memory_text("%s", "")};
    a->c = a->words;
}
