#include "shader/growth.h"

#include <stdlib.h>

#include "memory.h"

// The longest chain of definitions used before they are defined, and the deepest nesting of
// arguments.
#define DEPTH_LIMIT 64

// A definition of a name: the tokens that replace it.
struct body {
    const struct glsl_token *from, *end;
    int name;
    int next;      // another definition of the same name; -1 if there is none
    bool function; // true for a function, false for a macro
};

struct growth {
    const struct glsl *code;
    struct body *body;
    int bodies;
    struct size {
        int body;      // index of the name's last definition; -1 if there is none
        int uses;      // of a macro: the largest number of mentions of one parameter
        int mentions;  // number of mentions in the macro being counted
        double tokens; // size of one mention's expansion, without arguments; 0 until known
    } * of;            // one for each name
};

static void add_body(struct growth *growth, struct body body)
{
    growth->body = memory_row(growth->body, growth->bodies, sizeof *growth->body);
    body.next = growth->of[body.name].body;
    growth->of[body.name].body = growth->bodies;
    growth->body[growth->bodies++] = body;
}

// Count how often a macro mentions each of its parameters. Returns the largest count.
//   close  the bracket after the parameters
static int most_mentions(struct growth *growth, const struct glsl_token *open,
                         const struct glsl_token *close, const struct glsl_token *end)
{
    int most = 0;
    for (const struct glsl_token *t = close; t < end; t++)
        if (t->kind == GLSL_WORD)
            growth->of[t->name].mentions++;
    for (const struct glsl_token *t = open; t < close; t++)
        if (t->kind == GLSL_WORD && growth->of[t->name].mentions > most)
            most = growth->of[t->name].mentions;
    for (const struct glsl_token *t = close; t < end; t++)
        if (t->kind == GLSL_WORD)
            growth->of[t->name].mentions = 0;
    return most;
}

// Add the macro whose definition begins with this #.
static void add_macro(struct growth *growth, const struct glsl_token *hash)
{
    const struct glsl_token *name = hash + 2, *from = name + 1, *end = from;
    while (end->directive && end->kind != GLSL_HASH)
        end++;
    if (from < end && from->sign == '(' && from->begin == name->begin + name->length) {
        const struct glsl_token *close = from;
        while (close < end && close->sign != ')')
            close++;
        int uses = most_mentions(growth, from, close, end);
        if (uses > growth->of[name->name].uses)
            growth->of[name->name].uses = uses;
        from = close;
    }
    add_body(growth, (struct body){.from = from, .end = end, .name = name->name});
}

// Find the definitions: first those of macros, then those of functions, each in the order of the
// text.
static void add_bodies(struct growth *growth)
{
    const struct glsl *code = growth->code;
    for (const struct glsl_token *t = code->item; t->kind != GLSL_END; t++)
        if (t->kind == GLSL_HASH && t->live && glsl_is(t + 1, "define") && t[2].kind == GLSL_WORD)
            add_macro(growth, t);
    for (const struct glsl_token *t = code->statement; t->kind != GLSL_END; t++)
        if (t->kind == GLSL_WORD && t[1].sign == '(') {
            const struct glsl_token *brace = glsl_next(code, t + 1);
            if (brace->sign == '{')
                add_body(growth,
                         (struct body){brace, glsl_partner(code, brace), t->name, -1, true});
        }
}

// The number of tokens that a part of the text expands to.
//   heaviest  receives the word that expands to the most tokens; may be NULL
static double tokens_of(struct growth *growth, const struct glsl_token *from,
                        const struct glsl_token *end, int depth,
                        const struct glsl_token **heaviest);

// The number of tokens that a mention of a name expands to.
static double tokens_of_name(struct growth *growth, int name, int depth)
{
    struct size *size = &growth->of[name];
    if (size->tokens > 0.0)
        return size->tokens;
    if (size->body < 0 || depth == 0)
        return 1.0;
    size->tokens = 1.0; // a mention of the name in its own definition is not expanded
    double most = 1.0;
    for (int i = size->body; i >= 0; i = growth->body[i].next) {
        const struct body *body = &growth->body[i];
        double tokens = tokens_of(growth, body->from, body->end, depth - 1, NULL);
        most = tokens > most ? tokens : most;
    }
    return size->tokens = most;
}

// The bracket that closes the arguments after a macro's name; NULL if there is no such bracket.
static const struct glsl_token *end_of_arguments(const struct glsl_token *name,
                                                 const struct glsl_token *end)
{
    int open = 0;
    for (const struct glsl_token *t = name + 1; t < end; t++) {
        open += (t->sign == '(') - (t->sign == ')');
        if (open <= 0)
            return t > name + 1 ? t : NULL;
    }
    return NULL;
}

static double tokens_of(struct growth *growth, const struct glsl_token *from,
                        const struct glsl_token *end, int depth, const struct glsl_token **heaviest)
{
    double all = 0.0, most = 0.0;
    bool closed = true; // the brackets of all arguments so far are closed
    for (const struct glsl_token *t = from; t < end; t++) {
        const struct glsl_token *word = t, *close = NULL;
        double tokens = t->kind < GLSL_HASH ? 1.0 : 0.0;
        if (t->kind == GLSL_WORD) {
            int uses = growth->of[t->name].uses;
            tokens = tokens_of_name(growth, t->name, depth);
            if (uses > 1 && depth > 0 && closed && t + 1 < end && t[1].sign == '(') {
                close = end_of_arguments(t, end);
                closed = close != NULL;
            }
            if (close != NULL) {
                tokens += uses * tokens_of(growth, t + 1, close, depth - 1, NULL);
                t = close;
            }
        }
        all += tokens;
        if (word->kind == GLSL_WORD && tokens > most) {
            most = tokens;
            if (heaviest != NULL)
                *heaviest = word;
        }
    }
    return all;
}

// The heaviest word in a function of this name whose expansion exceeds the limit. Returns NULL if
// there is no such function; a macro does not count.
static const struct glsl_token *heaviest_in(struct growth *growth, int name)
{
    for (int i = growth->of[name].body; i >= 0; i = growth->body[i].next) {
        const struct body *body = &growth->body[i];
        const struct glsl_token *heaviest = NULL;
        if (body->function &&
            tokens_of(growth, body->from, body->end, DEPTH_LIMIT, &heaviest) > GROWTH_LIMIT)
            return heaviest;
    }
    return NULL;
}

const struct glsl_token *growth_find(const struct glsl *code)
{
    struct growth growth = {.code = code, .body = memory_zeros(1, sizeof *growth.body)};
    const struct glsl_token *found = NULL, *within;
    growth.of = memory_zeros((size_t)code->name_count + 1, sizeof *growth.of);
    for (int i = 0; i < code->name_count; i++)
        growth.of[i].body = -1;
    add_bodies(&growth);
    for (int i = 0; i < growth.bodies && found == NULL; i++) {
        int name = growth.body[i].name;
        found = tokens_of_name(&growth, name, DEPTH_LIMIT) > GROWTH_LIMIT
                    ? heaviest_in(&growth, name)
                    : NULL;
    }
    // A constant defined outside functions may exceed the limit too.
    const struct glsl_token *from = code->statement, *end = from;
    while (end->kind != GLSL_END && found == NULL) {
        while (end->kind != GLSL_END && end->sign != '{')
            end++;
        within = NULL;
        if (tokens_of(&growth, from, end, DEPTH_LIMIT, &within) > GROWTH_LIMIT)
            found = within;
        from = end = end->kind != GLSL_END ? glsl_partner(code, end) : end;
    }
    // Instead of a function, report the heaviest word in it; if this word is again a function,
    // report the heaviest word in that, and so on. The number of steps is limited, because two
    // functions may call each other.
    for (int i = 0; found != NULL && i < DEPTH_LIMIT; i++) {
        within = heaviest_in(&growth, found->name);
        found = within != NULL ? within : found;
    }
    free(growth.body);
    free(growth.of);
    return found;
}
