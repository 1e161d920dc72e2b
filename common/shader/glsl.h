// glsl.h - the little of GLSL's grammar that the harness reads itself: comments and functions.
#ifndef GLSL_H
#define GLSL_H

#include <stdbool.h>
#include <stddef.h>

// Overwrite comments with blanks; line ends stay, so that lines and columns keep their numbers.
// A line comment whose last character is a backslash goes on in the next line, as drivers have it.
//   keep_line_comments  leave the comments that begin with // as they are
// Returns NULL, or the place of the first block comment that is never closed.
char *glsl_blank_comments(char *text, bool keep_line_comments);

// Overwrite with blanks what the preprocessor surely leaves out: between #if 0, #ifdef, #ifndef, or
// #if with defined, and #else, #elif or #endif. Where only the driver knows (an expression, a name
// of GL_ or __), everything stays. The directives themselves stay too.
//   code  a text without comments
void glsl_blank_inactive(char *code);

// True when no #if stands around a place: what is there is compiled, whatever the driver knows.
//   code  a text without comments
//   at    the place, letters from its beginning
bool glsl_is_certain(const char *code, size_t at);

// Overwrite with blanks the preprocessor's lines, and those that a backslash joins to them.
//   code  a text without comments
void glsl_blank_directives(char *code);

// True for a letter, a digit or an underscore of the basic alphabet, whatever the locale.
bool glsl_is_word(char c);

// What follows blanks and ends of lines.
const char *glsl_skip_blanks(const char *c);

// The letters of the word that stands at c; 0 where none does.
size_t glsl_word_length(const char *c);

// True when this whole word stands at c, which is no place inside another.
bool glsl_at_word(const char *c, const char *word);

// True when lowp, mediump or highp stands at c, which is no place inside a word.
bool glsl_at_precision(const char *c);

// The first place where word stands as a whole identifier, or NULL.
//   code  a text without comments
const char *glsl_find_word(const char *code, const char *word);

// The name in the definition of a function, or NULL; a prototype defines nothing.
const char *glsl_find_definition(const char *code, const char *name);

// The first call of a function of this name, or NULL; prototypes and definitions are no calls.
const char *glsl_find_call(const char *code, const char *name);

#endif
