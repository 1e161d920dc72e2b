// growth.h - how much a text grows in the driver, which expands its macros and copies each function
// to where it is called.
#ifndef SHADER_GROWTH_H
#define SHADER_GROWTH_H

#include "shader/glsl.h"

// Tokens. Mesa takes up to 1 kB for each, and guard_memory allows it 4 GB.
#define GROWTH_LIMIT 4e6

// Estimate how many tokens there are when everything is expanded, and find what makes them more
// than GROWTH_LIMIT.
//   Of several definitions of a name, the longest counts, and what is inside #if counts. Loops
//   count once. More than 64 definitions that are used before they are defined count too little.
// Returns the word of a statement that expands to the largest part, or NULL below the limit.
const struct glsl_token *growth_find(const struct glsl *code);

#endif
