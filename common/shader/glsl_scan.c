#include "shader/glsl_scan.h"

#include <string.h>

#include "memory.h"

bool glsl_is_word(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

// ---- Tokens ----

// The length of the line comment that begins at c.
static int line_comment(const char *c)
{
    int length = 2;
    while (c[length] != '\0' && c[length] != '\n')
        length += c[length] == '\\' && c[length + 1] == '\n' ? 2 : 1;
    return length;
}

static int block_comment(struct glsl *code, const char *c)
{
    const char *close = strstr(c + 2, "*/");
    if (close == NULL)
        code->open = (int)(c - code->text);
    return close == NULL ? (int)strlen(c) : (int)(close + 2 - c);
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static int number(const char *c)
{
    bool hexadecimal = c[0] == '0' && (c[1] == 'x' || c[1] == 'X');
    int length = 1;
    while (glsl_is_word(c[length]) || c[length] == '.' ||
           (!hexadecimal && (c[length] == '+' || c[length] == '-') &&
            (c[length - 1] == 'e' || c[length - 1] == 'E')))
        length++;
    return length;
}

static struct glsl_token token_at(struct glsl *code, const char *c, bool begins_line)
{
    struct glsl_token token = {.kind = GLSL_SIGN, .begin = (int)(c - code->text), .length = 1};
    if (c[0] == '/' && c[1] == '/') {
        token.kind = GLSL_COMMENT;
        token.length = line_comment(c);
    } else if (c[0] == '/' && c[1] == '*') {
        token.kind = GLSL_COMMENTED;
        token.length = block_comment(code, c);
    } else if (is_digit(*c) || (*c == '.' && is_digit(c[1]))) {
        token.kind = GLSL_NUMBER;
        token.length = number(c);
    } else if (glsl_is_word(*c)) {
        token.kind = GLSL_WORD;
        while (glsl_is_word(c[token.length]))
            token.length++;
    } else if (*c == '#' && begins_line) {
        token.kind = GLSL_HASH;
    } else {
        token.sign = *c;
    }
    return token;
}

static void read_tokens(struct glsl *code)
{
    int line = 0;
    bool begins = true, directive = false;
    for (const char *c = code->text; *c != '\0';) {
        if (strchr(" \t\v\f\n", *c) != NULL || (c[0] == '\\' && c[1] == '\n')) {
            begins |= *c == '\n';
            directive &= *c != '\n';
            line += *c == '\n' || *c == '\\';
            c += *c == '\\' ? 2 : 1;
            continue;
        }
        code->item = memory_row(code->item, code->count, sizeof *code->item);
        struct glsl_token *item = &code->item[code->count++];
        *item = token_at(code, c, begins);
        directive |= item->kind == GLSL_HASH;
        begins &= item->kind >= GLSL_COMMENT;
        item->directive = directive;
        item->line = line;
        for (const char *end = c + item->length; c < end; c++)
            line += *c == '\n';
    }
}

// ---- Names ----

// Where a word stands in the table of names, or would.
static int *slot_of(const struct glsl *code, const char *word, int length)
{
    unsigned hash = 2166136261u;
    for (int i = 0; i < length; i++)
        hash = (hash ^ (unsigned char)word[i]) * 16777619u;
    unsigned at = hash & (unsigned)(code->table_size - 1);
    for (; code->table[at] >= 0; at = (at + 1) & (unsigned)(code->table_size - 1)) {
        const struct glsl_name *name = &code->name[code->table[at]];
        if (name->length == length && memcmp(code->text + name->begin, word, (size_t)length) == 0)
            break;
    }
    return &code->table[at];
}

static void read_names(struct glsl *code)
{
    int words = 0;
    for (int i = 0; i < code->count; i++)
        words += code->item[i].kind == GLSL_WORD;
    for (code->table_size = 2; code->table_size < 2 * words;)
        code->table_size *= 2;
    code->table = memory_zeros((size_t)code->table_size, sizeof *code->table);
    memset(code->table, 0xFF, (size_t)code->table_size * sizeof *code->table); // -1 each
    for (int i = 0; i < code->count; i++) {
        struct glsl_token *token = &code->item[i];
        if (token->kind != GLSL_WORD)
            continue;
        int *slot = slot_of(code, code->text + token->begin, token->length);
        if (*slot < 0) {
            code->name = memory_row(code->name, code->name_count, sizeof *code->name);
            *slot = code->name_count++;
            code->name[*slot] =
                (struct glsl_name){token->begin, token->length, 0, -1, -1, GLSL_NEVER};
        }
        token->name = *slot;
    }
}

struct glsl_name *glsl_name(const struct glsl *code, const char *word)
{
    int at = *slot_of(code, word, (int)strlen(word));
    return at >= 0 ? &code->name[at] : NULL;
}

void glsl_scan(struct glsl *code)
{
    read_tokens(code);
    read_names(code);
}
