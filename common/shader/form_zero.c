#include "shader/form_zero.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "memory.h"
#include "shader/form_inputs.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

#define SIZE_LIMIT (256 * 1024) // letters that are put in, before arrays stay as they are

enum { VALUE_SIZE = 4096 }; // letters of a value that is put in, its end included

// What is put in, and where; what stands there may be left out.
struct edit {
    int begin, length; // of what is left out
    int number;        // of those at one place, in this order
    char *text;
};

struct edits {
    const struct glsl *code;
    struct edit *item;
    int count;
    // Of a name: the value of the structure that it names, "" for none, NULL for no name.
    char **zero;
    bool arrays; // can have a value
    size_t size; // letters of all texts
};

static void edit(struct edits *all, int begin, int length, const char *text)
{
    all->item = memory_row(all->item, all->count, sizeof *all->item);
    all->item[all->count] = (struct edit){begin, length, all->count, memory_text("%s", text)};
    all->count++;
    all->size += strlen(text);
}

// ---- Zeros ----

// A type that can be made of one number.
static bool is_type(const struct glsl *code, const struct glsl_token *t)
{
    static const char *const words[] = {
        "float", "int",   "uint",  "bool",  "vec2",  "vec3",  "vec4", "ivec2", "ivec3", "ivec4",
        "uvec2", "uvec3", "uvec4", "bvec2", "bvec3", "bvec4", "mat2", "mat3",  "mat4",  NULL};
    return glsl_is_any(code, t, words);
}

static bool is_word(const struct glsl_token *t)
{
    return t->kind == GLSL_WORD && !t->macro;
}

// The value of a structure; NULL for another word, "" where none can be written.
static const char *zero_of_name(const struct edits *all, const struct glsl_token *type)
{
    return type->kind == GLSL_WORD ? all->zero[type->name] : NULL;
}

// The number between brackets, 1 to 255; 0 for what is none.
static int size_of(const struct glsl *code, const struct glsl_token *bracket)
{
    bool plain = bracket[1].kind == GLSL_NUMBER && bracket[2].sign == ']' && bracket[1].length < 4;
    int size = plain ? atoi(code->text + bracket[1].begin) : 0;
    return size < 256 && (size == 0 || code->text[bracket[1].begin] != '0') ? size : 0;
}

// Write the zero of a type, "float(0)" or the structure's; of an array
// "float[2](float(0),float(0))".
//   size  the bracket behind the name, or what else stands there
static bool zero_of(const struct edits *all, const struct glsl_token *type,
                    const struct glsl_token *size, char text[VALUE_SIZE])
{
    const struct glsl *code = all->code;
    const char *structure = is_word(type) ? zero_of_name(all, type) : NULL;
    char one[VALUE_SIZE] = "";
    if (is_type(code, type))
        snprintf(one, sizeof one, "%.*s(0)", GLSL_TEXT(code, type));
    else if (structure != NULL && all->size < SIZE_LIMIT)
        strcpy(one, structure);
    strcpy(text, one);
    if (one[0] == '\0' || size->sign != '[')
        return one[0] != '\0';
    int count = size_of(code, size), used = 0;
    if (!all->arrays || all->size > SIZE_LIMIT || count == 0 || size[3].sign == '[' ||
        count * ((int)strlen(one) + 1) + type->length > VALUE_SIZE / 2)
        return false;
    used = snprintf(text, VALUE_SIZE, "%.*s[%d](", GLSL_TEXT(code, type), count);
    for (int i = 0; i < count; i++)
        used += snprintf(text + used, (size_t)(VALUE_SIZE - used), "%s%c", one,
                         i + 1 < count ? ',' : ')');
    return true;
}

// The names of a type, from t on. Returns where the declaration ends; what is none is left alone,
// and a name behind which an #if may put more.
static const struct glsl_token *zero_names(struct edits *all, const struct glsl_token *type,
                                           const struct glsl_token *t)
{
    const struct glsl *code = all->code;
    while (is_word(t)) {
        const struct glsl_token *size = t + 1, *after = size;
        char text[VALUE_SIZE + 1] = "=";
        while (after->sign == '[')
            after = glsl_next(code, after);
        bool ends = glsl_is_sign(after, ",;") && !after->parted && !size->parted;
        if (ends && zero_of(all, type, size, text + 1))
            edit(all, after[-1].begin + after[-1].length, 0, text);
        if (after->sign == '=')
            after = glsl_skip(code, after, ",;)}");
        if (after->sign != ',')
            return after;
        t = after + 1;
    }
    return t;
}

// Learn the value of a structure, from its name on: types, names and sizes, or it has none.
static void learn(struct edits *all, const struct glsl_token *name)
{
    const struct glsl *code = all->code;
    const struct glsl_token *end = glsl_partner(code, name + 1), *type = NULL;
    char zero[2 * VALUE_SIZE], part[VALUE_SIZE];
    int used = snprintf(zero, VALUE_SIZE, "%.*s", GLSL_TEXT(code, name));
    bool done = name->certain && used < VALUE_SIZE / 2 && zero_of_name(all, name) == NULL;
    for (const struct glsl_token *t = name + 2, *after; done && t < end; t = after + 1) {
        while (type == NULL && glsl_is_precision(code, t))
            t++;
        type = type != NULL ? type : t++;
        after = t[1].sign == '[' ? glsl_next(code, t + 1) : t + 1;
        done = is_word(t) && !t->parted && !after->parted && zero_of(all, type, t + 1, part) &&
               used + (int)strlen(part) < VALUE_SIZE - 2 && glsl_is_sign(after, ",;");
        if (done)
            used += sprintf(zero + used, "%c%s", strchr(zero, '(') == NULL ? '(' : ',', part);
        type = after->sign == ',' ? type : NULL;
    }
    strcpy(zero + used, ")");
    free(all->zero[name->name]);
    all->zero[name->name] = memory_text("%s", done && used > name->length ? zero : "");
}

// True for braces that hold declarations of members: behind "struct S" in other words too, as
// macros have it, or, outside of functions, before a semicolon or a name and one.
static bool holds_members(const struct glsl *code, const struct glsl_token *t)
{
    const struct glsl_token *end = t->sign == '{' ? glsl_partner(code, t) + 1 : t;
    if (t->sign != '{')
        return false;
    if (t[-1].kind == GLSL_WORD && t[-2].kind == GLSL_WORD)
        return true;
    end += end->kind == GLSL_WORD;
    return t->depth == 0 && glsl_is_sign(end, ";,[=");
}

// Look at the beginning of each statement.
static void zero_variables(struct edits *all)
{
    // What begins a declaration that stays as it is, to its semicolon.
    static const char *const others[] = {
        "struct",    "uniform", "in",     "out",    "varying",       "attribute",
        "layout",    "const",   "flat",   "smooth", "noperspective", "centroid",
        "precision", "buffer",  "shared", NULL};
    const struct glsl *code = all->code;
    bool begins = true;
    for (const struct glsl_token *t = code->statement; t->kind != GLSL_END;) {
        bool loop = glsl_is(code, t, "for") && t[1].sign == '(';
        if (begins && glsl_is(code, t, "struct") && is_word(t + 1) && t[2].sign == '{') {
            learn(all, t + 1);
            t = zero_names(all, t + 1, glsl_next(code, t + 2));
        } else if (holds_members(code, t)) {
            t = glsl_next(code, t);
        } else if (begins && glsl_is_any(code, t, others)) {
            t = glsl_skip(code, t, ";)}");
        } else if (begins && (is_type(code, t) || zero_of_name(all, t) != NULL)) {
            t = zero_names(all, t, t + 1);
            begins = false;
        } else {
            begins = loop || glsl_is_sign(t, ";{}") || (begins && glsl_is_precision(code, t));
            t += 1 + loop;
        }
    }
}

// ---- Outputs, and words ----

// The brace with which main begins, or NULL where the word stands elsewhere too: a macro, a second
// main.
static const struct glsl_token *only_main(const struct glsl *code)
{
    const struct glsl_token *main = glsl_find_definition(code, "main");
    return main != NULL && glsl_mentions(code, "main") == 1 ? glsl_next(code, main + 1) : NULL;
}

// The outputs of a whole file begin at 0 too: where main begins, for they cannot have a value
// before. One that is declared behind it, or perhaps left out, stays as it is.
static void zero_outputs(struct edits *all)
{
    const struct glsl *code = all->code;
    const struct glsl_token *main = only_main(code);
    for (const struct glsl_token *t = code->statement; main != NULL && t < main; t++) {
        if (t->depth > 0 || !t->certain || !glsl_is(code, t, "out"))
            continue;
        do
            t++;
        while (glsl_is_precision(code, t));
        char text[VALUE_SIZE];
        if (is_type(code, t) && is_word(t + 1) && t[1].length < VALUE_SIZE / 2 &&
            glsl_is_sign(t + 2, ",;")) {
            snprintf(text, sizeof text, "%.*s=%.*s(0);", GLSL_TEXT(code, t + 1),
                     GLSL_TEXT(code, t));
            edit(all, main->begin + 1, 0, text);
        }
    }
}

// The words that the driver gets in other words.
static const struct {
    enum shader_form form;
    const char *word, *instead;
} replaced[] = {{SHADER_SHADERTOY, "gl_FragCoord", "harnessFragCoord"},
                {SHADER_SHADERTOY, "lowp", "highp"},
                {SHADER_SHADERTOY, "mediump", "highp"},
                {SHADER_WHOLE, "lowp", "highp"},
                {SHADER_WHOLE, "mediump", "highp"},
                {SHADER_WHOLE, "smooth", ""},
                {SHADER_WHOLE, "flat", ""},
                {SHADER_WHOLE, "noperspective", ""},
                {SHADER_WHOLE, "centroid", ""}};

static void replace_words(struct edits *all, enum shader_form form)
{
    const struct glsl *code = all->code;
    for (const struct glsl_token *t = code->item; t->kind != GLSL_END; t++) {
        if (t->kind != GLSL_WORD)
            continue;
        for (size_t i = 0; i < COUNT(replaced); i++)
            if (replaced[i].form == form && glsl_is(code, t, replaced[i].word))
                edit(all, t->begin, t->length, replaced[i].instead);
        const struct glsl_token *word =
            t->live && glsl_is(code, t, "mainImage") ? form_colour(t) : NULL;
        if (word != NULL && glsl_is(code, word, "out"))
            edit(all, word->begin, 0, "in");
    }
}

static int by_place(const void *a, const void *b)
{
    const struct edit *first = a, *second = b;
    int places = (first->begin > second->begin) - (first->begin < second->begin);
    return places != 0 ? places : first->number - second->number;
}

static char *apply(const struct edits *all)
{
    const char *text = all->code->text;
    char *result;
    FILE *stream = memory_open(&result);
    int from = 0;
    for (int i = 0; i < all->count; i++) {
        const struct edit *item = &all->item[i];
        fprintf(stream, "%.*s%s", item->begin - from, text + from, item->text);
        from = item->begin + item->length;
    }
    fputs(text + from, stream);
    memory_close(stream);
    return result;
}

// GLSL 1.10 has no values of arrays.
static bool has_array_values(const struct shader_source *source)
{
    const struct glsl_token *t = source->code.item;
    while (t->kind >= GLSL_COMMENT)
        t++;
    return !source->versioned || t->kind != GLSL_HASH || !glsl_is(&source->code, t + 2, "110");
}

char *form_zero(const struct shader_source *source)
{
    const struct glsl *code = &source->code;
    struct edits all = {.code = code,
                        .arrays = has_array_values(source),
                        .zero = memory_zeros((size_t)code->name_count, sizeof *all.zero)};
    zero_variables(&all);
    zero_outputs(&all);
    replace_words(&all, source->form);
    if (all.count > 0)
        qsort(all.item, (size_t)all.count, sizeof *all.item, by_place);
    char *result = apply(&all);
    for (int i = 0; i < code->name_count; i++)
        free(all.zero[i]);
    for (int i = 0; i < all.count; i++)
        free(all.item[i].text);
    free(all.zero);
    free(all.item);
    return result;
}
