// export.h - the export of a shader as one file that runs on Shadertoy.
#ifndef EXPORT_H
#define EXPORT_H

#include "camera.h"
#include "shader/parameter.h"
#include "shader/source.h"

// Write a shader in Shadertoy's dialect.
//   parameters    of the source; their current values become constants
//   camera        becomes constants too, because Shadertoy has no camera
//   focal_length  the value of the input for the focal length in dialects other than the course's
// A course file loses the parts that only the views and the probe need, and its main becomes
// mainImage. In a file in another dialect, the output, the parameters and the inputs that Shadertoy
// lacks become variables, which a new mainImage sets and reads; a file that needs none of this gets
// no new mainImage.
// Returns memory that the caller frees, or NULL after reporting the error.
char *export_shadertoy(struct shader_source *source, const struct parameters *parameters,
                       const struct camera *camera, float focal_length);

#endif
