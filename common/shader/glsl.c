#include "shader/glsl.h"

#include <stdlib.h>
#include <string.h>

#include "context/gl.h"
#include "memory.h"

enum { ENDS = 4 }; // tokens of the kind GLSL_END behind a row

bool glsl_is_sign(const struct glsl_token *token, const char *signs)
{
    return token->sign != '\0' && strchr(signs, token->sign) != NULL;
}

int glsl_mentions(const struct glsl *code, const char *word)
{
    const struct glsl_name *name = glsl_name(code, word);
    return name != NULL ? name->count : 0;
}

// ---- What the preprocessor leaves out ----

// One #if under way.
struct conditional {
    enum glsl_truth branch; // the part at hand is taken
    enum glsl_truth others; // and what is left for the parts to come
    bool live, certain;     // what stands around it
    int depth, begin;       // of brackets where the #if stands, and where the part at hand begins
};

// A walk over the text that tells what counts.
struct walk {
    struct glsl *code;
    struct conditional *open; // the #ifs around the place
    int count;
    int *bracket; // the open brackets among the statements
    int depth;
    bool live, certain, parted;
};

static enum glsl_truth negate(enum glsl_truth truth)
{
    return truth == GLSL_PERHAPS ? GLSL_PERHAPS : truth == GLSL_ALWAYS ? GLSL_NEVER : GLSL_ALWAYS;
}

static enum glsl_truth is_defined(const struct glsl *code, const struct glsl_token *token)
{
    const char *word = code->text + token->begin;
    if (token->kind != GLSL_WORD || !token->directive || glsl_is(code, token, "VIEW") ||
        glsl_is(code, token, "HW_PERFORMANCE"))
        return GLSL_PERHAPS;
    if (glsl_is(code, token, "GL_ES"))
        return GL_IS_ES ? GLSL_ALWAYS : GLSL_NEVER;
    bool drivers = strncmp(word, "GL_", 3) == 0 || strncmp(word, "__", 2) == 0;
    return drivers ? GLSL_PERHAPS : code->name[token->name].defined;
}

// What stands behind #if: 0, 1, defined NAME or !defined(NAME), and nothing more; else
// GLSL_PERHAPS.
static enum glsl_truth truth_of(const struct glsl *code, const struct glsl_token *c)
{
    const struct glsl_token *hash = c - 2;
    bool no = c->sign == '!';
    enum glsl_truth truth = GLSL_PERHAPS;
    c += no;
    if (glsl_is(code, c, "defined")) {
        bool bracket = c[1].sign == '(';
        truth = is_defined(code, c + 1 + bracket);
        c += 2 + 2 * bracket;
    } else if (!no && (glsl_is(code, c, "0") || glsl_is(code, c, "1"))) {
        truth = code->text[c->begin] == '0' ? GLSL_NEVER : GLSL_ALWAYS;
        c++;
    }
    while (c->kind >= GLSL_COMMENT && c->directive)
        c++;
    bool ends = c->kind == GLSL_END || c->kind == GLSL_HASH || !c->directive;
    return !ends || c <= hash + 2 ? GLSL_PERHAPS : no ? negate(truth) : truth;
}

// The condition of #if, #ifdef or #ifndef; false for another directive.
static bool find_condition(const struct glsl *code, const struct glsl_token *word,
                           enum glsl_truth *truth)
{
    if (glsl_is(code, word, "ifdef"))
        *truth = is_defined(code, word + 1);
    else if (glsl_is(code, word, "ifndef"))
        *truth = negate(is_defined(code, word + 1));
    else if (glsl_is(code, word, "if"))
        *truth = truth_of(code, word + 1);
    else
        return false;
    return true;
}

// The next part of the last #if. A part that is left out moves no brackets; of parts that may all
// be taken each begins where the #if does.
static void begin_part(struct walk *walk, enum glsl_truth branch, enum glsl_truth others)
{
    struct conditional *last = &walk->open[walk->count - 1];
    bool live = last->live && branch != GLSL_NEVER;
    walk->depth = !walk->live ? last->begin : live ? last->depth : walk->depth;
    last->branch = branch;
    last->others = others;
    last->begin = walk->depth;
    walk->live = live;
    walk->certain = live && last->certain && branch == GLSL_ALWAYS;
}

static void begin_if(struct walk *walk, enum glsl_truth truth)
{
    walk->open = memory_row(walk->open, walk->count, sizeof *walk->open);
    walk->open[walk->count++] = (struct conditional){
        .live = walk->live, .certain = walk->certain, .depth = walk->depth, .begin = walk->depth};
    begin_part(walk, truth, negate(truth));
}

static void define(struct walk *walk, const struct glsl_token *hash)
{
    struct glsl_name *name = &walk->code->name[hash[2].name];
    bool defines = glsl_is(walk->code, hash + 1, "define");
    if (defines && name->definition < 0)
        name->definition = (int)(hash - walk->code->item);
    if (!defines || name->defined == GLSL_NEVER)
        name->defined = defines && walk->certain ? GLSL_ALWAYS : GLSL_PERHAPS;
}

// Obey a directive.
static void obey(struct walk *walk, const struct glsl_token *hash)
{
    const struct glsl *code = walk->code;
    const struct glsl_token *word = hash + 1;
    struct conditional *last = walk->count > 0 ? &walk->open[walk->count - 1] : NULL;
    enum glsl_truth truth;
    if (word->kind != GLSL_WORD || !word->directive)
        return;
    if (find_condition(code, word, &truth)) {
        begin_if(walk, truth);
    } else if (last != NULL && glsl_is(code, word, "else")) {
        begin_part(walk, last->others, GLSL_NEVER);
    } else if (last != NULL && glsl_is(code, word, "elif")) {
        truth = last->others == GLSL_NEVER ? GLSL_NEVER : GLSL_PERHAPS;
        begin_part(walk, truth, truth);
    } else if (last != NULL && glsl_is(code, word, "endif")) {
        walk->depth = walk->live ? walk->depth : last->begin;
        walk->live = last->live;
        walk->certain = last->certain;
        walk->count--;
    } else if (walk->live && word[1].kind == GLSL_WORD && word[1].directive &&
               (glsl_is(code, word, "define") || glsl_is(code, word, "undef"))) {
        define(walk, hash);
    }
}

// Count a bracket, whose depth is that of what stands around it. One without a partner has itself.
//   at  its place among the statements
static void count_bracket(struct walk *walk, struct glsl_token *token, int at)
{
    struct glsl_token *statement = walk->code->statement;
    bool opens = glsl_is_sign(token, "([{"), closes = glsl_is_sign(token, ")]}");
    bool stray = closes && walk->depth == 0;
    token->depth = walk->depth -= closes && !stray;
    token->partner = at;
    if (token->live && opens)
        walk->bracket[walk->depth] = at;
    if (token->live && closes && !stray) {
        token->partner = walk->bracket[walk->depth];
        statement[token->partner].partner = at;
    }
    walk->depth += opens;
}

// Say of each token whether it counts, and put those of the statements into a row of their own.
static void judge(struct walk *walk)
{
    struct glsl *code = walk->code;
    for (int i = 0; i < code->count; i++) {
        struct glsl_token *token = &code->item[i];
        int at = code->statement_count;
        if (token->kind == GLSL_HASH)
            obey(walk, token);
        token->live = walk->live;
        token->certain = walk->certain;
        token->depth = walk->depth;
        walk->parted |= token->directive;
        if (token->kind == GLSL_WORD)
            code->name[token->name].count += token->live;
        if (token->directive || token->kind >= GLSL_COMMENT)
            continue;
        if (glsl_is_sign(token, "([{)]}"))
            count_bracket(walk, token, at);
        if (!token->live)
            continue;
        token->parted = walk->parted;
        walk->parted = false;
        code->statement[code->statement_count++] = *token;
    }
}

// What only the whole text tells.
static void finish(struct glsl *code)
{
    for (int i = 0; i < code->statement_count; i++) {
        struct glsl_token *token = &code->statement[i];
        if (token->kind == GLSL_WORD) {
            struct glsl_name *name = &code->name[token->name];
            token->macro = name->definition >= 0;
            name->last = i;
        } else if (glsl_is_sign(token, "([{") && token->partner == i) {
            token->partner = code->statement_count;
        }
    }
}

// Add the ends to the rows.
static void make_rows(struct glsl *code)
{
    for (int i = 0; i < ENDS; i++) {
        code->item = memory_row(code->item, code->count + i, sizeof *code->item);
        code->item[code->count + i] = (struct glsl_token){0};
    }
    code->statement = memory_zeros((size_t)code->count + ENDS + 1, sizeof *code->statement);
    code->statement++; // the end before the first one
}

void glsl_read(struct glsl *code, const char *text)
{
    *code = (struct glsl){.text = memory_text("%s", text), .open = -1};
    glsl_scan(code);
    make_rows(code);
    struct walk walk = {.code = code, .live = true, .certain = true};
    walk.bracket = memory_zeros((size_t)code->count, sizeof *walk.bracket);
    judge(&walk);
    free(walk.bracket);
    free(walk.open);
    finish(code);
}

void glsl_free(struct glsl *code)
{
    free(code->text);
    free(code->item);
    free(code->statement != NULL ? code->statement - 1 : NULL);
    free(code->name);
    free(code->table);
    *code = (struct glsl){0};
}

// ---- Words and functions ----

bool glsl_is(const struct glsl *code, const struct glsl_token *token, const char *word)
{
    return !token->macro && strlen(word) == (size_t)token->length &&
           memcmp(code->text + token->begin, word, (size_t)token->length) == 0;
}

bool glsl_is_any(const struct glsl *code, const struct glsl_token *token, const char *const words[])
{
    while (*words != NULL && !glsl_is(code, token, *words))
        words++;
    return *words != NULL;
}

bool glsl_is_precision(const struct glsl *code, const struct glsl_token *token)
{
    static const char *const words[] = {"lowp", "mediump", "highp", NULL};
    return glsl_is_any(code, token, words);
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

const struct glsl_token *glsl_find(const struct glsl *code, const char *word)
{
    const struct glsl_token *token = code->item;
    while (token->kind != GLSL_END && !(token->live && glsl_is(code, token, word)))
        token++;
    return token->kind != GLSL_END ? token : NULL;
}

// The first word of the statements from a place on that is this name; NULL for none.
static const struct glsl_token *next_mention(const struct glsl *code, int from,
                                             const struct glsl_name *name)
{
    for (int i = from; name != NULL && i <= name->last; i++)
        if (code->statement[i].kind == GLSL_WORD && &code->name[code->statement[i].name] == name)
            return &code->statement[i];
    return NULL;
}

const struct glsl_token *glsl_find_definition(const struct glsl *code, const char *word)
{
    const struct glsl_name *name = glsl_name(code, word);
    const struct glsl_token *at = next_mention(code, 0, name);
    while (at != NULL && (at[1].sign != '(' || glsl_next(code, at + 1)->sign != '{'))
        at = next_mention(code, (int)(at - code->statement) + 1, name);
    return at;
}

// A type before the name makes it a declaration; after these words stands an expression.
const struct glsl_token *glsl_find_call(const struct glsl *code, const char *word)
{
    static const char *const statements[] = {"return", "else", "do", NULL};
    const struct glsl_name *name = glsl_name(code, word);
    const struct glsl_token *at = next_mention(code, 0, name);
    while (at != NULL && (at[1].sign != '(' ||
                          (at[-1].kind == GLSL_WORD && !glsl_is_any(code, at - 1, statements))))
        at = next_mention(code, (int)(at - code->statement) + 1, name);
    return at;
}
