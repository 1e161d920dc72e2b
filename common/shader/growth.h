// growth.h - how much a text grows in the driver, which expands macros and inlines functions at
// their calls.
#ifndef SHADER_GROWTH_H
#define SHADER_GROWTH_H

#include "shader/glsl.h"

// The maximum number of tokens after expansion. Mesa takes up to 1 kB for each, and guard_memory
// allows the driver 4 GB.
#define GROWTH_LIMIT 4e6

// Find the code that grows too much: the body of a function, or code outside functions, that has
// more than GROWTH_LIMIT tokens after all macros and functions are expanded.
//   The number is an estimate. If a name has several definitions, the one that expands to the most
//   tokens counts. All branches of an #if that may be taken count. The body of a loop counts once.
//   The estimate is too low for a chain of more than 64 definitions, each used before it is
//   defined.
// Returns the word in this code that expands to the most tokens, or NULL if no code exceeds the
// limit. If the word is itself a function that exceeds the limit, the same applies to its body.
const struct glsl_token *growth_find(const struct glsl *code);

#endif
