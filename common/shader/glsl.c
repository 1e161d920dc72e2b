#include "shader/glsl.h"

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

const char *glsl_skip_blanks(const char *c)
{
    return c + strspn(c, " \t\n\v\f");
}

size_t glsl_word_length(const char *c)
{
    size_t length = 0;
    while (glsl_is_word(c[length]))
        length++;
    return length;
}

bool glsl_at_word(const char *c, const char *word)
{
    size_t length = strlen(word);
    return strncmp(c, word, length) == 0 && !glsl_is_word(c[length]);
}

bool glsl_at_precision(const char *c)
{
    return glsl_at_word(c, "lowp") || glsl_at_word(c, "mediump") || glsl_at_word(c, "highp");
}

// ---- What the preprocessor leaves out ----

// What is known of a condition before the driver has seen it.
enum truth { NEVER, ALWAYS, PERHAPS };

// Skip a word and the blanks behind it; NULL when c begins otherwise.
static const char *after_word(const char *c, const char *word)
{
    if (c == NULL || !glsl_at_word(c, word))
        return NULL;
    c += strlen(word);
    return c + strspn(c, " \t\v\f");
}

// The directive that a line holds, or NULL.
static const char *directive_of(const char *line)
{
    line += strspn(line, " \t\v\f");
    return *line == '#' ? line + 1 + strspn(line + 1, " \t\v\f") : NULL;
}

// Whether the name at c is defined there.
static enum truth is_defined(const char *code, const char *c)
{
    char name[64];
    size_t length = glsl_word_length(c);
    if (length == 0 || length >= sizeof name)
        return PERHAPS;
    memcpy(name, c, length);
    name[length] = '\0';
    if (strcmp(name, "GL_ES") == 0)
        return NEVER;
    if (strncmp(name, "GL_", 3) == 0 || strncmp(name, "__", 2) == 0 || strcmp(name, "VIEW") == 0 ||
        strcmp(name, "HW_PERFORMANCE") == 0)
        return PERHAPS;
    enum truth truth = NEVER;
    for (const char *found = glsl_find_word(code, name); found != NULL && found < c;
         found = find_word_from(code, found + 1, name)) {
        const char *line = found;
        while (line > code && line[-1] != '\n')
            line--;
        const char *directive = directive_of(line);
        if (after_word(directive, "define") == found)
            truth = truth == NEVER ? ALWAYS : truth;
        else if (after_word(directive, "undef") == found)
            truth = PERHAPS;
    }
    return truth;
}

static enum truth negate(enum truth truth)
{
    return truth == PERHAPS ? PERHAPS : truth == ALWAYS ? NEVER : ALWAYS;
}

// What stands behind #if: 0, 1, defined NAME or !defined(NAME), and nothing more; else PERHAPS.
static enum truth truth_of(const char *code, const char *c)
{
    bool no = *c == '!';
    const char *name = after_word(c + no, "defined");
    const char *end = name != NULL ? name + (*name == '(') : c;
    enum truth truth = name != NULL ? is_defined(code, end) : *c == '0' ? NEVER : ALWAYS;
    bool number = name == NULL && (*c == '0' || *c == '1');
    while (glsl_is_word(*end))
        end++;
    end += strspn(end, ") \t\v\f");
    if ((name == NULL && !number) || *end != '\n')
        return PERHAPS;
    return no ? negate(truth) : truth;
}

// The condition of #if, #ifdef or #ifndef; false for another directive.
static bool find_condition(const char *code, const char *directive, enum truth *truth)
{
    const char *rest;
    if ((rest = after_word(directive, "ifdef")) != NULL)
        *truth = is_defined(code, rest);
    else if ((rest = after_word(directive, "ifndef")) != NULL)
        *truth = negate(is_defined(code, rest));
    else if ((rest = after_word(directive, "if")) != NULL)
        *truth = truth_of(code, rest);
    return rest != NULL;
}

// One #if under way.
struct conditional {
    bool live;         // what stands around it is not left out
    enum truth branch; // the part at hand is taken
    enum truth others; // and what is left for the parts to come
};

void glsl_blank_inactive(char *code)
{
    enum { DEPTH = 64 };
    struct conditional open[DEPTH] = {{true, ALWAYS, NEVER}}, *at = open;
    for (char *line = code; *line != '\0';) {
        size_t length = strcspn(line, "\n");
        const char *directive = directive_of(line);
        bool now = at->live && at->branch != NEVER, inside = at > open;
        enum truth truth;
        if (find_condition(code, directive, &truth)) {
            if (++at == open + DEPTH)
                return;
            *at = (struct conditional){now, truth, negate(truth)};
        } else if (inside && after_word(directive, "else") != NULL) {
            at->branch = at->others;
        } else if (inside && after_word(directive, "elif") != NULL) {
            at->branch = at->others = at->others == NEVER ? NEVER : PERHAPS;
        } else if (inside && after_word(directive, "endif") != NULL) {
            at--;
        } else if (!now) {
            blank(line, line + length);
        }
        line += length + (line[length] == '\n');
    }
}

bool glsl_is_certain(const char *code, size_t at)
{
    int open = 0;
    for (const char *line = code; line < code + at; line += strcspn(line, "\n") + 1) {
        const char *directive = directive_of(line);
        bool opens = directive != NULL && strncmp(directive, "if", 2) == 0;
        open += opens - (after_word(directive, "endif") != NULL);
    }
    return open <= 0;
}

void glsl_blank_directives(char *code)
{
    bool joined = false;
    for (char *line = code; *line != '\0';) {
        size_t length = strcspn(line, "\n");
        bool directive = joined || line[strspn(line, " \t\v\f")] == '#';
        joined = directive && length > 0 && line[length - 1] == '\\';
        if (directive)
            blank(line, line + length);
        line += length + (line[length] == '\n');
    }
}

// ---- Words and functions ----

const char *glsl_find_definition(const char *code, const char *name)
{
    for (const char *c = glsl_find_word(code, name); c != NULL;
         c = find_word_from(code, c + 1, name)) {
        const char *next = glsl_skip_blanks(c + strlen(name));
        const char *close = *next == '(' ? strchr(next, ')') : NULL;
        if (close != NULL && *glsl_skip_blanks(close + 1) == '{')
            return c;
    }
    return NULL;
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
        if (*glsl_skip_blanks(c + strlen(name)) == '(' && !after_type(code, c))
            return c;
    return NULL;
}
