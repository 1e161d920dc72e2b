#include "shader/glsl.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "context/gl.h"
#include "memory.h"

enum { ENDS = 4 }; // number of tokens of kind GLSL_END after each row

// An open #if.
struct glsl_conditional {
    enum glsl_truth others; // whether a later branch may be taken
    bool live, certain;     // whether the text around the #if is live, and certain
    int depth, begin;       // bracket depth at the #if, and at the beginning of this branch
};

// ---- Names ----

// The slot of a word in the table of names; a free slot if the word is new.
static int *slot_of(const struct glsl *code, const char *word, int length)
{
    unsigned hash = 2166136261u, mask = (unsigned)(code->table_size - 1);
    for (int i = 0; i < length; i++)
        hash = (hash ^ (unsigned char)word[i]) * 16777619u;
    for (hash &= mask; code->table[hash] >= 0; hash = (hash + 1) & mask) {
        const char *text = code->name[code->table[hash]].text;
        if (strncmp(text, word, (size_t)length) == 0 && text[length] == '\0')
            break;
    }
    return &code->table[hash];
}

// Double the table when it is half full.
static void grow_table(struct glsl *code)
{
    if (2 * code->name_count < code->table_size)
        return;
    code->table_size = code->table_size > 0 ? 2 * code->table_size : 64;
    free(code->table);
    code->table = memory_zeros((size_t)code->table_size, sizeof *code->table);
    memset(code->table, 0xFF, (size_t)code->table_size * sizeof *code->table); // every entry is -1
    for (int i = 0; i < code->name_count; i++)
        *slot_of(code, code->name[i].text, (int)strlen(code->name[i].text)) = i;
}

// Find or add the name of a word. Returns the name's index.
static int add_name(struct glsl *code, const char *word, int length)
{
    grow_table(code);
    int *slot = slot_of(code, word, length);
    if (*slot < 0) {
        char *text = memory_zeros((size_t)length + 1, 1);
        memcpy(text, word, (size_t)length);
        code->name = memory_row(code->name, code->name_count, sizeof *code->name);
        *slot = code->name_count++;
        code->name[*slot] = (struct glsl_name){.text = text, .last = -1};
    }
    return *slot;
}

struct glsl_name *glsl_name(const struct glsl *code, const char *word)
{
    int at = code->table_size > 0 ? *slot_of(code, word, (int)strlen(word)) : -1;
    return at >= 0 ? &code->name[at] : NULL;
}

int glsl_mentions(const struct glsl *code, const char *word)
{
    const struct glsl_name *name = glsl_name(code, word);
    return name != NULL ? name->count : 0;
}

// ---- Conditions ----

static enum glsl_truth negate(enum glsl_truth truth)
{
    return truth == GLSL_PERHAPS ? truth : truth == GLSL_ALWAYS ? GLSL_NEVER : GLSL_ALWAYS;
}

static enum glsl_truth is_defined(const struct glsl *code, const struct glsl_token *token)
{
    if (token->kind != GLSL_WORD || glsl_is(token, "VIEW") || glsl_is(token, "HW_PERFORMANCE"))
        return GLSL_PERHAPS;
    if (glsl_is(token, "GL_ES"))
        return GL_IS_ES ? GLSL_ALWAYS : GLSL_NEVER;
    bool drivers = strncmp(token->text, "GL_", 3) == 0 || strncmp(token->text, "__", 2) == 0;
    return drivers ? GLSL_PERHAPS : code->name[token->name].defined;
}

// The truth of a condition that is 0, 1, defined NAME or !defined(NAME); GLSL_PERHAPS for any other
// condition.
static enum glsl_truth truth_of(const struct glsl *code, const struct glsl_token *c)
{
    bool no = c->sign == '!';
    enum glsl_truth truth = GLSL_PERHAPS;
    c += no;
    if (glsl_is(c, "defined")) {
        bool bracket = c[1].sign == '(';
        truth = is_defined(code, c + 1 + bracket);
        c += 2 + 2 * bracket;
    } else if (!no && (glsl_is(c, "0") || glsl_is(c, "1"))) {
        truth = glsl_is(c, "0") ? GLSL_NEVER : GLSL_ALWAYS;
        c++;
    }
    return glsl_code(c)->kind != GLSL_END ? GLSL_PERHAPS : no ? negate(truth) : truth;
}

// Begin the next branch of the innermost #if. A skipped branch does not change the depth; if
// several branches may be taken, each begins with the depth of the #if.
static void begin_part(struct glsl_reader *r, enum glsl_truth branch, enum glsl_truth others)
{
    struct glsl_conditional *last = &r->open[r->open_count - 1];
    bool live = last->live && branch != GLSL_NEVER;
    r->depth = !r->live ? last->begin : live ? last->depth : r->depth;
    last->others = others;
    last->begin = r->depth;
    r->live = live;
    r->certain = live && last->certain && branch == GLSL_ALWAYS;
}

static void begin_if(struct glsl_reader *r, enum glsl_truth truth)
{
    r->open = memory_row(r->open, r->open_count, sizeof *r->open);
    r->open[r->open_count++] = (struct glsl_conditional){
        .live = r->live, .certain = r->certain, .depth = r->depth, .begin = r->depth};
    begin_part(r, truth, negate(truth));
}

static void end_if(struct glsl_reader *r)
{
    const struct glsl_conditional *last = &r->open[--r->open_count];
    r->depth = r->live ? r->depth : last->begin;
    r->live = last->live;
    r->certain = last->certain;
}

static void define(struct glsl_reader *r, struct glsl_token *word, bool defines)
{
    struct glsl_name *name = &r->code->name[word->name];
    enum glsl_truth truth = defines ? GLSL_ALWAYS : GLSL_NEVER;
    if (defines) {
        bool one = !name->macro && (word[1].kind == GLSL_WORD || word[1].kind == GLSL_NUMBER) &&
                   glsl_code(word + 2)->kind == GLSL_END;
        name->word = one ? word[1].text : NULL;
    }
    name->macro |= defines;
    word->macro = true;
    name->defined = r->certain || name->defined == truth ? truth : GLSL_PERHAPS;
}

// Put the end tokens after the row of all tokens, which may still grow.
static void add_ends(struct glsl *code)
{
    for (int i = 0; i < ENDS; i++) {
        code->item = memory_row(code->item, code->count + i, sizeof *code->item);
        code->item[code->count + i] = (struct glsl_token){.text = ""};
    }
}

// Obey the directive that consists of the last tokens.
static void obey(struct glsl_reader *r)
{
    struct glsl *code = r->code;
    add_ends(code);
    struct glsl_token *word = code->item + r->hash + 1;
    const struct glsl_conditional *last = r->open_count > 0 ? &r->open[r->open_count - 1] : NULL;
    r->inside = false;
    if (glsl_is(word, "ifdef"))
        begin_if(r, is_defined(code, word + 1));
    else if (glsl_is(word, "ifndef"))
        begin_if(r, negate(is_defined(code, word + 1)));
    else if (glsl_is(word, "if"))
        begin_if(r, truth_of(code, word + 1));
    else if (last != NULL && glsl_is(word, "else"))
        begin_part(r, last->others, GLSL_NEVER);
    else if (last != NULL && glsl_is(word, "elif"))
        begin_part(r, last->others == GLSL_NEVER ? GLSL_NEVER : GLSL_PERHAPS,
                   last->others == GLSL_NEVER ? GLSL_NEVER : GLSL_PERHAPS);
    else if (last != NULL && glsl_is(word, "endif"))
        end_if(r);
    else if (r->live && word[1].kind == GLSL_WORD &&
             (glsl_is(word, "define") || glsl_is(word, "undef")))
        define(r, word + 1, glsl_is(word, "define"));
}

// ---- The scan ----

// Append length bytes from c to the text, and move c past them.
static void append(struct glsl *code, const char **c, int length)
{
    const char *from = *c;
    if (code->length + length >= code->room) {
        code->room = 2 * (code->length + length) + 256;
        char *text = memory_zeros((size_t)code->room, 1);
        if (code->length > 0)
            memcpy(text, code->text, (size_t)code->length);
        free(code->text);
        code->text = text;
    }
    memcpy(code->text + code->length, from, (size_t)length);
    code->length += length;
    for (int i = 0; i < length; i++)
        code->lines += from[i] == '\n';
    *c += length;
}

// The length of the line comment that begins at c.
static int line_comment(const char *c)
{
    int length = 2;
    while (c[length] != '\0' && c[length] != '\n')
        length += c[length] == '\\' && c[length + 1] == '\n' ? 2 : 1;
    return length;
}

static int number_length(const char *c)
{
    bool hexadecimal = c[0] == '0' && (c[1] == 'x' || c[1] == 'X');
    int length = 1;
    while (glsl_is_word(c[length]) || c[length] == '.' ||
           (!hexadecimal && (c[length] == '+' || c[length] == '-') &&
            (c[length - 1] == 'e' || c[length - 1] == 'E')))
        length++;
    return length;
}

// The kind and the length of the token that begins at c.
static struct glsl_token token_at(struct glsl_reader *r, const char *c)
{
    struct glsl_token token = {.kind = GLSL_SIGN, .length = 1, .text = ""};
    if (c[0] == '/' && c[1] == '/') {
        token.kind = GLSL_COMMENT;
        token.length = line_comment(c);
    } else if (c[0] == '/' && c[1] == '*') {
        const char *close = strstr(c + 2, "*/");
        token.kind = GLSL_COMMENTED;
        r->code->open = close == NULL;
        token.length = close == NULL ? (int)strlen(c) : (int)(close + 2 - c);
    } else if (isdigit((unsigned char)c[*c == '.'])) {
        token.kind = GLSL_NUMBER;
        token.length = number_length(c);
    } else if (glsl_is_word(*c)) {
        token.kind = GLSL_WORD;
        while (glsl_is_word(c[token.length]))
            token.length++;
    } else if (*c == '#' && !r->word) {
        token.kind = GLSL_HASH;
    } else {
        token.sign = *c;
    }
    return token;
}

// Set the depth of a bracket, which is that of the text around it, and its partner, which is the
// bracket itself until the other one is found.
//   at  the bracket's index among the statements
static void count_bracket(struct glsl_reader *r, struct glsl_token *token, int at)
{
    struct glsl_token *statement = r->code->statement;
    bool opens = glsl_is_sign(token, "([{"), closes = glsl_is_sign(token, ")]}");
    bool stray = closes && r->depth == 0;
    token->depth = r->depth -= closes && !stray;
    token->partner = at;
    if (token->live && opens) {
        r->bracket = memory_row(r->bracket, r->depth, sizeof *r->bracket);
        r->bracket[r->depth] = at;
    }
    if (token->live && closes && !stray) {
        token->partner = r->bracket[r->depth];
        statement[token->partner].partner = at;
    }
    r->depth += opens;
}

static void add_statement(struct glsl_reader *r, const struct glsl_token *token)
{
    struct glsl *code = r->code;
    struct glsl_token *row = code->statement != NULL ? code->statement - 1 : NULL;
    row =
        memory_row(row, code->statement_count + 1, sizeof *row); // plus the token before the first
    code->statement = row + 1;
    code->statement[code->statement_count] = *token;
    code->statement[code->statement_count].item = code->count;
    code->statement[code->statement_count++].parted = r->parted;
    r->parted = false;
}

static void take(struct glsl_reader *r, const char **c)
{
    struct glsl *code = r->code;
    struct glsl_token token = token_at(r, *c);
    if (token.kind == GLSL_HASH) {
        r->inside = true;
        r->hash = code->count;
    }
    token.begin = code->length;
    token.line = code->lines;
    token.directive = r->inside;
    token.live = r->live;
    token.certain = r->certain;
    token.depth = r->depth;
    append(code, c, token.length);
    r->word |= token.kind < GLSL_COMMENT;
    r->parted |= r->inside;
    if (token.kind == GLSL_WORD || token.kind == GLSL_NUMBER) {
        token.name = add_name(code, code->text + token.begin, token.length);
        token.text = code->name[token.name].text;
        token.macro = token.kind == GLSL_WORD && code->name[token.name].defined != GLSL_NEVER;
        code->name[token.name].count += token.live;
    }
    if (!token.directive && token.kind < GLSL_COMMENT) {
        if (glsl_is_sign(&token, "([{)]}"))
            count_bracket(r, &token, code->statement_count);
        if (token.live)
            add_statement(r, &token);
    }
    code->item = memory_row(code->item, code->count, sizeof *code->item);
    code->item[code->count++] = token;
}

void glsl_take_line(struct glsl_reader *r, const char **c)
{
    for (bool ended = false; !ended && **c != '\0';) {
        bool joins = (*c)[0] == '\\' && (*c)[1] == '\n';
        ended = **c == '\n';
        if (joins || ended || strchr(" \t\v\f", **c) != NULL)
            append(r->code, c, 1 + joins);
        else
            take(r, c);
    }
    r->word = false;
    if (r->inside)
        obey(r);
}

void glsl_take_comment(struct glsl_reader *r, const char **c)
{
    const char *mark = "// ";
    append(r->code, &mark, 3);
    append(r->code, c, (int)strcspn(*c, "\n") + 1);
}

void glsl_begin(struct glsl_reader *r, struct glsl *code)
{
    *code = (struct glsl){0};
    *r = (struct glsl_reader){.code = code, .live = true, .certain = true};
    append(code, &(const char *){""}, 0);
}

void glsl_end(struct glsl_reader *r)
{
    struct glsl *code = r->code;
    for (int i = 0; i < code->statement_count; i++) {
        struct glsl_token *token = &code->statement[i];
        if (token->kind == GLSL_WORD)
            code->name[token->name].last = i;
        else if (glsl_is_sign(token, "([{") && token->partner == i)
            token->partner = code->statement_count;
    }
    int statements = code->statement_count;
    add_ends(code);
    for (int i = 0; i < ENDS; i++)
        add_statement(r, &(struct glsl_token){.text = ""});
    code->statement_count = statements;
    code->statement[-1] = (struct glsl_token){.text = ""};
    free(r->bracket);
    free(r->open);
}

void glsl_read(struct glsl *code, const char *text)
{
    struct glsl_reader reader;
    glsl_begin(&reader, code);
    while (*text != '\0')
        glsl_take_line(&reader, &text);
    glsl_end(&reader);
}

void glsl_free(struct glsl *code)
{
    for (int i = 0; i < code->name_count; i++)
        free(code->name[i].text);
    free(code->text);
    free(code->item);
    free(code->statement != NULL ? code->statement - 1 : NULL);
    free(code->name);
    free(code->table);
    *code = (struct glsl){0};
}
