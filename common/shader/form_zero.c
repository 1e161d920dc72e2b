#include "shader/form_zero.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "shader/glsl.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

// What is put in, and where.
struct insertion {
    size_t at;
    size_t number; // of those at one place, in this order
    char text[80];
};

struct insertions {
    const char *code, *statements; // the same places, with directives and without
    struct insertion *item;
    size_t count, capacity;
    size_t size; // letters of all texts
    bool failed; // for want of memory
};

static void insert(struct insertions *all, size_t at, const char *before, const char *word,
                   int length, const char *after)
{
    if (all->count == all->capacity) {
        size_t capacity = 2 * all->capacity + 64;
        struct insertion *grown = realloc(all->item, capacity * sizeof *grown);
        all->failed |= grown == NULL;
        if (grown == NULL)
            return;
        all->item = grown;
        all->capacity = capacity;
    }
    struct insertion *item = &all->item[all->count++];
    item->at = at;
    item->number = all->count;
    snprintf(item->text, sizeof item->text, "%s%.*s%s", before, length, word, after);
    all->size += strlen(item->text);
}

static int word_length(const char *c)
{
    return (int)glsl_word_length(c);
}

static bool is_one_of(const char *c, int length, const char *const words[], size_t count)
{
    for (size_t i = 0; i < count; i++)
        if ((int)strlen(words[i]) == length && strncmp(c, words[i], (size_t)length) == 0)
            return true;
    return false;
}

// A type that can be made of one number.
static bool is_type(const char *c, int length)
{
    static const char *const words[] = {
        "float", "int",   "uint",  "bool",  "vec2",  "vec3",  "vec4", "ivec2", "ivec3", "ivec4",
        "uvec2", "uvec3", "uvec4", "bvec2", "bvec3", "bvec4", "mat2", "mat3",  "mat4"};
    return is_one_of(c, length, words, COUNT(words));
}

// Words that begin a declaration which stays as it is, to its semicolon.
static bool is_other(const char *c, int length)
{
    static const char *const words[] = {"struct",        "uniform",  "in",       "out",  "varying",
                                        "attribute",     "layout",   "const",    "flat", "smooth",
                                        "noperspective", "centroid", "precision"};
    return is_one_of(c, length, words, COUNT(words));
}

// The end of an expression or a declaration: its semicolon, or a comma outside of brackets.
static const char *skip_to_end(const char *c, bool commas)
{
    int depth = 0;
    for (; *c != '\0'; c++) {
        if (depth <= 0 && (*c == ';' || (*c == ',' && commas)))
            return c;
        depth += (strchr("([{", *c) != NULL) - (strchr(")]}", *c) != NULL);
        if (depth < 0)
            return c;
    }
    return c;
}

// The names behind a type. Returns where the declaration ends; what is none is left alone, and a
// name behind which an #if may put more.
static const char *zero_names(struct insertions *all, const char *type, int length)
{
    const char *c = glsl_skip_blanks(type + length);
    while (word_length(c) > 0) {
        const char *after = c + word_length(c);
        c = glsl_skip_blanks(after);
        size_t at = (size_t)(after - all->statements);
        bool alone = memchr(all->code + at, '#', (size_t)(c - after)) == NULL;
        if ((*c == ',' || *c == ';') && alone)
            insert(all, at, "=", type, length, "(0)");
        else if (*c == '=' || *c == '[')
            c = skip_to_end(c, true);
        if (*c != ',')
            return c;
        c = glsl_skip_blanks(c + 1);
    }
    return c;
}

// True where two words stand before a brace: a structure, the first word a macro for struct.
static bool is_structure(const char *code, const char *brace)
{
    const char *c = brace;
    for (int words = 0; words < 2 && *brace == '{'; words++) {
        while (c > code && strchr(" \t\n\v\f", c[-1]) != NULL)
            c--;
        if (c == code || !glsl_is_word(c[-1]))
            return false;
        while (c > code && glsl_is_word(c[-1]))
            c--;
    }
    return *brace == '{';
}

// Look at the beginning of each statement.
static void zero_variables(struct insertions *all)
{
    bool begins = true;
    for (const char *c = all->statements; *c != '\0';) {
        int length = word_length(c);
        if (is_structure(all->statements, c)) {
            c = skip_to_end(c, false);
        } else if (length == 0) {
            begins = (begins && strchr(" \t\n\v\f", *c) != NULL) || strchr(";{}", *c) != NULL;
            c++;
        } else if (strncmp(c, "for", 3) == 0 && length == 3 && *glsl_skip_blanks(c + 3) == '(') {
            c = glsl_skip_blanks(c + 3) + 1;
            begins = true;
        } else if (begins && is_other(c, length)) {
            c = skip_to_end(c, false);
        } else if (begins && is_type(c, length)) {
            c = zero_names(all, c, length);
            begins = false;
        } else {
            begins = begins && glsl_at_precision(c);
            c += length;
        }
    }
}

// "mainImage(out": the colour is an inout.
static void open_colour(struct insertions *all)
{
    for (const char *c = all->code; (c = glsl_find_word(c, "mainImage")) != NULL;) {
        c = glsl_skip_blanks(c + strlen("mainImage"));
        const char *word = *c == '(' ? glsl_skip_blanks(c + 1) : "";
        if (word_length(word) == 3 && strncmp(word, "out", 3) == 0)
            insert(all, (size_t)(word - all->code), "in", "", 0, "");
    }
}

// The place behind the brace with which main begins, or NULL where the word stands elsewhere too: a
// macro, a second main.
static const char *only_main(const char *code)
{
    const char *main = glsl_find_definition(code, "main");
    if (main == NULL || glsl_find_word(code, "main") != main ||
        glsl_find_word(main + strlen("main"), "main") != NULL)
        return NULL;
    return strchr(main, '{') + 1;
}

// The outputs of a whole file begin at 0 too: where main begins, for they cannot have a value
// before. One that is declared behind it, or perhaps left out, stays as it is.
static void zero_outputs(struct insertions *all)
{
    const char *main = only_main(all->code);
    const char *end = main != NULL ? all->statements + (main - all->code) : all->statements;
    int depth = 0;
    for (const char *c = all->statements; c < end;) {
        int length = word_length(c);
        depth += (*c == '(') - (*c == ')');
        if (depth == 0 && length == 3 && strncmp(c, "out", 3) == 0 &&
            glsl_is_certain(all->code, (size_t)(c - all->statements))) {
            const char *type = glsl_skip_blanks(c + 3);
            while (glsl_at_precision(type))
                type = glsl_skip_blanks(type + word_length(type));
            const char *name = glsl_skip_blanks(type + word_length(type));
            const char *after = glsl_skip_blanks(name + word_length(name));
            size_t at = (size_t)(end - all->statements);
            bool fits = word_length(name) < 64;
            if (fits && is_type(type, word_length(type)) && (*after == ';' || *after == ',')) {
                insert(all, at, "", name, word_length(name), "=");
                insert(all, at, "", type, word_length(type), "(0);");
            }
        }
        c += length > 0 ? length : 1;
    }
}

static int by_place(const void *a, const void *b)
{
    const struct insertion *first = a, *second = b;
    if (first->at == second->at)
        return (first->number > second->number) - (first->number < second->number);
    return first->at > second->at ? 1 : -1;
}

static char *apply(const struct insertions *all, const char *text)
{
    char *result = malloc(strlen(text) + all->size + 1), *to = result;
    size_t from = 0;
    for (size_t i = 0; i < all->count && result != NULL; i++) {
        const struct insertion *item = &all->item[i];
        to += sprintf(to, "%.*s%s", (int)(item->at - from), text + from, item->text);
        from = item->at;
    }
    if (result != NULL)
        strcpy(to, text + from);
    return result;
}

char *form_zero(const char *text, const char *code)
{
    char *statements = strdup(code), *result = NULL;
    struct insertions all = {.code = code, .statements = statements};
    if (statements != NULL) {
        glsl_blank_directives(statements);
        zero_variables(&all);
        open_colour(&all);
        zero_outputs(&all);
        if (all.count > 0)
            qsort(all.item, all.count, sizeof *all.item, by_place);
        result = all.failed ? NULL : apply(&all, text);
    }
    free(statements);
    free(all.item);
    return result;
}
