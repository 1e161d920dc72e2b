// own.c - takes the place of the folder common/dialects/ in a program that runs only the course's
// own shaders. tests/command/dialects.sh tests this program.
#include "shader/dialects.h"

const struct dialects dialects = {0};
