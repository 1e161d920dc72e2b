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

#include "shader/glsl_scan.h"

// Read a text. Time and memory grow with its length. Free with glsl_free.
void glsl_read(struct glsl *code, const char *text);

// Free the tokens; code may be all zeros.
void glsl_free(struct glsl *code);

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

#endif
