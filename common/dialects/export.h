// export.h - the export of a shader as one file that runs on Shadertoy or in a page.
#ifndef DIALECTS_EXPORT_H
#define DIALECTS_EXPORT_H

#include "camera.h"
#include "shader/parameter.h"
#include "shader/source.h"

// The member export_file of struct dialects.
char *export_file(struct shader_source *source, const struct parameters *parameters,
                  const struct camera *camera, float focal_length, bool page);

#endif
