// directives.h - the directives of Shader Toy, an extension for VS Code: #iUniform becomes an
// annotated uniform; #iChannel0 names a picture next to its file, or tells what the channel
// contains in the author's tool; any other becomes a comment.
#ifndef DIALECTS_DIRECTIVES_H
#define DIALECTS_DIRECTIVES_H

#include "shader/source.h"

// The member obey of struct dialects.
bool directives_obey(struct shader_source *source, struct shader_line at, const char *word,
                     size_t length, char **instead, bool *done);

#endif
