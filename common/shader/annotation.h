// annotation.h - a uniform and the comment behind it, for the two kinds of annotation.
#ifndef SHADER_ANNOTATION_H
#define SHADER_ANNOTATION_H

#include "shader/parameter.h"

#define BLANKS " \t\v\f\r" // on a line

enum { ANNOTATION_NAME = 64 }; // size of a name or a type

// On one line.
struct annotation {
    const char *what, *example; // for messages: "parameter", and how one is written
    const struct shader_source *source;
    bool quiet;                                        // nothing is reported
    int line;                                          // of the text, from 0
    const struct glsl_token *uniform, *type, *comment; // comment: or NULL
    char name[ANNOTATION_NAME];
    char *words;   // of the comment, owned; "" for none
    const char *c; // the rest of them
    struct parameter parameter;
    struct sampler sampler;
};

// Begin with a uniform: find the comment in its line. A no-break space, which a French
// keyboard types, is a blank, but not in quotes; a control character becomes a question mark.
//   what, example  "parameter", and how one is written
// Free words.
void annotation_begin(struct annotation *a, const struct shader_source *source,
                      const struct glsl_token *uniform, const char *what, const char *example);

// Report a malformed annotation; always false.
bool annotation_refuse(const struct annotation *a, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

// Skip a character, or a whole word, and the blanks around it, if it is next.
bool annotation_accept(struct annotation *a, char c);
bool annotation_accept_word(struct annotation *a, const char *word);

// Copy the next bytes of the comment without the blanks around them. Returns false, reported: none,
// or too many.
//   part  what they are
bool annotation_copy(struct annotation *a, const char *part, char *to, size_t size, size_t length);

// Read "uniform TYPE NAME;", alone in front of its comment. Returns false, reported.
bool annotation_declaration(struct annotation *a);

// Read the samplers of a source: see parameters_read.
bool samplers_read(struct samplers *samplers, struct shader_source *source);

#endif
