// declared.h - reads all declarations: variables, inputs, outputs, uniforms and blocks.
#ifndef DIALECTS_DECLARED_H
#define DIALECTS_DECLARED_H

#include <stdbool.h>

#include "dialects/edits.h"
#include "shader/glsl.h"

enum declared_kind {
    DECLARED_NONE,
    DECLARED_VARIABLE, // global or local, but not a parameter or a member
    DECLARED_IN,
    DECLARED_OUT,
    DECLARED_UNIFORM,
    DECLARED_BLOCK // a block of inputs, outputs or uniforms
};

// A declared name, and the state of an iteration over all declared names. Begin with a
// zero-initialised struct in which only code is set.
struct declared {
    const struct glsl *code;
    enum declared_kind kind;
    const struct glsl_token *begin;               // the declaration's first token
    const struct glsl_token *layout;              // the word layout; NULL if there is none
    const struct glsl_token *type, *first, *name; // first is the first name of the declaration
    const struct glsl_token *value; // the = after the name and its size; NULL if there is none
    const struct glsl_token *end; // the token after all these, such as a comma; for a block, its {
    const char *storage;          // the storage qualifier that declared_store last wrote
    const char *word;             // the text of the name
};

// Move to the next declared name. Returns false at the end.
bool declared_next(struct declared *at);

// True if the name's layout gives it location 0.
bool declared_is_first(const struct declared *at);

// True if the name declares an array.
bool declared_is_array(const struct declared *at);

// True if the text mentions the name elsewhere, perhaps in a macro. For a block, this applies to
// its instance name or, if it has none, to its members.
bool declared_is_read(const struct declared *at);

// Declare the name with another storage qualifier, and without its layout and interpolation
// qualifiers. Call this for each name of a declaration, in order.
//   storage  such as "uniform"; "" for a variable
void declared_store(struct declared *at, struct edits *edits, const char *storage);

// The outputs of a file with its own main.
struct outputs {
    int count;
    struct declared shown;  // the output at location 0, or the first output
    struct declared second; // the first of the other outputs
    bool placed;            // an output is at location 0
};

// Find the outputs.
//   uncertain  also count outputs inside an #if that only the driver can decide
struct outputs declared_outputs(const struct glsl *code, bool uncertain);

// The output that is shown as the picture, in a file with its own main: the output at location 0
// or, if there is none, the first output. If any outputs are certain, only these count. The kind of
// the result is DECLARED_NONE if there is no output.
struct declared declared_output(const struct glsl *code);

// True if a word is declared or defined outside functions, or declared as a uniform in a macro.
bool declared_anywhere(const struct glsl *code, const char *word);

#endif
