// second.h - the second picture of --compare: another shader, or the same with other settings.
#ifndef SECOND_H
#define SECOND_H

#include <stdbool.h>

#include "platform.h"
#include "picture/pair.h"
#include "picture/renderer.h"

// What is asked for. Strings must outlive the second.
struct second_request {
    const char *file;       // its shader; NULL: that of the first
    const char *const *own; // NAME=VALUE: its own parameters
    int own_count;
    double divider;                       // share of the width that the first picture has, 0 to 1
    bool gripped;                         // it can be dragged
    const struct shader_request *reading; // that of the first: a texture or a channel that the
                                          // second has not is left out
};

// One of zeros is closed: there is no second picture.
struct second {
    char shader[PLATFORM_PATH];  // its file; "" where there is no second
    struct shader_source source; // of it, until the renderer takes it over
    struct parameters parameters;
    struct renderer renderer;
    struct pair pair;
};

// Read the second shader and its parameters.
//   shader  path of the first
//   root    the project's folder; must outlive the second
// Returns false, reported. Close with second_close, before the context.
bool second_read(struct second *second, const struct second_request *request, const char *shader,
                 const char *root);

// Give the parameters of the second the values that are its own.
// Returns false, reported: it has no such parameter or value.
bool second_assign(struct second *second);

// Compile it and put it beside the first, whose pair it becomes. Nothing where there is no second.
//   first  open, with the view set
// Returns false, reported.
bool second_load(struct second *second, struct renderer *first);

void second_close(struct second *second);

#endif
