// edits.h - edits to a GLSL text that keep its line numbers.
#ifndef DIALECTS_EDITS_H
#define DIALECTS_EDITS_H

#include "shader/glsl.h"

// Begin with a zero-initialised struct.
struct edits {
    struct edit *item; // owned
    int count;
    int size; // bytes inserted so far
};

// Replace a part of the text; several insertions at one position keep their order. The new text
// must have no line ends; the line ends in the replaced part are kept.
void edits_add(struct edits *edits, int begin, int length, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

// edits_replace replaces a token; edits_cut deletes everything from one token to another, including
// both.
void edits_replace(struct edits *edits, const struct glsl_token *token, const char *instead);
void edits_cut(struct edits *edits, const struct glsl_token *from, const struct glsl_token *to);

// Apply and free the edits. Returns the new text, which the caller frees.
char *edits_apply(struct edits *edits, const char *text);

void edits_free(struct edits *edits);

#endif
