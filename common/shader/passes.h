// passes.h - a shader as Shadertoy exports it: JSON that contains the text of each pass.
#ifndef SHADER_PASSES_H
#define SHADER_PASSES_H

#include <stdbool.h>

struct passes {
    char *common, *image; // the texts of these two passes, owned
    char was[4][24];      // what the image pass reads in each channel: "texture", "buffer", ...
};

// True for a text that begins like JSON, as no shader does.
bool passes_are(const char *text);

// Read the passes. Returns NULL, or a phrase that says why there is no image pass. Free with
// passes_free in either case.
const char *passes_read(struct passes *passes, const char *text);

void passes_free(struct passes *passes);

#endif
