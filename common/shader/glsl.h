// glsl.h - a GLSL text as tokens, scanned once.
//
// There are two rows of tokens: those of the whole text, and those of its statements only, without
// comments, directives and anything that the preprocessor certainly skips (after #if 0, #ifdef,
// #ifndef, or #if with defined). Where only the driver can decide a condition (an expression, a
// name that begins with GL_ or __), every branch counts. Both rows end in tokens of kind GLSL_END,
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
    char sign;          // the character of a GLSL_SIGN, otherwise '\0'
    bool directive : 1; // inside a directive
    bool live : 1;      // not skipped by the preprocessor
    bool certain : 1;   // live, and inside no #if that only the driver can decide
    bool parted : 1;    // among the statements: a directive comes directly before the token
    bool macro : 1;     // a word that is, or may be, defined as a macro at this place
    int begin, length;  // position in the text, in bytes
    int line;           // line of the text, from 0
    int depth;          // number of brackets of any kind around the token
    union {
        int name;    // of a word or a number: its index among the names
        int partner; // of a bracket among the statements: index of what glsl_partner returns
    };
    const char *text; // of a word or a number; otherwise ""
    int item;         // among the statements: the token's index among all tokens
};

// What is known about a condition before the driver has seen it.
enum glsl_truth { GLSL_NEVER, GLSL_ALWAYS, GLSL_PERHAPS };

// A distinct word or number of the text.
struct glsl_name {
    char *text;
    int count;        // number of live mentions
    int last;         // index of the last mention among the statements; -1 if there is none
    bool macro;       // a live #define defines the name
    const char *word; // the single word or number that a macro stands for; NULL for any other name
    enum glsl_truth defined; // whether the name is defined as a macro at the end of the text
};

struct glsl {
    char *text; // terminated by '\0'
    int length, room;
    struct glsl_token *item, *statement;
    int count, statement_count; // number of tokens without those of kind GLSL_END
    struct glsl_name *name;
    int name_count;
    int *table; // hash table of the names' indices
    int table_size;
    int lines; // number of line ends so far
    bool open; // the last comment is never closed
};

// A scan in progress; the text may come from several files.
struct glsl_reader {
    struct glsl *code;
    struct glsl_conditional *open; // the #ifs around the next token
    int open_count;
    int *bracket; // indices of the open brackets among the statements
    int depth, hash;
    bool live, certain, parted; // the values for the next token
    // inside: the next token is in a directive. word: a token other than a comment precedes it on
    // its line.
    bool inside, word;
};

// Scan a text that may come from several files: call glsl_begin, glsl_take_line until each text is
// at its end, then glsl_end. Time and memory grow linearly with the text.
//   c  moves past the line and any lines that a comment or a backslash joins to it
void glsl_begin(struct glsl_reader *reader, struct glsl *code);
void glsl_take_line(struct glsl_reader *reader, const char **c);
void glsl_end(struct glsl_reader *reader);

// Add a line to the text as a comment, without tokens.
void glsl_take_comment(struct glsl_reader *reader, const char **c);

// Scan a text. Free with glsl_free, which also accepts a zero-initialised struct.
void glsl_read(struct glsl *code, const char *text);
void glsl_free(struct glsl *code);

// True for a letter, a digit or an underscore in ASCII, whatever the locale.
bool glsl_is_word(char c);

// True if the token is one of these signs.
bool glsl_is_sign(const struct glsl_token *token, const char *signs);

// True if the token is this word, and the word is not a macro at this place.
bool glsl_is(const struct glsl_token *token, const char *word);

// True if glsl_is returns true for one of these words, whose list ends in NULL.
bool glsl_is_any(const struct glsl_token *token, const char *const words[]);

// True if the token is lowp, mediump or highp.
bool glsl_is_precision(const struct glsl_token *token);

// The number of components of a scalar or vector type, or of columns of a matrix type; 0 for any
// other type. The size of an array may follow the type.
//   base  receives 'f', 'i', 'u' or 'b' for floats, integers, unsigned integers or Booleans, or 'm'
//         for a matrix
int glsl_type(const char *type, char *base);

// True if glsl_is returns true, or if the token is a macro that always stands for this one word.
bool glsl_means(const struct glsl *code, const struct glsl_token *token, const char *word);

// The first token that is not a comment, starting with the given one.
const struct glsl_token *glsl_code(const struct glsl_token *token);

// The other bracket of a pair among the statements. A bracket without a partner gets the end if it
// opens, and itself if it closes.
const struct glsl_token *glsl_partner(const struct glsl *code, const struct glsl_token *bracket);

// The token after this one among the statements; if this one opens a bracket, the token after its
// partner.
const struct glsl_token *glsl_next(const struct glsl *code, const struct glsl_token *token);

// The first of these signs among the statements, starting with the given token and skipping the
// contents of brackets; the end if there is none.
const struct glsl_token *glsl_skip(const struct glsl *code, const struct glsl_token *token,
                                   const char *signs);

// The name of a word, or NULL if the text does not contain the word.
struct glsl_name *glsl_name(const struct glsl *code, const char *word);

// The number of live mentions of a word.
int glsl_mentions(const struct glsl *code, const char *word);

// The first live mention of a word in the text where the word is not a macro; NULL if there is
// none.
const struct glsl_token *glsl_find(const struct glsl *code, const char *word);

// The next mention of a word among the statements after a token, or the first mention if after is
// NULL; NULL if there is none.
const struct glsl_token *glsl_find_next(const struct glsl *code, const struct glsl_token *after,
                                        const char *word);

// The mention of a word, not of a macro, as the name in a function's definition; NULL if there is
// none.
const struct glsl_token *glsl_find_definition(const struct glsl *code, const char *word);

// The first call of a function of this name; a prototype or a definition is not a call. NULL if
// there is none.
const struct glsl_token *glsl_find_call(const struct glsl *code, const char *word);

#endif
