// growth.h - how much a text grows in the driver, which expands its macros and copies each function
// to the positions of its calls.
#ifndef SHADER_GROWTH_H
#define SHADER_GROWTH_H

#include "shader/glsl.h"

// The largest number of tokens. Mesa takes up to 1 kB for each, and guard_memory allows it 4 GB.
#define GROWTH_LIMIT 4e6

// Estimate how many tokens there are when everything is expanded, and find the word that makes the
// number exceed GROWTH_LIMIT.
//   Of several definitions of a name, the longest counts. All parts inside an #if count. The body
//   of a loop counts once. The estimate is too low for a chain of more than 64 definitions, each
//   used before it is defined.
// Returns the word of a statement that expands to the largest part, or NULL if the estimate is
// within the limit.
const struct glsl_token *growth_find(const struct glsl *code);

#endif
