#include "context/gl.h"

#include <stddef.h>

#include "report.h"

bool gl_load(struct gl *gl, gl_function (*find)(const char *name))
{
    const char *missing = NULL;
#define GL_LOAD(type, name)                                                                        \
    gl->name = (type)find("gl" #name);                                                             \
    if (gl->name == NULL && missing == NULL)                                                       \
        missing = "gl" #name;
    GL_FUNCTIONS(GL_LOAD)
#undef GL_LOAD
    if (missing != NULL)
        report("OpenGL: %s: the driver lacks this function: update the driver or try another "
               "--backend",
               missing);
    return missing == NULL;
}
