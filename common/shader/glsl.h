// glsl.h - a GLSL text as a row of tokens, scanned once.
//
// There are two rows of tokens: those of the whole text, and those of its statements only, without
// comments, directives and anything that the preprocessor certainly skips (after #if 0, #ifdef,
// #ifndef, or #if with defined). Where only the driver can decide a condition (an expression, a
// name that begins with GL_ or __), every part counts. Both rows end in tokens of kind GLSL_END,
// and one more comes before the first statement, so a caller may look a few tokens ahead and one
// back.
#ifndef GLSL_H
#define GLSL_H

#include <stdbool.h>

enum glsl_kind {
    GLSL_END,
    GLSL_WORD,
    GLSL_NUMBER,
    GLSL_SIGN,     // any other single character
    GLSL_HASH,     // the # that begins a directive
    GLSL_COMMENT,  // from // to the end of the line, which a backslash continues
    GLSL_COMMENTED // from /* to */
};

struct glsl_token {
    unsigned char kind; // enum glsl_kind
    char sign;          // of a GLSL_SIGN, otherwise '\0'
    bool directive : 1; // inside a directive
    bool live : 1;      // not skipped by the preprocessor
    bool certain : 1;   // live, and inside no #if that only the driver can decide
    bool parted : 1;    // of a statement: a directive comes directly before it
    bool macro : 1;     // of a statement: a word that the text defines as a macro
    int begin, length;  // in the text, bytes
    int line;           // from 0
    int depth;          // number of brackets of any kind around it
    union {
        int name;    // of a word: its index among the names
        int partner; // of a bracket in a statement: the index of its partner, or of the end
    };
    const char *text; // of a word or a number; otherwise ""
    int item;         // of a statement: its index among all tokens
};

// What is known about a condition before the driver has seen it.
enum glsl_truth { GLSL_NEVER, GLSL_ALWAYS, GLSL_PERHAPS };

// A distinct word or number of the text.
struct glsl_name {
    char *text;
    int count;               // live mentions
    int last;                // index of its last mention among the statements, or -1
    bool macro;              // a live #define names it
    const char *word;        // of a macro that stands for one word: that word; otherwise NULL
    enum glsl_truth defined; // at the end of the text
};

struct glsl {
    char *text; // '\0' terminated
    int length, room;
    struct glsl_token *item, *statement;
    int count, statement_count; // without the tokens of kind GLSL_END
    struct glsl_name *name;
    int name_count;
    int *table; // of names, by hash
    int table_size;
    int lines; // line ends so far
    bool open; // the last comment is never closed
};

// A scan in progress; the text may come from several files.
struct glsl_reader {
    struct glsl *code;
    struct glsl_conditional *open; // the #ifs around the next token
    int open_count;
    int *bracket; // indices of the open brackets among the statements
    int depth, hash;
    bool live, certain, parted; // of the next token
    bool inside, word;          // it is in a directive; it is not the first token of its line
};

// Scan a text that may come from several files: call glsl_begin, glsl_take_line until each text is
// at its end, then glsl_end. Time and memory grow linearly with the text.
//   c  moves past the line and any lines that a comment or a backslash joins to it
void glsl_begin(struct glsl_reader *reader, struct glsl *code);
void glsl_take_line(struct glsl_reader *reader, const char **c);
void glsl_end(struct glsl_reader *reader);

// Add a line to the text as a comment, without tokens.
void glsl_take_comment(struct glsl_reader *reader, const char **c);

// Scan a text. Free with glsl_free, which also accepts a struct of zeros.
void glsl_read(struct glsl *code, const char *text);
void glsl_free(struct glsl *code);

// True for a letter, a digit or an underscore in ASCII, whatever the locale.
bool glsl_is_word(char c);

// True if the token is, respectively: one of these signs; this word, and not a macro of the text;
// one of these words, whose list ends in NULL; lowp, mediump or highp.
bool glsl_is_sign(const struct glsl_token *token, const char *signs);
bool glsl_is(const struct glsl_token *token, const char *word);
bool glsl_is_any(const struct glsl_token *token, const char *const words[]);
bool glsl_is_precision(const struct glsl_token *token);

// The number of components of a type of numbers, or of columns of a matrix; 0 for any other type.
// The size of an array may follow the type.
//   base  receives 'f', 'i', 'u' or 'b' for floats, integers, unsigned integers or truth values, or
//         'm' for a matrix
int glsl_type(const char *type, char *base);

// True as for glsl_is, or if the token is a macro that always stands for this one word.
bool glsl_means(const struct glsl *code, const struct glsl_token *token, const char *word);

// The next token that is not a comment, starting with this one.
const struct glsl_token *glsl_code(const struct glsl_token *token);

// Among the statements, respectively: the other bracket of a pair, or the end; the token after this
// one, or, if this one opens a bracket, after its partner; the first of these signs from a token
// on, outside any brackets that open there, or the end.
const struct glsl_token *glsl_partner(const struct glsl *code, const struct glsl_token *bracket);
const struct glsl_token *glsl_next(const struct glsl *code, const struct glsl_token *token);
const struct glsl_token *glsl_skip(const struct glsl *code, const struct glsl_token *token,
                                   const char *signs);

// The name of a word, or NULL if the text does not contain it; the number of its live mentions.
struct glsl_name *glsl_name(const struct glsl *code, const char *word);
int glsl_mentions(const struct glsl *code, const char *word);

// For a word, respectively: its first live mention in the text; its next mention among the
// statements after a token (NULL for the first mention); its mention as the name in a function's
// definition; its first call, which is neither a prototype nor a definition. NULL if there is none.
const struct glsl_token *glsl_find(const struct glsl *code, const char *word);
const struct glsl_token *glsl_find_next(const struct glsl *code, const struct glsl_token *after,
                                        const char *word);
const struct glsl_token *glsl_find_definition(const struct glsl *code, const char *word);
const struct glsl_token *glsl_find_call(const struct glsl *code, const char *word);

#endif
