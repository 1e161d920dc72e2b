// export.h - a shader of this project as one file that runs on Shadertoy.
#ifndef EXPORT_H
#define EXPORT_H

#include "camera.h"
#include "shader/parameter.h"
#include "shader/source.h"

// Write a shader in Shadertoy's form.
//   parameters    of the source; each becomes a constant of its value
//   camera        becomes constants too: Shadertoy has none
//   focal_length  of a whole file, which has no parameters
// A course file loses what only views and probe need, its main becomes mainImage. A whole file's
// inputs and output become variables, which a mainImage fills in and hands on. One in Shadertoy's
// form stays as it is.
// Returns memory that the caller frees, or NULL, reported.
char *export_shadertoy(const struct shader_source *source, const struct parameters *parameters,
                       const struct camera *camera, float focal_length);

#endif
