// annotation.h - how the comment behind a uniform is read: for parameter_read.c and sampler.c
// alone.
#ifndef SHADER_ANNOTATION_H
#define SHADER_ANNOTATION_H

#include <stdbool.h>
#include <stddef.h>

#include "shader/source.h"

#define ANNOTATION_BLANKS " \t\v\f\r"
#define ANNOTATION_NAME   64 // letters of a name or a type, and their end

// A uniform and the comment behind it, on one line.
struct annotation {
    const char *what, *example; // for messages: "parameter", and how one is written
    const struct shader_source *source;
    int line;                                // of the text, from 0
    const struct glsl_token *type, *comment; // comment: NULL for none
    char name[ANNOTATION_NAME];
    char *words;   // of the comment, owned; "" for none
    const char *c; // what is left of them
};

// Read what stands in the line of a uniform; nothing is judged. A space that cannot break is a
// blank, as a French keyboard types it, but not in quotes, and a control character a question mark.
// Free words.
void annotation_begin(struct annotation *a, const struct shader_source *source,
                      const struct glsl_token *uniform);

// Read "uniform TYPE NAME;", alone in front of its comment. Returns false, reported.
bool annotation_declaration(struct annotation *a, const struct glsl_token *uniform);

// Report a malformed annotation; always false.
bool annotation_refuse(const struct annotation *a, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

// Pass over a character, or a whole word, and the blanks around it, if it is next.
bool annotation_accept(struct annotation *a, char c);
bool annotation_accept_word(struct annotation *a, const char *word);

// Copy the next bytes of the comment without the blanks around them. Returns false, reported: none,
// or too many.
//   part  what it is
bool annotation_copy(struct annotation *a, const char *part, char *to, size_t size, size_t length);

#endif
