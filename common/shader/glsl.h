// glsl.h - a GLSL text as a row of tokens, read once: everything in common/shader that looks into a
// shader walks over these.
//
// Two rows: one of everything, in the order of the text, and one of the statements alone: without
// comments, directives, and what the preprocessor surely leaves out (between #if 0, #ifdef,
// #ifndef, or #if with defined, and #else, #elif or #endif). Where only the driver knows a
// condition (an expression, a name of GL_ or __), everything counts. Both rows end in tokens of the
// kind GLSL_END, and the statements begin after one, so that a walk may look a few tokens ahead and
// one back.
#ifndef GLSL_H
#define GLSL_H

#include <stdbool.h>
#include <stddef.h>

enum glsl_kind {
    GLSL_END,
    GLSL_WORD,
    GLSL_NUMBER,
    GLSL_SIGN,     // one character that is nothing else
    GLSL_HASH,     // # where it begins a directive
    GLSL_COMMENT,  // to the end of its line, which a backslash moves on
    GLSL_COMMENTED // between /* and */
};

struct glsl_token {
    unsigned char kind; // enum glsl_kind
    char sign;          // of a GLSL_SIGN, else '\0'
    bool directive : 1; // stands in a directive
    bool live : 1;      // is not left out
    bool certain : 1;   // and stands in no #if that only the driver can decide
    bool parted : 1;    // of a statement: a directive stands before it
    bool macro : 1;     // of a statement: a word that the text defines as a macro
    int begin, length;  // in the text, bytes
    int line;           // from 0
    int depth;          // of brackets of every kind around it
    union {
        int name;    // of a word: among the names
        int partner; // of a bracket among the statements: the one that closes or opens it, or the
                     // end
    };
};

// What is known of a condition before the driver has seen it.
enum glsl_truth { GLSL_NEVER, GLSL_ALWAYS, GLSL_PERHAPS };

// A word, wherever it stands.
struct glsl_name {
    int begin, length;       // where it stands first
    int count;               // how often it is mentioned, what is left out aside
    int first, last;         // its first and last mention among the statements; -1 for none
    int definition;          // the GLSL_HASH of its first #define that counts; -1 for none
    enum glsl_truth defined; // at the end of the text
};

// What printf needs for "%.*s", the token's text.
#define GLSL_TEXT(code, token) (token)->length, (code)->text + (token)->begin

struct glsl {
    char *text; // a copy
    struct glsl_token *item, *statement;
    int count, statement_count; // without the ends
    struct glsl_name *name;
    int name_count;
    int *table; // of names, by hash
    int table_size;
    int open; // where a comment begins that is never closed; -1 for none
};

// Read a text. Time and memory grow with its length.
// Returns false, not reported, without memory. Free with glsl_free in either case.
bool glsl_read(struct glsl *code, const char *text);

// Free the tokens; code may be all zeros.
void glsl_free(struct glsl *code);

// True for a letter, a digit or an underscore of the basic alphabet, whatever the locale.
bool glsl_is_word(char c);

// True when the token is one of these signs.
bool glsl_is_sign(const struct glsl_token *token, const char *signs);

// True when the token is this word, and no macro of the text.
bool glsl_is(const struct glsl *code, const struct glsl_token *token, const char *word);

// As glsl_is, for the words of a list that ends in NULL.
bool glsl_is_any(const struct glsl *code, const struct glsl_token *token,
                 const char *const words[]);

// True for lowp, mediump and highp.
bool glsl_is_precision(const struct glsl *code, const struct glsl_token *token);

// The other bracket of a pair among the statements; the end for one that is never closed.
const struct glsl_token *glsl_partner(const struct glsl *code, const struct glsl_token *bracket);

// What follows a token of the statements, or, where this opens a bracket, the bracket's end.
const struct glsl_token *glsl_next(const struct glsl *code, const struct glsl_token *token);

// The first of these signs among the statements from a token on, outside of brackets that open
// there; or the end.
const struct glsl_token *glsl_skip(const struct glsl *code, const struct glsl_token *token,
                                   const char *signs);

// The name of a word, or NULL where the text has no such word.
struct glsl_name *glsl_name(const struct glsl *code, const char *word);

// How often the text mentions a word, what is left out aside.
int glsl_mentions(const struct glsl *code, const char *word);

// The first live mention of a word in the whole text, or NULL.
const struct glsl_token *glsl_find(const struct glsl *code, const char *word);

// The name in the definition of a function, or NULL; a prototype defines nothing.
const struct glsl_token *glsl_find_definition(const struct glsl *code, const char *word);

// The first call of a function, or NULL; prototypes and definitions are no calls.
const struct glsl_token *glsl_find_call(const struct glsl *code, const char *word);

// Make room in a row for one more than count: it is doubled whenever count is a power of two.
// Returns the row, or NULL without memory, when the old one stays.
void *glsl_grown(void *row, int count, size_t size);

#endif
