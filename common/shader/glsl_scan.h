// glsl_scan.h - the tokens of a text: where each begins and ends.
#ifndef GLSL_SCAN_H
#define GLSL_SCAN_H

#include <stdbool.h>

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
    int last;                // its last mention among the statements; -1 for none
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

// True for a letter, a digit or an underscore of the basic alphabet, whatever the locale.
bool glsl_is_word(char c);

// True when the token is one of these signs.
bool glsl_is_sign(const struct glsl_token *token, const char *signs);

// Find the tokens and the names of a text; what counts is not told yet.
//   code  its text is there, and open is -1
void glsl_scan(struct glsl *code);

#endif
