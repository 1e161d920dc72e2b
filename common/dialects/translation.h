// translation.h - a translation in progress, shared by translate.c and its parts.
#ifndef DIALECTS_TRANSLATION_H
#define DIALECTS_TRANSLATION_H

#include <stdio.h>

#include "dialects/declared.h"
#include "shader/source.h"

#define COUNT(array) (sizeof(array) / sizeof *(array))

enum {
    MARK_OWN = 1, // the name has another meaning in the target, and gets the prefix own_
    MARK_LINE = 2 // the name of a sampler1D
};

struct translation {
    struct shader_source *source;
    const struct glsl *code;
    struct edits edits;
    bool toy;            // the source is in Shadertoy's dialect
    bool exported;       // the target is Shadertoy
    bool web;            // the target is WebGL, which includes Shadertoy
    bool old;            // gl_FragColor or gl_FragData is the output
    bool wraps;          // Shadertoy gets a new mainImage that calls the file's main or mainImage
    bool blocks;         // there is a block of inputs
    unsigned char *mark; // for each name: MARK_OWN, MARK_LINE, their sum or 0
    FILE *inputs;        // declarations of the inputs that the text reads but does not declare
    FILE *begin;         // statements at the beginning of main
    FILE *extensions;
};

// Check the declarations, rewrite them, and gather the inputs. Returns false after reporting the
// error.
bool translation_declarations(struct translation *t);

// Declare the inputs that the text reads but does not declare.
void translation_undeclared(struct translation *t);

// Rename words and remove directives and suffixes that the target lacks. For WebGL, initial values
// of global variables that are not constant expressions move to the beginning of main.
void translation_words(struct translation *t);

#endif
