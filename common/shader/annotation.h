// annotation.h - reads a uniform and the comment after it, for both kinds of annotation: parameters
// and samplers.
#ifndef SHADER_ANNOTATION_H
#define SHADER_ANNOTATION_H

#include "shader/parameter.h"

#define BLANKS " \t\v\f\r" // blanks within a line

enum { ANNOTATION_NAME = 64 }; // bytes of a name or a type, including the final '\0'

// An annotated uniform, on one line.
struct annotation {
    const char *what, *example; // for messages: "parameter" or "sampler", and an example of one
    const struct shader_source *source;
    bool quiet; // report no errors, and accept a default value
    int line;   // line of the text, from 0
    const struct glsl_token *uniform, *type, *comment; // comment is NULL if there is none
    char name[ANNOTATION_NAME];
    char *words;   // text of the comment, owned; "" if there is none
    const char *c; // the part of words that has not been read yet
    struct parameter parameter;
    struct sampler sampler;
};

// Begin to read a uniform's annotation: find the comment on the uniform's line. No-break spaces,
// which some French keyboard layouts produce, count as blanks except in quotes; a control character
// becomes a question mark.
//   what, example  as in struct annotation
// The caller frees a->words.
void annotation_begin(struct annotation *a, const struct shader_source *source,
                      const struct glsl_token *uniform, const char *what, const char *example);

// Report a malformed annotation, unless a->quiet is set. Always returns false.
bool annotation_refuse(const struct annotation *a, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

// Skip blanks. If the given character, or the given whole word, comes next, skip it and the blanks
// after it, and return true; otherwise return false.
bool annotation_accept(struct annotation *a, char c);
bool annotation_accept_word(struct annotation *a, const char *word);

// Copy the next length bytes of the comment, without the blanks around them. Returns false after
// reporting the error if only blanks remain, or if the copy does not fit into size bytes.
//   part  the name of this part, for messages
bool annotation_copy(struct annotation *a, const char *part, char *to, size_t size, size_t length);

// Read "uniform TYPE NAME;", which must be the only code on its line. If a->quiet is set, a default
// value may follow the name. Returns false after reporting the error.
bool annotation_declaration(struct annotation *a);

// Read the samplers of a source: see parameters_read.
bool samplers_read(struct samplers *samplers, struct shader_source *source);

#endif
